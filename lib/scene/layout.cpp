// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

// Products of two differences stay finite in the exact tier whatever the size;
// the bound keeps differences themselves inside the doubles, which the filters
// rely on.
constexpr double largest_coordinate = 0x1p1020;

std::string show(const Point2& p) { return fmt::format("({}, {})", p.x, p.y); }

class Layouter {
public:
    explicit Layouter(const SceneInput2& input) : input_(input) { layout_.input = &input; }

    Result<SceneLayout> run() {
        if (input_.elements.empty()) {
            return fail(Errc::empty_scene,
                        prefix() + "the scene is empty; give at least one polygon, wall or point");
        }
        for (std::uint32_t i = 0; i < input_.elements.size() && !error_; ++i) add_element(i);
        if (error_) return tl::unexpected<Error>(*error_);
        if (input_.world && !world_seen_) {
            return fail(Errc::empty_scene, prefix() +
                                               "there is no polygon to be the world; add one, or "
                                               "read without the world option");
        }
        return std::move(layout_);
    }

private:
    [[nodiscard]] std::string prefix() const {
        return input_.file.empty() ? "" : input_.file + ": ";
    }

    void add_element(std::uint32_t index) {
        const SceneElement2& element = input_.elements[index];
        if (const auto* polygon = std::get_if<Polygon2>(&element)) {
            add_polygon(*polygon, index);
        } else if (const auto* wall = std::get_if<Polyline2>(&element)) {
            add_wall(*wall, index);
        } else {
            ChainRecord chain = begin_chain(ChainRecord::Kind::point, index, 0);
            if (add_vertices(chain, {&std::get<Point2>(element), 1}))
                layout_.chains.push_back(chain);
        }
    }

    void add_polygon(const Polygon2& polygon, std::uint32_t index) {
        const bool is_world = input_.world && !world_seen_;
        world_seen_ = true;
        const Owner owner = is_world ? world_solid : layout_.body_count++;
        add_ring(polygon.outer, ChainRecord::Kind::outer, index, 0, owner, false);
        for (std::uint32_t h = 0; h < polygon.holes.size() && !error_; ++h) {
            const Owner hole_owner = is_world ? layout_.body_count++ : owner;
            add_ring(polygon.holes[h], ChainRecord::Kind::hole, index, h, hole_owner, !is_world);
        }
    }

    [[nodiscard]] ChainRecord begin_chain(ChainRecord::Kind kind, std::uint32_t element,
                                          std::uint32_t hole) const {
        ChainRecord chain;
        chain.kind = kind;
        chain.element = element;
        chain.hole = hole;
        chain.first_vertex = static_cast<std::uint32_t>(layout_.vertices.size());
        chain.first_edge = static_cast<std::uint32_t>(layout_.edges.size());
        return chain;
    }

    bool add_vertices(ChainRecord& chain, std::span<const Point2> points) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point2& p = points[i];
            const bool finite = std::isfinite(p.x) && std::isfinite(p.y);
            if (!finite) {
                return refuse(Errc::not_finite, chain, i, p,
                              "is not finite; give a number for each coordinate");
            }
            if (std::abs(p.x) > largest_coordinate || std::abs(p.y) > largest_coordinate) {
                return refuse(Errc::coordinate_too_large, chain, i, p,
                              "is larger than 2^1020; scale the scene down by a power of two");
            }
            layout_.vertices.push_back({p.x + 0.0, p.y + 0.0});  // -0.0 becomes 0.0
        }
        chain.vertex_count = static_cast<std::uint32_t>(points.size());
        return true;
    }

    bool refuse(Errc code, const ChainRecord& chain, std::size_t vertex, const Point2& p,
                std::string_view what) {
        error_ = Error{code, fmt::format("{}{}, vertex {} {}: {}", layout_.origin(chain.element),
                                         layout_.name_of_chain(chain), vertex, show(p), what)};
        return false;
    }

    bool refuse(Errc code, const ChainRecord& chain, std::string_view what) {
        error_ = Error{code, fmt::format("{}{}: {}", layout_.origin(chain.element),
                                         layout_.name_of_chain(chain), what)};
        return false;
    }

    void add_ring(std::span<const Point2> points, ChainRecord::Kind kind, std::uint32_t element,
                  std::uint32_t hole, Owner owner, bool is_body_hole) {
        ChainRecord chain = begin_chain(kind, element, hole);
        chain.owner = owner;
        chain.is_body_hole = is_body_hole;
        if (points.size() > 1 && points.front() == points.back())
            points = points.first(points.size() - 1);
        if (!add_vertices(chain, points) || !check_ring(chain, points)) return;
        const bool wants_clockwise = is_body_hole || owner == world_solid;
        chain.reversed = is_counter_clockwise(points) == wants_clockwise;
        const std::uint32_t n = chain.vertex_count;
        const EdgeKind2 edge_kind = owner == world_solid ? EdgeKind2::world : EdgeKind2::body;
        const BodyId body = owner == world_solid ? BodyId::none() : BodyId{owner};
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t source = chain.reversed ? (n - i) % n : i;
            const std::uint32_t target = chain.reversed ? n - i - 1 : (i + 1) % n;
            layout_.edges.push_back({VertexId{chain.first_vertex + source},
                                     VertexId{chain.first_vertex + target}, body, edge_kind});
        }
        chain.edge_count = n;
        layout_.chains.push_back(chain);
    }

    bool check_ring(const ChainRecord& chain, std::span<const Point2> ring) {
        if (!has_three_distinct(ring)) {
            return refuse(Errc::too_few_vertices, chain,
                          "a ring needs at least 3 distinct vertices; add vertices "
                          "or remove the ring");
        }
        const std::size_t n = ring.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (ring[i] == ring[(i + n - 1) % n]) {
                return refuse(Errc::repeated_vertex, chain, i, ring[i],
                              "repeats the vertex before it; remove one of the two, or "
                              "use --repair");
            }
        }
        for (std::size_t i = 0; i < n; ++i) {
            const Point2& before = ring[(i + n - 1) % n];
            const Point2& after = ring[(i + 1) % n];
            if ((before < ring[i]) == (after < ring[i]) &&
                orientation(before, ring[i], after) == Sign::zero) {
                return refuse(Errc::spike, chain, i, ring[i],
                              "is a spike: the ring turns back on itself; remove the "
                              "vertex, or use --repair");
            }
        }
        return true;
    }

    static bool has_three_distinct(std::span<const Point2> ring) {
        const auto second = std::find_if(ring.begin(), ring.end(),
                                         [&](const Point2& p) { return p != ring.front(); });
        return std::any_of(second, ring.end(),
                           [&](const Point2& p) { return p != ring.front() && p != *second; });
    }

    /// Of a ring that does not cross itself: decided by the lowest edge at its
    /// least vertex.
    static bool is_counter_clockwise(std::span<const Point2> ring) {
        const Point2 least = *std::min_element(
            ring.begin(), ring.end(), [](const Point2& a, const Point2& b) { return a < b; });
        const std::size_t n = ring.size();
        const Point2* lowest = nullptr;
        bool outgoing = false;
        for (std::size_t i = 0; i < n; ++i) {
            if (ring[i] != least) continue;
            for (const bool out : {true, false}) {
                const Point2& end = ring[(out ? i + 1 : i + n - 1) % n];
                if (lowest != nullptr && orientation(least, *lowest, end) != Sign::negative)
                    continue;
                lowest = &end;
                outgoing = out;
            }
        }
        return outgoing;
    }

    void add_wall(const Polyline2& wall, std::uint32_t index) {
        ChainRecord chain = begin_chain(ChainRecord::Kind::wall, index, 0);
        if (!add_vertices(chain, wall.points)) return;
        if (wall.points.size() < 2) {
            refuse(Errc::too_few_vertices, chain,
                   "a wall needs at least 2 vertices; add one, or give a point");
            return;
        }
        for (std::size_t i = 1; i < wall.points.size(); ++i) {
            if (wall.points[i] == wall.points[i - 1]) {
                refuse(Errc::zero_length, chain, i, wall.points[i],
                       "ends a wall of length zero; remove the vertex, or use --repair");
                return;
            }
            layout_.edges.push_back(
                {VertexId{chain.first_vertex + static_cast<std::uint32_t>(i) - 1},
                 VertexId{chain.first_vertex + static_cast<std::uint32_t>(i)}, BodyId::none(),
                 EdgeKind2::wall});
        }
        chain.edge_count = chain.vertex_count - 1;
        layout_.chains.push_back(chain);
    }

    const SceneInput2& input_;
    SceneLayout layout_;
    std::optional<Error> error_;
    bool world_seen_ = false;
};

}  // namespace

const ChainRecord& SceneLayout::chain_of_vertex(VertexId v) const {
    const auto after = std::upper_bound(
        chains.begin(), chains.end(), v.value,
        [](std::uint32_t value, const ChainRecord& chain) { return value < chain.first_vertex; });
    return *std::prev(after);
}

const ChainRecord& SceneLayout::chain_of_edge(std::uint32_t e) const {
    return chain_of_vertex(edges[e].source);
}

const ChainRecord* SceneLayout::outer_ring_of(Owner owner) const {
    for (const ChainRecord& chain : chains) {
        const bool is_ring =
            chain.kind == ChainRecord::Kind::outer || chain.kind == ChainRecord::Kind::hole;
        if (is_ring && chain.owner == owner && !chain.is_body_hole) return &chain;
    }
    return nullptr;
}

std::string SceneLayout::origin(std::uint32_t element) const {
    std::string text = input->file;
    if (element < input->lines.size())
        text += fmt::format("{}{}", text.empty() ? "line " : ":", input->lines[element]);
    return text.empty() ? text : text + ": ";
}

std::string SceneLayout::name_of_chain(const ChainRecord& chain) const {
    switch (chain.kind) {
        case ChainRecord::Kind::outer:
            return fmt::format("element {} (polygon), outer ring", chain.element);
        case ChainRecord::Kind::hole:
            return fmt::format("element {} (polygon), hole {}", chain.element, chain.hole);
        case ChainRecord::Kind::wall:
            return fmt::format("element {} (wall)", chain.element);
        case ChainRecord::Kind::point:
            break;
    }
    return fmt::format("element {} (point)", chain.element);
}

std::string SceneLayout::name_of_vertex(VertexId v) const {
    const ChainRecord& chain = chain_of_vertex(v);
    return fmt::format("{}, vertex {} {}", name_of_chain(chain), v.value - chain.first_vertex,
                       show(vertices[v.index()]));
}

std::string SceneLayout::name_of_edge(std::uint32_t e) const {
    const ChainRecord& chain = chain_of_edge(e);
    const std::uint32_t s = std::min(edges[e].source.value, edges[e].target.value);
    const std::uint32_t t = std::max(edges[e].source.value, edges[e].target.value);
    const bool closing = s == chain.first_vertex && t != s + 1;
    const VertexId from{closing ? t : s};
    const VertexId to{closing ? s : t};
    return fmt::format("{}, edge {} {}-{}", name_of_chain(chain), from.value - chain.first_vertex,
                       show(vertices[from.index()]), show(vertices[to.index()]));
}

Sign side_of_ring(const SceneLayout& layout, const ChainRecord& ring, const Point2& p) {
    bool inside = false;
    for (std::uint32_t i = 0; i < ring.vertex_count; ++i) {
        const Point2* a = &layout.vertices[ring.first_vertex + i];
        const Point2* b = &layout.vertices[ring.first_vertex + (i + 1) % ring.vertex_count];
        if (*b < *a) std::swap(a, b);
        if (p < *a || *b < p) continue;
        const Sign side = orientation(*a, *b, p);
        if (side == Sign::zero) return Sign::zero;
        // Lexicographic order stands for a ray downwards that leans a little: no
        // vertex lies on it.
        if (*a < p && p < *b && side == Sign::positive) inside = !inside;
    }
    return inside ? Sign::positive : Sign::negative;
}

Result<SceneLayout> lay_out(const SceneInput2& input) { return Layouter(input).run(); }

}  // namespace sightline::detail
