// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/view/view3.hpp"

#include <algorithm>
#include <exception>
#include <ostream>
#include <set>

#include "view/assembly.hpp"
#include "view/edge_sight.hpp"
#include "view/image.hpp"
#include "view/sight.hpp"

namespace sightline {
namespace {

using detail::Image;
using detail::PlacedScene;
using detail::PlacedTriangle;

bool is_on_triangle(Image& image, const PlacedTriangle& t) {
    const Vector3& a = image.exact(t.corners[0]);
    const Vector3& b = image.exact(t.corners[1]);
    const Vector3& c = image.exact(t.corners[2]);
    if (determinant(a, b, c).sign() != Sign::zero) return false;
    const Vector3 normal = cross(b - a, c - a);
    const auto inside = [&](const Vector3& x, const Vector3& y) {
        return dot(cross(x, y), normal).sign() != Sign::negative;
    };
    return inside(a, b) && inside(b, c) && inside(c, a);
}

enum class Place { outside, inside, on_solid };

struct Location {
    Place place = Place::outside;
    BodyId body;
};

// Where a point is: in the inside of a solid, on solids, or elsewhere.
Location locate(Image& image) {
    const PlacedScene& view = image.scene();
    const Point3 p = approx_point(image.from().coordinates);
    const std::array<double, 3> at{p.x, p.y, p.z};
    Location location;
    const auto near = [&](const Box3& box) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double slack = 0x1p-50 * std::abs(at[k]);
            if (at[k] + slack < box.low[k] || at[k] - slack > box.high[k]) return false;
        }
        return true;
    };
    view.bvh.traverse(near, [&](std::uint32_t i) {
        const PlacedTriangle& t = view.triangles[i];
        if (view.face_is_sheet[t.face] != 0 || !is_on_triangle(image, t)) return true;
        location = {Place::on_solid, view.scene->faces()[t.face].body};
        return false;
    });
    if (location.place == Place::on_solid) return location;
    detail::Sight sight(image, {1, 0, 0}, {p.x + std::max(1.0, std::abs(p.x)), p.y, p.z});
    const detail::SightEnd end = sight.look({0, 1, 0}, {0, 0, 1});
    if (end.kind == ViewRegion::Kind::blocked) return {Place::inside, end.body};
    return {};
}

tl::unexpected<Error> inside(const Scene3& scene, BodyId body) {
    if (scene[body].is_world) {
        return fail(Errc::outside_of_world,
                    "the viewpoint lies outside of the world; move it inside");
    }
    return fail(Errc::inside_body, "the viewpoint lies inside body " + std::to_string(body.value) +
                                       "; move it out or onto its boundary");
}

Result<void> check_cone(Image& image, std::size_t sides) {
    if (sides == 0) return {};
    const auto first = image.vertex_count();
    const auto n = static_cast<std::uint32_t>(sides);
    const auto wrong =
        fail(Errc::bad_parameter,
             "the cone's corners are no convex polygon as seen from the viewpoint; give at "
             "least three points, counter-clockwise");
    if (n < 3) return wrong;
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 2; j < n; ++j) {
            const Sign s = image.orientation(first + i, first + (i + 1) % n, first + (i + j) % n);
            if (s != Sign::positive) return wrong;
        }
    }
    return {};
}

Vector3 exact_vector(const Scene3& scene, VertexId v) { return vector_to(to_rational(scene[v])); }

// The normal of the plane through the viewpoint and an edge.
Vector3 sight_normal(const Scene3& scene, const Viewpoint3& from, EdgeId e) {
    const Vector3 u = exact_vector(scene, scene[e].source);
    const Vector3 w = exact_vector(scene, scene[e].target);
    const Vector3 p = vector_to(from.coordinates);
    return from.at_infinity ? cross(p, w - u) : cross(u - p, w - p);
}

// The t of u + t (w - u) where the plane through the viewpoint with this normal meets the edge; empty when it
// contains the edge.
std::optional<Rational> cut(const Scene3& scene, EdgeId e, const Vector3& normal,
                            const Vector3& on_plane) {
    const Rational a = dot(normal, exact_vector(scene, scene[e].source) - on_plane);
    const Rational b = dot(normal, exact_vector(scene, scene[e].target) - on_plane);
    if ((a - b).sign() == Sign::zero) return std::nullopt;
    return a / (a - b);
}

Vector3 cone_side_normal(const View3& view, std::uint32_t side) {
    const Vector3 p = vector_to(view.from.coordinates);
    const Vector3 a = vector_to(view.cone[side]);
    const Vector3 b = vector_to(view.cone[(side + 1) % view.cone.size()]);
    return view.from.at_infinity ? cross(p, b - a) : cross(a - p, b - p);
}

Result<View3> look_at(const PlacedScene& placed, const Viewpoint3& from,
                      const View3Options& options) {
    Image image(placed, from, options.cone, options.arithmetic, options.tally);
    const auto sides = static_cast<std::uint32_t>(options.cone.size());
    if (auto checked = check_cone(image, sides); !checked) return tl::unexpected(checked.error());
    const Location location = from.at_infinity ? Location{} : locate(image);
    if (location.place == Place::inside) return inside(*placed.scene, location.body);
    const detail::Facings facings(image, location.place == Place::on_solid);
    detail::EdgeSight sight(image, facings, sides);
    detail::Assembly assembly(image, facings, sides);
    detail::EdgeView seen;
    for (std::uint32_t e = 0; e < placed.edges.size(); ++e) {
        sight.look(e, seen);
        assembly.add(e, seen);
    }
    std::optional<BodyId> blocked_by;
    View3 view{from, options.cone, assembly.finish(blocked_by)};
    if (blocked_by) return inside(*placed.scene, *blocked_by);
    return view;
}

}  // namespace

PointVisibility3::PointVisibility3(const Scene3& scene)
    : scene_(std::make_unique<const PlacedScene>(scene)) {}
PointVisibility3::~PointVisibility3() = default;
PointVisibility3::PointVisibility3(PointVisibility3&&) noexcept = default;
PointVisibility3& PointVisibility3::operator=(PointVisibility3&&) noexcept = default;

Result<View3> PointVisibility3::from(const RationalPoint3& p, const View3Options& options) const {
    return look({p, false}, options);
}

Result<View3> PointVisibility3::along(const Vector3& direction, const View3Options& options) const {
    if (direction.is_zero()) {
        return fail(Errc::bad_parameter, "the direction is zero; give another one");
    }
    if (scene_->has_world) {
        return fail(Errc::outside_of_world,
                    "nothing of a world's inside is seen from infinity; look from a point in it");
    }
    return look({{direction.x, direction.y, direction.z}, true}, options);
}

Result<View3> PointVisibility3::look(const Viewpoint3& from, const View3Options& options) const {
    if (options.arithmetic == Arithmetic::filtered || options.arithmetic == Arithmetic::exact) {
        return look_at(*scene_, from, options);
    }
    // Signs that are not certain may contradict each other.
    try {
        return look_at(*scene_, from, options);
    } catch (const std::exception&) {
        return fail(Errc::bad_parameter,
                    "the chosen arithmetic contradicts itself in this view; use filtered");
    }
}

Result<View3> view3(const Scene3& scene, const Viewpoint3& from, const View3Options& options) {
    const PointVisibility3 visibility(scene);
    const RationalPoint3& c = from.coordinates;
    if (from.at_infinity) return visibility.along({c.x, c.y, c.z}, options);
    return visibility.from(c, options);
}

std::vector<FaceSide> View3::visible_faces() const {
    std::set<FaceSide> faces;
    for (const ViewRegion& region : map.regions) {
        if (region.kind == ViewRegion::Kind::face)
            faces.insert(region.faces.begin(), region.faces.end());
    }
    return {faces.begin(), faces.end()};
}

std::vector<VertexId> View3::visible_vertices() const {
    std::set<VertexId> vertices;
    for (const ViewNode& node : map.nodes)
        vertices.insert(node.vertices.begin(), node.vertices.end());
    return {vertices.begin(), vertices.end()};
}

Rational exact_parameter(const Scene3& scene, const View3& view, std::uint32_t node, EdgeId edge) {
    const ViewNode& n = view.map.nodes[node];
    const Vector3 p = vector_to(view.from.coordinates);
    const Vector3 own = sight_normal(scene, view.from, edge);
    for (const VertexId v : n.vertices) {
        if (v == scene[edge].source) return 0;
        if (v == scene[edge].target) return 1;
    }
    if (!n.vertices.empty()) {
        // The plane through the line of sight at a right angle to the edge's own.
        const Vector3 x = exact_vector(scene, n.vertices.front());
        const Vector3 sight = view.from.at_infinity ? p : x - p;
        return *cut(scene, edge, cross(sight, own), x);
    }
    for (const EdgeId f : n.edges) {
        const Vector3 normal = sight_normal(scene, view.from, f);
        if (f == edge || cross(own, normal).is_zero()) continue;
        return *cut(scene, edge, normal, exact_vector(scene, scene[f].source));
    }
    for (const std::uint32_t side : n.sides) {
        const Vector3 normal = cone_side_normal(view, side);
        if (cross(own, normal).is_zero()) continue;
        return *cut(scene, edge, normal, vector_to(view.cone[side]));
    }
    // Only edges on one great circle: two of them cross in space.
    for (const EdgeId e : n.edges) {
        for (const EdgeId f : n.edges) {
            const Vector3 a = exact_vector(scene, scene[e].source);
            const Vector3 d = exact_vector(scene, scene[e].target) - a;
            const Vector3 c = exact_vector(scene, scene[f].source);
            const Vector3 g = exact_vector(scene, scene[f].target) - c;
            const Vector3 flat = cross(own, g);
            if (dot(flat, d).sign() == Sign::zero) continue;
            const Rational t = dot(flat, c - a) / dot(flat, d);
            if (t.sign() != Sign::positive || t >= Rational(1)) continue;
            const Vector3 x = a + t * d;
            const Vector3 sight = view.from.at_infinity ? p : x - p;
            if (const auto s = cut(scene, edge, cross(sight, own), x)) return *s;
        }
    }
    SIGHTLINE_EXPECT(false);
    return 0;
}

RationalPoint3 exact_point(const Scene3& scene, const View3& view, std::uint32_t node) {
    const ViewNode& n = view.map.nodes[node];
    if (!n.vertices.empty()) return to_rational(scene[n.vertices.front()]);
    if (!n.edges.empty()) {
        const Edge3& e = scene[n.edges.front()];
        const Rational t = exact_parameter(scene, view, node, n.edges.front());
        const RationalPoint3 u = to_rational(scene[e.source]);
        return u + t * (to_rational(scene[e.target]) - u);
    }
    // A corner lies on two sides: its own, and the one before.
    const auto sides = static_cast<std::uint32_t>(view.cone.size());
    for (const std::uint32_t side : n.sides) {
        const std::uint32_t before = (side + sides - 1) % sides;
        if (std::find(n.sides.begin(), n.sides.end(), before) != n.sides.end()) {
            return view.cone[side];
        }
    }
    SIGHTLINE_EXPECT(false);
    return {};
}

std::ostream& operator<<(std::ostream& out, const ViewMap3& map) {
    const auto list = [&out](const auto& ids) {
        for (const auto& id : ids) out << ' ' << to_string(id);
    };
    for (std::size_t i = 0; i < map.nodes.size(); ++i) {
        out << "node " << i << ':';
        list(map.nodes[i].vertices);
        list(map.nodes[i].edges);
        for (const std::uint32_t s : map.nodes[i].sides) out << " side" << s;
        out << '\n';
    }
    for (const ViewArc& arc : map.arcs) {
        out << "arc " << arc.source << ' ' << arc.target << ':';
        list(arc.edges);
        if (arc.side != ViewArc::no_side) out << " side" << arc.side;
        out << " | " << arc.left << ' ' << arc.right << '\n';
    }
    for (const ViewRegion& region : map.regions) {
        constexpr std::array<const char*, 4> names{"face", "infinity", "blocked", "outside"};
        out << "region " << names[static_cast<std::size_t>(region.kind)];
        for (const FaceSide& f : region.faces)
            out << ' ' << to_string(f.face) << (f.back ? "-" : "");
        for (const auto& ring : region.rings) {
            out << " |";
            for (const ViewHalfArc& h : ring) out << ' ' << h.arc << (h.reversed ? "-" : "");
        }
        out << '\n';
    }
    for (const TJunction& t : map.t_junctions) {
        out << "t " << to_string(t.front) << ' ' << to_string(t.back) << ' ' << t.node << '\n';
    }
    return out;
}

}  // namespace sightline
