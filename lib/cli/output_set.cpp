// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output_set.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace sightline::detail {
namespace {

namespace fs = std::filesystem;

std::string shown(const std::string& path) { return path == "-" ? "standard output" : path; }

tl::unexpected<Error> cannot_write(const std::string& path, int problem,
                                   const char* advice = "check the disk") {
    // A stream may fail without a word from the system.
    const char* reason = problem == 0 ? "the write failed" : std::strerror(problem);
    return fail(Errc::cannot_write,
                fmt::format("{}: cannot be written ({}); {}", shown(path), reason, advice));
}

bool is_special(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// Where renaming must put the file: what a symbolic link points at, not the link.
fs::path resolved(const std::string& path) {
    std::error_code problem;
    const fs::path target = fs::canonical(path, problem);
    return problem ? fs::path(path) : target;
}

fs::path folder_of(const fs::path& path) {
    const fs::path folder = path.parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

Result<void> check_one(const std::string& path) {
    if (path == "-" || is_special(path)) return {};
    std::error_code ignored;
    if (path.empty() || fs::is_directory(path, ignored)) {
        return fail(Errc::cannot_write, fmt::format("{}: is a folder; give the name of a file",
                                                    path.empty() ? "(empty name)" : path));
    }
    const fs::path folder = folder_of(resolved(path));
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        return cannot_write(path, errno, "give a file in a folder that exists and can be written");
    }
    return {};
}

bool is_same_file(const std::string& a, const std::string& b) {
    std::error_code ignored;
    if (a == "-" || b == "-") return a == b;
    return fs::weakly_canonical(a, ignored) == fs::weakly_canonical(b, ignored);
}

}  // namespace

OutputSet::~OutputSet() {
    for (const Pending& file : pending_) ::unlink(file.temporary.path().c_str());
}

Result<void> OutputSet::check(std::span<const std::string> outputs,
                              std::span<const std::string> inputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (const Result<void> one = check_one(outputs[i]); !one) return one;
        if (is_special(outputs[i])) continue;
        for (std::size_t j = 0; j < i; ++j) {
            if (is_same_file(outputs[i], outputs[j])) {
                return fail(Errc::bad_parameter, shown(outputs[i]) +
                                                     ": would be written twice; give "
                                                     "each output a file of its own");
            }
        }
        for (const std::string& input : inputs) {
            if (input != "-" && is_same_file(outputs[i], input)) {
                return fail(Errc::bad_parameter,
                            outputs[i] + ": is read from; give the output another name");
            }
        }
    }
    return {};
}

OutputSet::Pending& OutputSet::prepare(const std::string& path) {
    const fs::path target = resolved(path);
    const fs::path name = fmt::format(".{}.{}-{}{}", target.stem().string(), ::getpid(),
                                      pending_.size(), target.extension().string());
    pending_.push_back({DoomedFile((folder_of(target) / name).string()), target.string()});
    return pending_.back();
}

Result<void> OutputSet::write(const std::string& path,
                              const std::function<void(std::ostream&)>& write,
                              const std::function<void(std::ostream&)>& patch) {
    errno = 0;
    if (path == "-") {
        write(std::cout);
        std::cout.flush();
        if (!std::cout) return cannot_write(path, errno);
        return {};
    }
    const bool direct = is_special(path);
    const std::string& name = direct ? path : prepare(path).temporary.path();
    std::ofstream out(name, std::ios::binary | std::ios::trunc);
    if (!out) return cannot_write(path, errno);
    write(out);
    if (patch && !direct && out) patch(out);
    out.close();
    if (!out) return cannot_write(path, errno);
    return {};
}

Result<void> OutputSet::write_named(const std::string& path,
                                    const std::function<Result<void>(const std::string&)>& write) {
    if (path == "-") return fail(Errc::bad_parameter, "pictures in PNG need a file; give a name");
    return write(is_special(path) ? path : prepare(path).temporary.path());
}

Result<void> OutputSet::commit() {
    begin_commit();
    while (!pending_.empty()) {
        const Pending& file = pending_.front();
        if (::rename(file.temporary.path().c_str(), file.target.c_str()) != 0) {
            return cannot_write(file.target, errno);
        }
        pending_.pop_front();
    }
    return {};
}

}  // namespace sightline::detail
