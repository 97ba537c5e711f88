// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

namespace sightline::detail {

/// A bar on standard error; nothing when it is not visible. Safe to call from any thread.
class ProgressBar {
public:
    explicit ProgressBar(bool is_visible) : is_visible_(is_visible) {}
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ~ProgressBar() { clear(); }

    /// Names what is done next, from 0 on.
    void begin(std::string phase);
    /// Draws at most ten times a second.
    void update(double fraction);
    /// Wipes the bar away, so that a line can be printed.
    void clear();

    [[nodiscard]] double fraction() const noexcept { return fraction_.load(); }
    /// "reading", "building the graph".
    [[nodiscard]] std::string phase() const;

private:
    void draw(double fraction);

    using Clock = std::chrono::steady_clock;
    const bool is_visible_;
    std::atomic<double> fraction_{0};
    mutable std::mutex mutex_;
    std::string phase_;
    Clock::time_point drawn_;
    bool is_drawn_ = false;
};

}  // namespace sightline::detail
