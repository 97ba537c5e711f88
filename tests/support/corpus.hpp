// SPDX-License-Identifier: GPL-3.0-or-later
// The named scenes of tests/corpus.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "support/scenes.hpp"

namespace sightline::testing {

using Corpus = std::map<std::string, std::string>;  // text of each scene by name

/// Reads a corpus file: lines `scene NAME`, each followed by the lines of that scene.
inline Corpus read_corpus(const std::string& file) {
    std::ifstream in(std::string(SIGHTLINE_TESTS_DIR "/corpus/") + file);
    if (!in) throw std::runtime_error("cannot read corpus " + file);
    Corpus corpus;
    std::string* current = nullptr;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string word;
        std::string name;
        words >> word;
        if (word == "scene" && words >> name) {
            const auto [entry, is_new] = corpus.emplace(name, std::string());
            if (!is_new) throw std::runtime_error("scene " + name + " twice in " + file);
            current = &entry->second;
        } else if (!word.empty() && word[0] != '#') {
            if (current == nullptr) throw std::runtime_error("no scene begun in " + file);
            *current += line + "\n";
        }
    }
    return corpus;
}

/// All degenerate 2D scenes, by name.
inline const Corpus& degenerate_scenes() {
    static const Corpus corpus = read_corpus("degenerate2.txt");
    return corpus;
}

/// One of them.
inline Scene2 degenerate_scene(const std::string& name) {
    return scene2(degenerate_scenes().at(name));
}

}  // namespace sightline::testing
