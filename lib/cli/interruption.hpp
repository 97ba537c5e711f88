// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/exit_status.hpp"

/// The end of the program at any moment: by a signal or by a limit. Half-written files are removed.
namespace sightline::detail {

/// From now on SIGINT and SIGTERM end the program at once with status 130, whatever it is doing,
/// and a broken pipe is an error of the write, not a signal.
void handle_interruptions();

/// A file that is removed if the program is ended while the object lives. At most 64 at a time.
class DoomedFile {
public:
    explicit DoomedFile(std::string path);
    DoomedFile(DoomedFile&& other) noexcept;
    DoomedFile(const DoomedFile&) = delete;
    DoomedFile& operator=(const DoomedFile&) = delete;
    DoomedFile& operator=(DoomedFile&&) = delete;
    ~DoomedFile();

    [[nodiscard]] const std::string& path() const noexcept { return path_; }

private:
    std::string path_;
    int slot_ = -1;
};

/// From now on the program is not ended any more: what it has written is about to be given its
/// name, several files as if at once, and after that it ends by itself.
void begin_commit();

/// Removes half-written files and ends the program, from any thread; `line` goes to standard error.
/// Returns only after begin_commit().
void end_program(ExitStatus status, const std::string& line);

}  // namespace sightline::detail
