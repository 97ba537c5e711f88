// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "scene/layout.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

/// What two edges of different solids that meet wrongly say, by owners.
struct Verdict {
    Errc code;
    std::string what;
};

std::string body_name(Owner owner) {
    return owner == world_solid ? "the outside of the world" : fmt::format("body {}", owner);
}

Verdict conflict(Owner a, Owner b) {
    if (a == b) {
        return {Errc::self_intersection,
                "the rings of one polygon may touch in points but not cross or run "
                "along each other; "
                "mend the ring"};
    }
    if (a == world_solid || b == world_solid) {
        return {Errc::outside_world,
                fmt::format("body {} reaches out of the world; clip it to the world",
                            a == world_solid ? b : a)};
    }
    return {Errc::body_overlap, fmt::format("bodies {} and {} overlap; separate "
                                            "them, or merge them with --repair",
                                            std::min(a, b), std::max(a, b))};
}

class FaultDescriber {
public:
    FaultDescriber(const SceneLayout& layout, const SweepFault& fault)
        : layout_(layout), fault_(fault) {}

    [[nodiscard]] Error describe() const {
        switch (fault_.kind) {
            case SweepFault::Kind::crossing:
                return pair_error("crosses", fault_.first, fault_.second);
            case SweepFault::Kind::overlap:
                return pair_error("runs along", fault_.first, fault_.second);
            case SweepFault::Kind::chains_cross:
                return pair_error("crosses", fault_.first, fault_.second);
            case SweepFault::Kind::mismatch:
                break;
        }
        if (fault_.second != no_edge && !is_one_ring() &&
            starts_here(layout_.chain_of_edge(fault_.second))) {
            return nesting_error(layout_.chain_of_edge(fault_.second));
        }
        return place_error();
    }

private:
    [[nodiscard]] Error make(Errc code, const ChainRecord& chain, std::string text) const {
        return {code, layout_.origin(chain.element) + std::move(text)};
    }

    [[nodiscard]] Error pair_error(std::string_view verb, std::uint32_t a, std::uint32_t b) const {
        if (a > b) std::swap(a, b);
        const ChainRecord& chain = layout_.chain_of_edge(a);
        const Verdict verdict = conflict(owner_of(layout_.edges[a]), owner_of(layout_.edges[b]));
        return make(verdict.code, chain,
                    fmt::format("{} {} {}: {}", layout_.name_of_edge(a), verb,
                                layout_.name_of_edge(b), verdict.what));
    }

    [[nodiscard]] bool is_one_ring() const {
        return fault_.first != no_edge &&
               &layout_.chain_of_edge(fault_.first) == &layout_.chain_of_edge(fault_.second);
    }

    [[nodiscard]] bool starts_here(const ChainRecord& chain) const {
        const Point2& place = layout_.vertices[fault_.place.index()];
        for (std::uint32_t i = 0; i < chain.vertex_count; ++i) {
            if (layout_.vertices[chain.first_vertex + i] < place) return false;
        }
        return true;
    }

    /// A ring begins where its outside should not be.
    [[nodiscard]] Error nesting_error(const ChainRecord& ring) const {
        if (ring.is_body_hole) return hole_error(ring);
        const Owner here = fault_.first == no_edge ? free_space : owner_above(fault_.first);
        const std::string name = layout_.name_of_vertex(least_vertex(ring));
        if (layout_.input->world &&
            (fault_.first == no_edge || here == world_solid || ring.owner == world_solid)) {
            return make(Errc::outside_world, ring,
                        fmt::format("{}: body {} lies outside of the world; move it "
                                    "inside or clip it",
                                    name, ring.owner));
        }
        if (here == ring.owner) {
            return make(Errc::hole_outside, ring,
                        fmt::format("{}: lies inside a hole of its own polygon; "
                                    "exchange the two rings",
                                    name));
        }
        if (here == free_space) return place_error();
        if (is_within(ring, here)) {
            return make(Errc::wrong_nesting, ring,
                        fmt::format("{}: body {} lies inside the solid part of body "
                                    "{}; remove it, or merge them with --repair",
                                    name, ring.owner, here));
        }
        const Verdict verdict = conflict(ring.owner, here);
        return make(verdict.code, ring,
                    fmt::format("{}: lies inside {}: {}", name, body_name(here), verdict.what));
    }

    [[nodiscard]] Error hole_error(const ChainRecord& ring) const {
        const VertexId v = least_vertex(ring);
        const Point2& p = layout_.vertices[v.index()];
        for (const ChainRecord& other : layout_.chains) {
            if (&other == &ring || !other.is_body_hole || other.owner != ring.owner) continue;
            if (side_of_ring(layout_, other, p) != Sign::positive) continue;
            return make(Errc::wrong_nesting, ring,
                        fmt::format("{}: lies inside hole {} of the same polygon; "
                                    "make it a polygon of its own",
                                    layout_.name_of_vertex(v), other.hole));
        }
        return make(Errc::hole_outside, ring,
                    fmt::format("{}: the hole is not inside its polygon's outer "
                                "ring; move it, or make it a polygon of its own",
                                layout_.name_of_vertex(v)));
    }

    /// Boundaries meet in one place and do not fit together there.
    [[nodiscard]] Error place_error() const {
        const std::uint32_t named = fault_.second != no_edge ? fault_.second : fault_.first;
        const Point2& p = layout_.vertices[fault_.place.index()];
        std::uint32_t other = no_edge;
        for (std::uint32_t e = 0; e < layout_.edges.size(); ++e) {
            if (e == named || layout_.edges[e].kind == EdgeKind2::wall || !is_on(p, e)) continue;
            const bool better = other == no_edge ||
                                (owner_of(layout_.edges[other]) == owner_of(layout_.edges[named]) &&
                                 owner_of(layout_.edges[e]) != owner_of(layout_.edges[named]));
            if (better) other = e;
        }
        if (fault_.first != no_edge && owner_above(fault_.first) != free_space) {
            const Owner above = owner_above(fault_.first);
            if (other == no_edge ||
                (above != owner_of(layout_.edges[named]) &&
                 owner_of(layout_.edges[other]) == owner_of(layout_.edges[named]))) {
                other = fault_.first;
            }
        }
        return pair_error(fmt::format("does not fit, at ({}, {}), with", p.x, p.y), named,
                          other == no_edge ? named : other);
    }

    [[nodiscard]] bool is_on(const Point2& p, std::uint32_t e) const {
        const Point2& s = layout_.vertices[layout_.edges[e].source.index()];
        const Point2& t = layout_.vertices[layout_.edges[e].target.index()];
        const bool between = s < t ? !(p < s) && !(t < p) : !(p < t) && !(s < p);
        return between && orientation(s, t, p) == Sign::zero;
    }

    [[nodiscard]] Owner owner_above(std::uint32_t e) const {
        const Edge2& edge = layout_.edges[e];
        const bool rightwards =
            layout_.vertices[edge.source.index()] < layout_.vertices[edge.target.index()];
        return rightwards ? owner_of(edge) : free_space;
    }

    [[nodiscard]] VertexId least_vertex(const ChainRecord& ring) const {
        std::uint32_t best = ring.first_vertex;
        for (std::uint32_t v = best; v < ring.first_vertex + ring.vertex_count; ++v) {
            if (layout_.vertices[v] < layout_.vertices[best]) best = v;
        }
        return VertexId{best};
    }

    /// Whether no vertex of the ring lies outside the outer ring of `owner`. The
    /// two rings have not been seen to cross; large pairs are not tried, and then
    /// called an overlap, which is true too.
    [[nodiscard]] bool is_within(const ChainRecord& ring, Owner owner) const {
        const ChainRecord* outer = layout_.outer_ring_of(owner);
        if (outer == nullptr) return false;
        constexpr std::uint64_t largest_effort = 20'000'000;
        if (std::uint64_t{ring.vertex_count} * outer->vertex_count > largest_effort) return false;
        for (std::uint32_t i = 0; i < ring.vertex_count; ++i) {
            const Point2& p = layout_.vertices[ring.first_vertex + i];
            if (side_of_ring(layout_, *outer, p) == Sign::negative) return false;
        }
        return true;
    }

    const SceneLayout& layout_;
    const SweepFault& fault_;
};

}  // namespace

Error describe_fault(const SceneLayout& layout, const SweepFault& fault) {
    return FaultDescriber(layout, fault).describe();
}

}  // namespace sightline::detail
