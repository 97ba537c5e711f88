// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/skeleton/build.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

#include "sightline/spatial/shaft.hpp"
#include "skeleton/seeds.hpp"
#include "skeleton/store.hpp"

namespace sightline {

namespace {

using namespace detail;

/// Asks, now and then and from one thread at a time, whether to go on.
class Supervisor {
public:
    explicit Supervisor(const Limits& limits) : limits_(limits) {}

    /// Whether the work goes on; `elements` are stored already.
    bool goes_on(std::size_t elements) {
        if (is_over()) return false;
        if (elements > limits_.max_elements) {
            end(Errc::limit_reached, "the visibility skeleton has more than " +
                                         std::to_string(limits_.max_elements) +
                                         " nodes and arcs: raise the limit or ask for a part");
            return false;
        }
        if (limits_.stop) {
            const std::scoped_lock lock(mutex_);
            if (!is_over() && limits_.stop()) {
                error_ = Error{Errc::cancelled,
                               "stopped while the visibility skeleton was built, "
                               "after " +
                                   std::to_string(elements) + " nodes and arcs"};
                over_ = true;
            }
        }
        return !is_over();
    }
    void report(double share) {
        if (!limits_.progress) return;
        const std::scoped_lock lock(mutex_);
        limits_.progress(share);
    }
    [[nodiscard]] bool is_over() const { return over_; }
    [[nodiscard]] const Error& error() const { return error_; }

private:
    void end(Errc code, std::string message) {
        const std::scoped_lock lock(mutex_);
        if (!over_) error_ = Error{code, std::move(message)};
        over_ = true;
    }

    const Limits& limits_;
    std::mutex mutex_;
    std::atomic<bool> over_ = false;
    Error error_;
};

/// Which generators a part of the skeleton may have.
class Selection {
public:
    Selection(const SceneForms& forms, const SkeletonPart& part) : forms_(forms), part_(part) {
        if (!part.between) return;
        in_shaft_.assign(forms.edge_count(), false);
        const Shaft shaft(Convex3(box_of((*part.between)[0])), Convex3(box_of((*part.between)[1])));
        for (std::uint32_t e = 0; e < forms.edge_count(); ++e) {
            const Edge3& edge = forms.scene().edges()[e];
            const std::array ends{forms.scene()[edge.source], forms.scene()[edge.target]};
            in_shaft_[e] = shaft.may_meet(ends);
            if (in_shaft_[e]) edges_.push_back(EdgeId{e});
        }
    }

    [[nodiscard]] bool is_by_pair() const { return part_.between.has_value(); }
    [[nodiscard]] std::span<const EdgeId> edges() const { return edges_; }
    [[nodiscard]] bool has(EdgeId e) const { return in_shaft_.empty() || in_shaft_[e.index()]; }
    [[nodiscard]] bool has(VertexId v) const {
        return in_shaft_.empty() ||
               std::ranges::any_of(forms_.scene().edges_at(v), [&](EdgeId e) { return has(e); });
    }
    [[nodiscard]] bool wants_pencil(EdgeId e) const {
        return has(e) && (!part_.edge || *part_.edge == e);
    }
    [[nodiscard]] bool wants(const EdgeTriple& t) const {
        if (part_.edge && std::ranges::find(t, *part_.edge) == t.end()) return false;
        return std::ranges::all_of(t, [&](EdgeId e) { return has(e); });
    }
    [[nodiscard]] bool wants(const SegmentLabel& label) const {
        if (part_.edge &&
            std::ranges::find(label.support.edges, *part_.edge) == label.support.edges.end()) {
            return false;
        }
        if (!part_.between) return true;
        const auto ends_at = [&](std::size_t end, FaceId f) {
            return std::ranges::any_of(label.ends[end],
                                       [&](const FaceSide& side) { return side.face == f; });
        };
        const auto [f, g] = *part_.between;
        return (ends_at(0, f) && ends_at(1, g)) || (ends_at(0, g) && ends_at(1, f));
    }

private:
    [[nodiscard]] Box3 box_of(FaceId f) const {
        Box3 box;
        for (const auto& ring : forms_.scene()[f].rings) {
            for (const VertexId v : ring) box.include(forms_.scene()[v]);
        }
        return box;
    }

    const SceneForms& forms_;
    const SkeletonPart& part_;
    std::vector<bool> in_shaft_;
    std::vector<EdgeId> edges_;
};

/// What the threads share.
struct Shared {
    Shared(const Scene3& scene, const SkeletonOptions& build_options, const Limits& limits)
        : forms(scene),
          options(build_options),
          supervisor(limits),
          selection(forms, options.part) {}

    SceneForms forms;
    const SkeletonOptions& options;
    Supervisor supervisor;
    Selection selection;
    NodeStore nodes;
    TripleStore visited;
    std::atomic<std::size_t> arc_count = 0;
};

class Worker {
public:
    explicit Worker(Shared& shared)
        : shared_(shared),
          policy_{shared.options.arithmetic, shared.options.tally == nullptr ? nullptr : &tally_},
          sight_(shared.forms, policy_),
          sweep_(shared.forms, policy_, output()) {}
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void sweep_pencils(VertexId v) {
        const SceneForms& forms = shared_.forms;
        if (!forms.scene().is_feature(v) || !shared_.selection.has(v)) return;
        for (const EdgeId e : sight_.edges_from(v)) {
            if (!shared_.selection.wants_pencil(e)) continue;
            if (!goes_on()) return;
            if (const auto curve = Curve::pencil(forms, policy_, v, e)) sweep_.run(*curve);
        }
    }
    void sweep_crossing(EdgeId a, EdgeId b) {
        for (std::uint32_t e = 0; e < shared_.forms.edge_count(); ++e) {
            if (!goes_on()) return;
            const auto curve = Curve::contact_pencil(shared_.forms, policy_, a, b, EdgeId{e});
            if (curve) sweep_.run(*curve);
        }
    }
    /// Lines in a plane where solids are pressed on each other, through edge a of it.
    void sweep_contact_plane(const SceneForms::ContactPlane& plane, EdgeId a) {
        for (std::uint32_t c = 0; c < shared_.forms.edge_count(); ++c) {
            if (!goes_on()) return;
            const auto curve =
                Curve::in_face(shared_.forms, policy_, plane.faces.front(), a, EdgeId{c});
            if (curve) sweep_.run(*curve);
        }
    }
    /// Lines in such a plane that end at a vertex or crossing on the border of the contact.
    void sweep_contact_border(const SceneForms::ContactPlane& plane) {
        const SceneForms& forms = shared_.forms;
        const auto is_in_plane = [&](EdgeId e) {
            return std::ranges::binary_search(plane.edges, e);
        };
        const auto sweep = [&](const std::array<Curve, 2>& halves) {
            for (const Curve& half : halves) {
                if (goes_on()) sweep_.run(half);
            }
        };
        for (const auto& [a, b] : forms.crossings()) {
            if (!is_in_plane(a) || !is_in_plane(b)) continue;
            sweep(Curve::on_border(forms, policy_, plane.faces.front(), {a, b}));
        }
        std::map<VertexId, std::vector<EdgeId>> edges_at;
        for (const EdgeId e : plane.edges) {
            edges_at[forms.scene()[e].source].push_back(e);
            edges_at[forms.scene()[e].target].push_back(e);
        }
        for (const auto& [v, edges] : edges_at) {
            const auto other = std::ranges::find_if(edges, [&, &around = edges](EdgeId e) {
                return !forms.are_parallel(around[0], e);
            });
            if (other == edges.end()) continue;
            sweep(Curve::on_border(forms, policy_, plane.faces.front(), v, {edges[0], *other}));
        }
    }
    void sweep_swath(const EdgeTriple& edges) {
        if (!goes_on()) return;
        if (const auto curve = Curve::through_edges(shared_.forms, policy_, edges)) {
            sweep_.run(*curve);
        }
    }

    std::vector<EdgeTriple> waiting;
    std::vector<SkeletonArc> arcs;
    [[nodiscard]] const Tally& tally() const { return tally_; }

private:
    SweepOutput output() {
        SweepOutput output;
        output.add_node = [this](SkeletonNode&& node) {
            return shared_.nodes.insert(std::move(node));
        };
        output.add_arc = [this](SkeletonArc&& arc) {
            if (!shared_.selection.wants(arc.label)) return;
            shared_.arc_count.fetch_add(1, std::memory_order_relaxed);
            arcs.push_back(std::move(arc));
        };
        if (!shared_.selection.is_by_pair()) {
            output.add_swath = [this](const EdgeTriple& t) {
                if (shared_.selection.wants(t) && shared_.visited.insert(t)) waiting.push_back(t);
            };
        }
        return output;
    }
    bool goes_on() {
        if ((++asked_ & 63U) != 0) return !shared_.supervisor.is_over();
        return shared_.supervisor.goes_on(shared_.nodes.size() + shared_.arc_count);
    }

    Shared& shared_;
    Tally tally_;
    Policy policy_;
    VertexSight sight_;
    Sweep sweep_;
    unsigned asked_ = 0;
};

class Builder {
public:
    Builder(const Scene3& scene, const SkeletonOptions& options, const Limits& limits)
        : shared_(scene, options, limits),
          workers_([this] { return std::make_unique<Worker>(shared_); }),
          arena_(static_cast<int>(options.threads == 0 ? tbb::info::default_concurrency()
                                                       : static_cast<int>(options.threads))) {}

    Result<VisibilitySkeleton> build() {
        sweep_pencils();
        if (shared_.selection.is_by_pair()) {
            sweep_shaft();
        } else {
            follow_swaths();
        }
        if (shared_.supervisor.is_over()) return tl::unexpected(shared_.supervisor.error());
        shared_.supervisor.report(1);
        return collect();
    }

private:
    template <typename Work>
    void in_parallel(std::size_t count, const Work& work) {
        arena_.execute([&] {
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), [&](const auto& range) {
                Worker& worker = *workers_.local();
                for (std::size_t i = range.begin(); i != range.end(); ++i) work(worker, i);
            });
        });
    }

    void sweep_pencils() {
        const std::size_t count = shared_.forms.scene().vertices().size();
        std::atomic<std::size_t> done = 0;
        in_parallel(count, [&](Worker& worker, std::size_t v) {
            worker.sweep_pencils(VertexId{static_cast<std::uint32_t>(v)});
            shared_.supervisor.report(0.6 * static_cast<double>(++done) /
                                      static_cast<double>(count));
        });
        sweep_contacts();
    }

    void sweep_contacts() {
        const auto crossings = shared_.forms.crossings();
        in_parallel(crossings.size(), [&](Worker& worker, std::size_t i) {
            worker.sweep_crossing(crossings[i].first, crossings[i].second);
        });
        for (const auto& plane : shared_.forms.contact_planes()) {
            in_parallel(plane.edges.size(), [&](Worker& worker, std::size_t i) {
                worker.sweep_contact_plane(plane, plane.edges[i]);
            });
        }
        const auto planes = shared_.forms.contact_planes();
        in_parallel(planes.size(),
                    [&](Worker& worker, std::size_t i) { worker.sweep_contact_border(planes[i]); });
    }

    /// Round by round: the swaths that the nodes of the last round may have.
    void follow_swaths() {
        for (double share = 0.6; !shared_.supervisor.is_over(); share += 0.3 * (1 - share)) {
            std::vector<EdgeTriple> round;
            for (auto& worker : workers_) {
                round.insert(round.end(), worker->waiting.begin(), worker->waiting.end());
                worker->waiting.clear();
            }
            if (round.empty()) return;
            shared_.supervisor.report(share);
            in_parallel(round.size(),
                        [&](Worker& worker, std::size_t i) { worker.sweep_swath(round[i]); });
        }
    }

    /// All swaths of three edges in the shaft between two faces.
    void sweep_shaft() {
        const auto edges = shared_.selection.edges();
        in_parallel(edges.size(), [&](Worker& worker, std::size_t i) {
            for (std::size_t j = 0; j < i; ++j) {
                for (std::size_t k = 0; k < j; ++k) {
                    worker.sweep_swath({edges[k], edges[j], edges[i]});
                }
            }
        });
    }

    VisibilitySkeleton collect() {
        std::vector<SkeletonArc> arcs;
        for (auto& worker : workers_) {
            std::ranges::move(worker->arcs, std::back_inserter(arcs));
            if (shared_.options.tally != nullptr) *shared_.options.tally += worker->tally();
        }
        std::vector<std::uint32_t> rank;
        auto nodes = shared_.nodes.take(rank);
        for (SkeletonArc& arc : arcs) {
            for (NodeId& node : arc.nodes) node = NodeId{rank[node.index()]};
        }
        const SkeletonPart& part = shared_.options.part;
        if (part.between || part.edge) keep_used(nodes, arcs);
        return VisibilitySkeleton(std::move(nodes), std::move(arcs));
    }

    /// Of a part: nodes at the ends of its arcs only.
    static void keep_used(std::vector<SkeletonNode>& nodes, std::vector<SkeletonArc>& arcs) {
        std::vector<std::uint32_t> rank(nodes.size(), Run::none);
        std::vector<SkeletonNode> kept;
        for (SkeletonArc& arc : arcs) {
            for (NodeId& node : arc.nodes) {
                std::uint32_t& number = rank[node.index()];
                if (number == Run::none) {
                    number = static_cast<std::uint32_t>(kept.size());
                    kept.push_back(std::move(nodes[node.index()]));
                }
                node = NodeId{number};
            }
        }
        nodes = std::move(kept);
    }

    Shared shared_;
    tbb::enumerable_thread_specific<std::unique_ptr<Worker>> workers_;
    tbb::task_arena arena_;
};

}  // namespace

VisibilitySkeleton visibility_skeleton(const Scene3& scene, const SkeletonOptions& options) {
    return *visibility_skeleton(scene, options, Limits{});
}

Result<VisibilitySkeleton> visibility_skeleton(const Scene3& scene, const SkeletonOptions& options,
                                               const Limits& limits) {
    return Builder(scene, options, limits).build();
}

}  // namespace sightline
