// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace sightline::detail {

void ProgressBar::begin(std::string phase) {
    const std::lock_guard lock(mutex_);
    phase_ = std::move(phase);
    fraction_ = 0;
    draw(0);
}

void ProgressBar::update(double fraction) {
    fraction_ = std::clamp(fraction, 0.0, 1.0);
    if (!is_visible_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || Clock::now() - drawn_ < std::chrono::milliseconds(100)) return;
    draw(fraction_);
}

void ProgressBar::draw(double fraction) {
    if (!is_visible_) return;
    constexpr int width = 30;
    const int full = static_cast<int>(fraction * width);
    fmt::print(stderr, "\r\033[K{} [{}{}] {} %", phase_, std::string(full, '#'),
               std::string(width - full, ' '), static_cast<int>(fraction * 100));
    std::fflush(stderr);
    drawn_ = Clock::now();
    is_drawn_ = true;
}

void ProgressBar::clear() {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(is_drawn_, false)) return;
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
}

std::string ProgressBar::phase() const {
    const std::lock_guard lock(mutex_);
    return phase_;
}

}  // namespace sightline::detail
