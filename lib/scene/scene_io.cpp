// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/scene_io.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>

#include "scene/text_cursor.hpp"
#include "sightline/scene/geojson.hpp"
#include "sightline/scene/text_format.hpp"
#include "sightline/scene/wkt.hpp"

namespace sightline {
namespace {

/// A file's bytes, mapped; or read, when it is no regular file.
class FileText {
public:
    static Result<FileText> open(const std::string& path) {
        FileText file;
        const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
        if (descriptor < 0) return failed(path, errno);
        const std::optional<int> problem = file.load(descriptor);
        ::close(descriptor);
        if (problem) return failed(path, *problem);
        return file;
    }

    FileText(FileText&& other) noexcept
        : mapped_(std::exchange(other.mapped_, nullptr)),
          size_(other.size_),
          owned_(std::move(other.owned_)) {}
    FileText(const FileText&) = delete;
    FileText& operator=(const FileText&) = delete;
    FileText& operator=(FileText&&) = delete;
    ~FileText() {
        if (mapped_ != nullptr) ::munmap(mapped_, size_);
    }

    [[nodiscard]] std::string_view text() const {
        return mapped_ != nullptr ? std::string_view(static_cast<const char*>(mapped_), size_)
                                  : owned_;
    }

    /// Gives back the memory of the part that has been read; it would be mapped again when needed.
    void release(double part) {
        constexpr std::size_t step = std::size_t{1} << 24;
        if (mapped_ == nullptr) return;
        const std::size_t end =
            static_cast<std::size_t>(part * static_cast<double>(size_)) / step * step;
        if (end <= released_) return;
        ::madvise(static_cast<char*>(mapped_) + released_, end - released_, MADV_DONTNEED);
        released_ = end;
    }

private:
    FileText() = default;

    static tl::unexpected<Error> failed(const std::string& path, int problem) {
        return fail(Errc::cannot_open, path + ": cannot be read (" + std::strerror(problem) +
                                           "); check the name and the permissions");
    }

    std::optional<int> load(int descriptor) {
        struct stat status{};
        if (::fstat(descriptor, &status) != 0) return errno;
        if (S_ISDIR(status.st_mode)) return EISDIR;
        if (S_ISREG(status.st_mode) && status.st_size > 0) {
            const auto size = static_cast<std::size_t>(status.st_size);
            void* mapping = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
            if (mapping != MAP_FAILED) {
                ::madvise(mapping, size, MADV_SEQUENTIAL);
                mapped_ = mapping;
                size_ = size;
                return std::nullopt;
            }
        }
        char buffer[1 << 16];
        for (;;) {
            const ssize_t n = ::read(descriptor, buffer, sizeof buffer);
            if (n == 0) return std::nullopt;
            if (n > 0) {
                owned_.append(buffer, static_cast<std::size_t>(n));
            } else if (errno != EINTR) {
                return errno;
            }
        }
    }

    void* mapped_ = nullptr;
    std::size_t size_ = 0;
    std::size_t released_ = 0;
    std::string owned_;
};

Result<SceneInput2> read_text_as(SceneFormat2 format, std::string_view text,
                                 const ReadOptions& options) {
    switch (format) {
        case SceneFormat2::wkt:
            return read_wkt(text, options);
        case SceneFormat2::geojson:
            return read_geojson(text, options);
        case SceneFormat2::text:
            break;
    }
    return read_text(text, options);
}

bool ends_with(std::string_view path, std::string_view ending) {
    if (path.size() < ending.size()) return false;
    path.remove_prefix(path.size() - ending.size());
    return std::equal(path.begin(), path.end(), ending.begin(), [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b;
    });
}

}  // namespace

SceneFormat2 scene_format(std::string_view path, std::string_view content) {
    if (ends_with(path, ".wkt")) return SceneFormat2::wkt;
    if (ends_with(path, ".geojson") || ends_with(path, ".json")) return SceneFormat2::geojson;
    if (ends_with(path, ".scene")) return SceneFormat2::text;
    const std::size_t first = content.find_first_not_of(" \t\r\n\f\v");
    if (first == std::string_view::npos) return SceneFormat2::text;
    if (content[first] == '{' || content[first] == '[') return SceneFormat2::geojson;
    // Our own words are in small letters, and no number directly follows a word of WKT.
    const std::string_view rest = content.substr(first);
    for (const std::string_view word : {"#", "world", "polygon", "hole", "wall", "point"}) {
        if (!rest.starts_with(word)) continue;
        const std::size_t next = rest.find_first_not_of(" \t", word.size());
        if (word == "#" || next == std::string_view::npos ||
            (rest[next] != '(' && rest[next] != 'e')) {
            return SceneFormat2::text;
        }
    }
    return SceneFormat2::wkt;
}

Result<SceneInput2> read_input(const std::string& path, const ReadOptions& options) {
    ReadOptions named = options;
    if (path == "-") {
        if (named.file.empty()) named.file = "standard input";
        const std::string text = detail::read_all(std::cin);
        return read_text_as(scene_format("", text), text, named);
    }
    if (named.file.empty()) named.file = path;
    Result<FileText> file = FileText::open(path);
    if (!file) return tl::unexpected(file.error());
    named.progress = [&](double part) {
        file->release(part);
        if (options.progress) options.progress(part);
    };
    return read_text_as(scene_format(path, file->text()), file->text(), named);
}

Result<Scene2> read_scene(const std::string& path, const ReadOptions& options) {
    const Result<SceneInput2> input = read_input(path, options);
    if (!input) return tl::unexpected(input.error());
    return Scene2::make(*input);
}

void write_input(std::ostream& out, const SceneInput2& input, SceneFormat2 format) {
    switch (format) {
        case SceneFormat2::wkt:
            return write_wkt(out, input);
        case SceneFormat2::geojson:
            return write_geojson(out, input);
        case SceneFormat2::text:
            break;
    }
    write_text(out, input);
}

}  // namespace sightline
