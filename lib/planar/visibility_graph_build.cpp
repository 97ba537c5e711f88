// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

#include "planar/graph_assembly.hpp"
#include "planar/graph_rows.hpp"
#include "sightline/planar/visibility_graph.hpp"

namespace sightline {
namespace detail {
namespace {

// One build: half rows of blocks of places, block by block or in parallel, watched by the limits.
class GraphBuild {
public:
    GraphBuild(const Triangulation& t, const VisibilityGraphOptions& options, const Limits& limits)
        : t_(t), options_(options), limits_(limits), crossings_(t, options.threads) {
        if (options.tangent_only) corners_.emplace(t);
        const Place places = t.first_constructed() - frame_places;
        // Small enough to share out evenly, large enough to be no burden.
        block_ = std::clamp<Place>(places / (64 * std::max(1U, options.threads)), 16, 1024);
        rows_.resize((places + block_ - 1) / block_);
    }

    void run() {
        if (options_.threads <= 1) {
            Worker worker(*this);
            for (std::size_t i = 0; i < rows_.size() && !stopped_; ++i) fill(i, worker);
            finish(worker);
            return;
        }
        tbb::enumerable_thread_specific<std::unique_ptr<Worker>> workers;
        tbb::parallel_for(std::size_t{0}, rows_.size(), [&](std::size_t i) {
            if (stopped_) return;
            auto& worker = workers.local();
            if (!worker) worker = std::make_unique<Worker>(*this);
            fill(i, *worker);
        });
        for (auto& worker : workers) finish(*worker);
    }

    [[nodiscard]] std::optional<Error> error() const { return error_; }
    [[nodiscard]] std::vector<HalfRows> take() { return std::move(rows_); }

private:
    [[nodiscard]] const Corners* corners() const { return corners_ ? &*corners_ : nullptr; }

    // A thread's rows, and the storage in which it collects a block before it is kept at its size.
    struct Worker {
        explicit Worker(const GraphBuild& b) : rows(b.t_, b.crossings_, b.corners(), b.options_) {}

        GraphRows rows;
        std::vector<Place> found;
    };

    void fill(std::size_t i, Worker& worker) {
        HalfRows& rows = rows_[i];
        rows.first = frame_places + static_cast<Place>(i) * block_;
        const Place end = std::min(rows.first + block_, t_.first_constructed());
        rows.ends.reserve(end - rows.first);
        for (Place p = rows.first; p < end; ++p) {
            worker.rows.append(p, worker.found);
            rows.ends.push_back(worker.found.size());
        }
        rows.places.assign(worker.found.begin(), worker.found.end());
        worker.found.clear();
        report(rows.places.size());
    }

    void report(std::size_t found) {
        const std::scoped_lock lock(mutex_);
        edges_ += found;
        ++done_;
        if (error_) return;
        const auto progress = std::to_string(done_) + " of " + std::to_string(rows_.size()) +
                              " blocks of rows done, " + std::to_string(edges_) + " edges found";
        if (edges_ > limits_.max_elements)
            error_ = Error{Errc::limit_reached, "the graph has more than " +
                                                    std::to_string(limits_.max_elements) +
                                                    " edges (" + progress + "); raise the limit"};
        else if (limits_.stop && limits_.stop())
            error_ = Error{Errc::cancelled, "stopped: " + progress};
        else if (limits_.progress)
            limits_.progress(static_cast<double>(done_) / static_cast<double>(rows_.size()));
        stopped_ = error_.has_value();
    }

    void finish(const Worker& worker) {
        if (options_.tally != nullptr) worker.rows.add_to(*options_.tally);
    }

    const Triangulation& t_;
    const VisibilityGraphOptions& options_;
    const Limits& limits_;
    Crossings crossings_;
    std::optional<Corners> corners_;
    Place block_ = 1;
    std::vector<HalfRows> rows_;
    std::mutex mutex_;
    std::size_t edges_ = 0;
    std::size_t done_ = 0;
    std::optional<Error> error_;
    std::atomic<bool> stopped_ = false;
};

Result<VisibilityGraph> build_graph(const Scene2& scene, const VisibilityGraphOptions& options,
                                    const Limits& limits) {
    const Triangulation t(scene, {}, options.threads);
    std::vector<HalfRows> rows;
    {
        GraphBuild build(t, options, limits);
        build.run();
        if (auto error = build.error()) return tl::unexpected<Error>(*error);
        rows = build.take();
    }
    return assemble(t, std::move(rows), options.threads);
}

}  // namespace
}  // namespace detail

Result<VisibilityGraph> visibility_graph(const Scene2& scene, const VisibilityGraphOptions& options,
                                         const Limits& limits) {
    VisibilityGraphOptions chosen = options;
    if (chosen.threads == 0)
        chosen.threads =
            static_cast<unsigned>(std::max(1, tbb::this_task_arena::max_concurrency()));
    if (chosen.threads == 1) return detail::build_graph(scene, chosen, limits);
    tbb::task_arena arena(static_cast<int>(chosen.threads));
    return arena.execute([&] { return detail::build_graph(scene, chosen, limits); });
}

VisibilityGraph visibility_graph(const Scene2& scene, const VisibilityGraphOptions& options) {
    return *visibility_graph(scene, options, Limits{});
}

}  // namespace sightline
