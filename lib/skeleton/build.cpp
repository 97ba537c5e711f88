// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>

#include "sightline/skeleton/build.hpp"
#include "skeleton/sweep.hpp"

namespace sightline {

namespace {

using namespace detail;

class Builder {
public:
    Builder(const Scene3& scene, const SkeletonOptions& options)
        : forms_(scene),
          policy_{options.arithmetic, options.tally},
          sweep_(forms_, policy_, output()) {}

    VisibilitySkeleton build() {
        sweep_pencils();
        sweep_contact_pencils();
        while (!waiting_.empty()) {
            const auto edges = waiting_.back();
            waiting_.pop_back();
            if (const auto curve = Curve::through_edges(forms_, policy_, edges)) {
                sweep_.run(*curve);
            }
        }
        return VisibilitySkeleton(std::move(nodes_), std::move(arcs_));
    }

private:
    SweepOutput output() {
        return {[this](FoundNode&& found) { return add(std::move(found)); },
                [this](SkeletonArc&& arc) { arcs_.push_back(std::move(arc)); }};
    }

    std::uint32_t add(FoundNode&& found) {
        const auto [known, is_new] =
            ids_.insert({found.node, static_cast<std::uint32_t>(nodes_.size())});
        if (is_new) {
            nodes_.push_back(std::move(found.node));
            leave(found.elements);
        }
        return known->second;
    }

    /// Every three edges that lines near a node may meet in different points.
    void leave(const std::vector<FoundNode::Element>& elements) {
        const auto same_vertex = [](const auto& a, const auto& b) {
            return !a.vertex.is_none() && a.vertex == b.vertex;
        };
        const auto compatible = [&](const auto& a, const auto& b) {
            return a.edge != b.edge && (a.place != b.place || same_vertex(a, b));
        };
        for (std::size_t i = 0; i < elements.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (!compatible(elements[i], elements[j])) continue;
                for (std::size_t k = 0; k < j; ++k) {
                    if (!compatible(elements[i], elements[k])) continue;
                    if (!compatible(elements[j], elements[k])) continue;
                    if (elements[i].place == elements[j].place &&
                        elements[j].place == elements[k].place) {
                        continue;
                    }
                    std::array edges{elements[i].edge, elements[j].edge, elements[k].edge};
                    std::ranges::sort(edges);
                    if (visited_.insert(edges).second) waiting_.push_back(edges);
                }
            }
        }
    }

    void sweep_pencils() {
        const auto& scene = forms_.scene();
        for (std::uint32_t v = 0; v < scene.vertices().size(); ++v) {
            if (!scene.is_feature(VertexId{v})) continue;
            for (std::uint32_t e = 0; e < scene.edges().size(); ++e) {
                if (const auto curve = Curve::pencil(forms_, policy_, VertexId{v}, EdgeId{e})) {
                    sweep_.run(*curve);
                }
            }
        }
    }

    void sweep_contact_pencils() {
        if (!forms_.scene().has_touching_bodies()) return;
        const auto crossings = edge_crossings(forms_);
        for (const auto& [a, b] : crossings) {
            for (std::uint32_t e = 0; e < forms_.edge_count(); ++e) {
                if (const auto curve = Curve::contact_pencil(forms_, policy_, a, b, EdgeId{e})) {
                    sweep_.run(*curve);
                }
            }
        }
    }

    SceneForms forms_;
    Policy policy_;
    Sweep sweep_;
    std::map<SkeletonNode, std::uint32_t> ids_;
    std::vector<SkeletonNode> nodes_;
    std::vector<SkeletonArc> arcs_;
    std::set<std::array<EdgeId, 3>> visited_;
    std::vector<std::array<EdgeId, 3>> waiting_;
};

}  // namespace

VisibilitySkeleton visibility_skeleton(const Scene3& scene, const SkeletonOptions& options) {
    return Builder(scene, options).build();
}

}  // namespace sightline
