// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <list>
#include <span>
#include <string>

#include "cli/interruption.hpp"
#include "sightline/scene/result.hpp"

namespace sightline::detail {

/// The files that a command writes: all of them complete, or none. Each is written under another
/// name in the same folder; `commit` renames them. "-" is standard output; what exists and is no
/// regular file (a pipe, /dev/null) is written to directly.
class OutputSet {
public:
    OutputSet() = default;
    OutputSet(const OutputSet&) = delete;
    OutputSet& operator=(const OutputSet&) = delete;
    /// Removes what was not committed.
    ~OutputSet();

    /// Before the work: whether the files can be written, are different, and are none of the
    /// inputs.
    [[nodiscard]] static Result<void> check(std::span<const std::string> outputs,
                                            std::span<const std::string> inputs);

    /// Gives `write` a stream. `patch`, when there is one, gets a stream that can be positioned,
    /// after everything is written, unless the output is a pipe or the like.
    [[nodiscard]] Result<void> write(const std::string& path,
                                     const std::function<void(std::ostream&)>& write,
                                     const std::function<void(std::ostream&)>& patch = {});
    /// For what insists on a name; it gets one with the same extension.
    [[nodiscard]] Result<void> write_named(
        const std::string& path, const std::function<Result<void>(const std::string&)>& write);

    [[nodiscard]] Result<void> commit();

private:
    struct Pending {
        DoomedFile temporary;
        std::string target;
    };
    Pending& prepare(const std::string& path);

    std::list<Pending> pending_;
};

}  // namespace sightline::detail
