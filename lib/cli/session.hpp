// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/exit_status.hpp"
#include "cli/progress.hpp"
#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/tally.hpp"

namespace sightline::detail {

/// What every command understands.
struct CommonOptions {
    Arithmetic arithmetic = Arithmetic::filtered;
    unsigned threads = 0;  ///< 0: one a core
    std::optional<double> limit_seconds;
    std::optional<std::uint64_t> limit_memory;  ///< bytes
    bool quiet = false;
    bool progress = false;  ///< even when standard error is no terminal
    bool partial = false;   ///< keep what a limit leaves
};

/// "filtered", "exact", "interval", "double".
[[nodiscard]] const char* name_of(Arithmetic arithmetic) noexcept;

/// One run of one command: its clock, its counts, its limits, and its voice on standard error.
class Session {
public:
    /// Starts the clock that `limit_seconds` means.
    explicit Session(const CommonOptions& common);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session();

    [[nodiscard]] const CommonOptions& common() const noexcept { return common_; }
    [[nodiscard]] Tally& tally() noexcept { return tally_; }
    [[nodiscard]] const Tally& tally() const noexcept { return tally_; }
    [[nodiscard]] ProgressBar& progress() noexcept { return progress_; }

    /// Runs one part of the work; its time goes to `stats.seconds[name]`, times of one name add
    /// up. `doing` is shown meanwhile.
    template <typename Work>
    decltype(auto) timed(const std::string& name, const std::string& doing, Work&& work) {
        const Part part(*this, name, doing);
        return std::forward<Work>(work)();
    }
    /// Seconds by part, in the order in which the parts began.
    [[nodiscard]] const std::vector<std::pair<std::string, double>>& seconds() const noexcept {
        return seconds_;
    }

    /// For algorithms: stops with the time, reports progress. The errors that they end with then
    /// are put right by `explain`.
    [[nodiscard]] Limits limits();
    /// From now on there is something that --partial may keep: a limit asks the work to stop instead
    /// of ending the program.
    void keep_from_now_on() noexcept { keeps_ = common_.partial; }
    /// Whether the time is over and the work should end, keeping what there is.
    [[nodiscard]] bool is_over() const noexcept { return is_over_.load(); }
    /// What a limit that was reached says, with what was done so far.
    [[nodiscard]] std::string limit_message() const;

    /// One line on standard error, unless --quiet.
    void note(const std::string& line);

private:
    class Part {
    public:
        Part(Session& session, std::string name, const std::string& doing);
        Part(const Part&) = delete;
        Part& operator=(const Part&) = delete;
        ~Part();

    private:
        Session& session_;
        std::string name_;
        std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    };
    void watch();
    void reached(const std::string& what);

    CommonOptions common_;
    Tally tally_;
    ProgressBar progress_;
    std::vector<std::pair<std::string, double>> seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

    std::atomic<bool> is_over_{false};
    std::atomic<bool> keeps_{false};
    std::string reached_;
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    bool is_done_ = false;
    std::thread watcher_;
};

/// The most memory that the program has used so far.
[[nodiscard]] std::uint64_t peak_memory_bytes();

}  // namespace sightline::detail
