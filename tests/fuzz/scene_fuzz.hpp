// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "sightline/scene/scene_io.hpp"

namespace sightline::fuzz {

[[noreturn]] inline void complain(const char* what, const std::string& text) {
    std::fprintf(stderr, "%s\n%s\n", what, text.c_str());
    std::abort();
}

inline void check_error(const Error& error) {
    if (error.message.empty()) complain("an error without a message", "");
    if (error.message.find('\n') != std::string::npos)
        complain("a message of several lines", error.message);
}

/// Whatever the bytes: reading ends in an error of one line, or in elements that make a scene or not; a
/// scene, written and read again, is the same scene.
template <typename Read>
int read_make_write_read(std::string_view text, SceneFormat2 format, const Read& read) {
    const bool world = !text.empty() && text.back() == '\n';
    const Result<SceneInput2> input = read(text, ReadOptions{.world = world});
    if (!input) {
        check_error(input.error());
        return 0;
    }
    const Result<Scene2> scene = Scene2::make(*input);
    if (!scene) {
        check_error(scene.error());
        return 0;
    }
    std::ostringstream out;
    write_input(out, to_input(*scene), format);
    const Result<SceneInput2> again = read(out.str(), ReadOptions{.world = scene->has_world()});
    if (!again) complain(again.error().message.c_str(), out.str());
    const Result<Scene2> same = Scene2::make(*again);
    if (!same) complain(same.error().message.c_str(), out.str());
    if (*same != *scene) complain("another scene was read back", out.str());
    return 0;
}

}  // namespace sightline::fuzz
