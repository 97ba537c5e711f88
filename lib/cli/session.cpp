// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "cli/interruption.hpp"

namespace sightline::detail {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::uint64_t memory_in_use() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t all = 0;
    std::uint64_t resident = 0;
    statm >> all >> resident;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

bool shows_progress(const CommonOptions& common) {
    return !common.quiet && (common.progress || ::isatty(STDERR_FILENO) != 0);
}

}  // namespace

const char* name_of(Arithmetic arithmetic) noexcept {
    switch (arithmetic) {
        case Arithmetic::filtered:
            return "filtered";
        case Arithmetic::exact:
            return "exact";
        case Arithmetic::interval:
            return "interval";
        case Arithmetic::double_:
            return "double";
    }
    return "";
}

std::uint64_t peak_memory_bytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

Session::Session(const CommonOptions& common) : common_(common), progress_(shows_progress(common)) {
    if (common_.limit_seconds || common_.limit_memory) watcher_ = std::thread([this] { watch(); });
}

Session::~Session() {
    {
        const std::lock_guard lock(mutex_);
        is_done_ = true;
    }
    wake_.notify_all();
    if (watcher_.joinable()) watcher_.join();
}

void Session::watch() {
    std::unique_lock lock(mutex_);
    while (!is_done_) {
        if (common_.limit_memory && memory_in_use() > *common_.limit_memory) {
            return reached(fmt::format("more than {} MB of memory (--limit-memory)",
                                       *common_.limit_memory >> 20));
        }
        double wait = 0.02;
        if (common_.limit_seconds) {
            const double left = *common_.limit_seconds - seconds_since(start_);
            if (left <= 0) {
                return reached(
                    fmt::format("more than {} s (--limit-seconds)", *common_.limit_seconds));
            }
            wait = common_.limit_memory ? std::min(wait, left) : left;
        }
        wake_.wait_for(lock, std::chrono::duration<double>(wait));
    }
}

/// Work of which nothing will be kept need not be asked to stop.
void Session::reached(const std::string& what) {
    reached_ = what;
    is_over_ = true;
    if (keeps_) return;
    const std::string message =
        fmt::format("limit reached: {} while {}, {} % done; nothing is written; raise the limit",
                    reached_, progress_.phase(), static_cast<int>(progress_.fraction() * 100));
    progress_.clear();
    end_program(ExitStatus::no_answer, "sightline: " + message);
}

std::string Session::limit_message() const {
    const std::lock_guard lock(mutex_);
    return fmt::format("limit reached: {} while {}, {} % done", reached_, progress_.phase(),
                       static_cast<int>(progress_.fraction() * 100));
}

Limits Session::limits() {
    Limits limits;
    limits.stop = [this] { return is_over(); };
    limits.progress = [this](double fraction) { progress_.update(fraction); };
    return limits;
}

void Session::note(const std::string& line) {
    if (common_.quiet) return;
    progress_.clear();
    fmt::print(stderr, "{}\n", line);
}

Session::Part::Part(Session& session, std::string name, const std::string& doing)
    : session_(session), name_(std::move(name)) {
    session_.progress_.begin(doing);
}

Session::Part::~Part() {
    session_.progress_.clear();
    auto& all = session_.seconds_;
    auto known = std::find_if(all.begin(), all.end(), [&](auto& p) { return p.first == name_; });
    if (known == all.end()) known = all.insert(all.end(), {name_, 0.0});
    known->second += seconds_since(start_);
}

}  // namespace sightline::detail
