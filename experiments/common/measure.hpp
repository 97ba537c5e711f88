// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/// What the experiments measure with. Processor time is what counts: it hardly depends on what else the
/// machine does; elapsed time is for what runs on several threads.
namespace sightline::experiments {

/// Processor time of the calling thread.
[[nodiscard]] double thread_seconds();
/// Processor time of all threads of the process.
[[nodiscard]] double process_seconds();
/// Elapsed time.
[[nodiscard]] double wall_seconds();

/// The largest resident set of the process so far.
[[nodiscard]] std::size_t peak_memory_bytes();
/// The resident set now.
[[nodiscard]] std::size_t memory_bytes();

/// What f allocates at its peak: run in a child process, whose peak is its own. To be called while the process
/// has a single thread, or for functions that use no other.
[[nodiscard]] std::size_t peak_growth_bytes(const std::function<void()>& f);

/// Commit, compiler, processor and load, one `# key: value` line each: the head of every result file.
[[nodiscard]] std::string provenance();

struct Timing {
    double thread = 0;   ///< processor seconds of the calling thread, median
    double process = 0;  ///< of all threads, median
    double wall = 0;     ///< elapsed, median
    std::size_t runs = 0;
};

[[nodiscard]] inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

struct Effort {
    std::size_t least_runs = 3;
    double least_seconds = 0.3;  ///< of processor time, all runs together
    std::size_t most_runs = 200;
};

/// The median run of f.
template <typename Function>
[[nodiscard]] Timing measure(Function&& f, const Effort& effort = {}) {
    std::vector<double> thread;
    std::vector<double> process;
    std::vector<double> wall;
    double spent = 0;
    while (thread.size() < effort.most_runs &&
           (thread.size() < effort.least_runs || spent < effort.least_seconds)) {
        const double t = thread_seconds();
        const double p = process_seconds();
        const double w = wall_seconds();
        f();
        thread.push_back(thread_seconds() - t);
        process.push_back(process_seconds() - p);
        wall.push_back(wall_seconds() - w);
        spent += process.back();
    }
    const std::size_t runs = thread.size();
    return {median(std::move(thread)), median(std::move(process)), median(std::move(wall)), runs};
}

}  // namespace sightline::experiments
