// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Files as text. Private.

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "sightline/scene/result.hpp"

namespace sightline::detail {

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
        struct stat status {};
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

}  // namespace sightline::detail
