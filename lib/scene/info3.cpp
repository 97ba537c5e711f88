// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/info3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <set>

#include "scene/cone3.hpp"
#include "scene/winding3.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline {
namespace {

using detail::Corners3;
using detail::drop;
using detail::orientation3;
using detail::SceneBox3;
using detail::SceneBoxTree3;

using Key = std::vector<Rational>;

/// Divided by the first number that isn't zero, so that multiples become equal.
Key scaled(Key key) {
    const auto first = std::find_if(key.begin(), key.end(),
                                    [](const Rational& x) { return x.sign() != Sign::zero; });
    if (first == key.end()) return key;
    const Rational by = *first;
    for (Rational& x : key) x /= by;
    return key;
}

Key cross(const Key& a, const Key& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Key vector_of(const Point3& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
Key difference(const Point3& a, const Point3& b) {
    return {Rational(a.x) - Rational(b.x), Rational(a.y) - Rational(b.y),
            Rational(a.z) - Rational(b.z)};
}

/// Lists with several members, by their least member.
template <typename Map>
auto several(const Map& groups) {
    std::vector<typename Map::mapped_type> result;
    for (const auto& [key, list] : groups)
        if (list.size() > 1) result.push_back(list);
    std::sort(result.begin(), result.end());
    return result;
}

class Describer3 {
public:
    explicit Describer3(const Scene3& scene) : scene_(scene) {}

    SceneInfo3 run() {
        count();
        measure();
        find_vertices();
        find_planes();
        find_lines();
        find_nearly_flat();
        if (scene_.has_touching_bodies()) find_contacts();
        return std::move(info_);
    }

private:
    void count() {
        info_.vertices = scene_.vertices().size();
        info_.edges = scene_.edges().size();
        info_.faces = scene_.faces().size();
        info_.triangles = scene_.triangles().size();
        for (const Edge3& e : scene_.edges())
            info_.border_edges += e.faces[0].is_none() || e.faces[1].is_none() ? 1 : 0;
        for (const Face3& f : scene_.faces()) {
            info_.input_faces += f.input_faces.size();
            info_.holes += f.rings.size() - 1;
        }
        for (const Body3& b : scene_.bodies()) {
            info_.has_world = info_.has_world || b.is_world;
            if (!b.is_world) ++(b.kind == SurfaceKind::sheet ? info_.sheets : info_.solids);
        }
    }

    void measure() {
        SceneBox3 box = SceneBox3::of(scene_.vertices()[0]);
        for (const Point3& p : scene_.vertices()) box.include(SceneBox3::of(p));
        info_.low = {box.low[0], box.low[1], box.low[2]};
        info_.high = {box.high[0], box.high[1], box.high[2]};
        for (std::size_t i = 0; i < 3; ++i)
            info_.approx_extent = std::max(info_.approx_extent, box.high[i] - box.low[i]);
        double shortest = std::numeric_limits<double>::infinity();
        for (const Edge3& e : scene_.edges()) {
            const Point3 &s = scene_[e.source], &t = scene_[e.target];
            shortest = std::min(shortest, std::hypot(t.x - s.x, t.y - s.y, t.z - s.z));
        }
        info_.approx_shortest_edge = scene_.edges().empty() ? 0 : shortest;
    }

    /// A vertex that is no feature is isolated, or lies on the surface: then a face or an edge holds it.
    void find_vertices() {
        std::map<Point3, std::vector<VertexId>> places;
        const SceneBoxTree3 tree = triangle_tree();
        for (std::uint32_t v = 0; v < scene_.vertices().size(); ++v) {
            const VertexId id{v};
            const Point3& p = scene_[id];
            if (scene_.is_feature(id)) {
                ++info_.feature_vertices;
                places[p].push_back(id);
                continue;
            }
            bool on_surface = false;
            tree.query(SceneBox3::of(p), [&](std::uint32_t t) {
                on_surface = on_surface || detail::is_on(corners_of(t), p);
            });
            (on_surface ? info_.flat : info_.isolated).push_back(id);
        }
        info_.coincident = several(places);
    }

    [[nodiscard]] Corners3 corners_of(std::uint32_t t) const {
        const auto& c = scene_.triangles()[t].corners;
        return {scene_[c[0]], scene_[c[1]], scene_[c[2]]};
    }
    [[nodiscard]] SceneBoxTree3 triangle_tree() const {
        std::vector<SceneBox3> boxes;
        for (std::uint32_t t = 0; t < scene_.triangles().size(); ++t)
            boxes.push_back(detail::box_of(corners_of(t)));
        return SceneBoxTree3(std::move(boxes));
    }

    void find_planes() {
        std::map<Key, std::vector<FaceId>> planes;
        for (std::uint32_t f = 0; f < scene_.faces().size(); ++f) {
            const auto& [a, b, c] = scene_[FaceId{f}].plane;
            Key key = cross(difference(scene_[b], scene_[a]), difference(scene_[c], scene_[a]));
            const Key p = vector_of(scene_[a]);
            key.push_back(key[0] * p[0] + key[1] * p[1] + key[2] * p[2]);
            planes[scaled(std::move(key))].push_back(FaceId{f});
        }
        info_.coplanar = several(planes);
    }

    void find_lines() {
        std::map<Key, std::vector<EdgeId>> lines;
        std::map<Key, std::size_t> directions;
        for (std::uint32_t e = 0; e < scene_.edges().size(); ++e) {
            const Edge3& edge = scene_[EdgeId{e}];
            Key key = difference(scene_[edge.target], scene_[edge.source]);
            ++directions[scaled(key)];
            const Key moment = cross(vector_of(scene_[edge.source]), key);
            key.insert(key.end(), moment.begin(), moment.end());
            lines[scaled(std::move(key))].push_back(EdgeId{e});
        }
        info_.collinear = several(lines);
        for (const auto& [direction, count] : directions) {
            if (count < 2) continue;
            ++info_.parallel_directions;
            info_.parallel_edges += count;
        }
    }

    void find_nearly_flat() {
        for (std::uint32_t e = 0; e < scene_.edges().size(); ++e) {
            const Edge3& edge = scene_[EdgeId{e}];
            if (edge.faces[0].is_none() || edge.faces[1].is_none()) continue;
            const auto& [a, b, c] = scene_[edge.faces[0]].plane;
            for (const VertexId v : scene_[edge.faces[1]].plane) {
                if (v == edge.source || v == edge.target) continue;
                if (is_nearly_coplanar(scene_[a], scene_[b], scene_[c], scene_[v])) {
                    info_.nearly_flat.push_back(EdgeId{e});
                    break;
                }
            }
        }
    }

    // Whether moving d by 4 ulps of its coordinates could bring it into the plane; a hint, computed in doubles.
    static bool is_nearly_coplanar(const Point3& a, const Point3& b, const Point3& c,
                                   const Point3& d) {
        const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
        const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
        const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
        const auto ulps = [](double x) {
            return 4 * std::abs(x) * std::numeric_limits<double>::epsilon();
        };
        const double change =
            std::abs(nx) * ulps(d.x) + std::abs(ny) * ulps(d.y) + std::abs(nz) * ulps(d.z);
        const double distance = nx * (d.x - a.x) + ny * (d.y - a.y) + nz * (d.z - a.z);
        if (!(std::abs(distance) <= 64 * change)) return false;
        const Key n = cross(difference(b, a), difference(c, a));
        const Key w = difference(d, a);
        const Rational exact = abs(n[0] * w[0] + n[1] * w[1] + n[2] * w[2]);
        return exact.sign() != Sign::zero && exact.approx_double() <= change;
    }

    BodyContact3& contact(BodyId a, BodyId b) {
        const auto pair = std::minmax(a, b);
        BodyContact3& found = contacts_[pair];
        found.first = pair.first;
        found.second = pair.second;
        return found;
    }
    [[nodiscard]] BodyId body_of(std::uint32_t triangle) const {
        return scene_[scene_.triangles()[triangle].face].body;
    }

    void find_contacts() {
        const SceneBoxTree3 tree = triangle_tree();
        touch_in_vertices(tree);
        touch_in_edges();
        touch_in_faces(tree);
        for (const auto& [pair, found] : contacts_) info_.contacts.push_back(found);
    }

    void touch_in_vertices(const SceneBoxTree3& tree) {
        std::set<Point3> places;
        for (std::uint32_t v = 0; v < scene_.vertices().size(); ++v)
            if (scene_.is_feature(VertexId{v})) places.insert(scene_[VertexId{v}]);
        for (const Point3& p : places) {
            std::map<BodyId, std::vector<detail::ConeTriangle>> around;
            tree.query(SceneBox3::of(p), [&](std::uint32_t t) {
                const Corners3 corners = corners_of(t);
                if (!detail::is_on(corners, p)) return;
                std::uint32_t vertex = std::numeric_limits<std::uint32_t>::max();
                for (std::size_t i = 0; i < 3; ++i)
                    if (corners[i] == p) vertex = scene_.triangles()[t].corners[i].value;
                const bool is_sheet = scene_[body_of(t)].kind == SurfaceKind::sheet;
                around[body_of(t)].push_back({corners, t, vertex, is_sheet});
            });
            for (auto a = around.begin(); a != around.end(); ++a) {
                if (!detail::look_around(p, a->second).is_simple)
                    ++contact(a->first, a->first).places;
                for (auto b = std::next(a); b != around.end(); ++b)
                    ++contact(a->first, b->first).places;
            }
        }
    }

    void touch_in_edges() {
        std::vector<SceneBox3> boxes;
        for (const Edge3& e : scene_.edges()) {
            boxes.push_back(SceneBox3::of(scene_[e.source]));
            boxes.back().include(SceneBox3::of(scene_[e.target]));
        }
        const SceneBoxTree3 tree(std::move(boxes));
        for (std::uint32_t i = 0; i < scene_.edges().size(); ++i)
            tree.query(tree.box(i), [&](std::uint32_t j) {
                if (i < j) compare(scene_[EdgeId{i}], scene_[EdgeId{j}]);
            });
    }

    void compare(const Edge3& e, const Edge3& f) {
        const Point3 &a = scene_[e.source], &b = scene_[e.target], &c = scene_[f.source],
                     &d = scene_[f.target];
        const bool same_ends = std::minmax(e.source, e.target) == std::minmax(f.source, f.target);
        if ((e.body == f.body && same_ends) || orientation3(a, b, c, d) != Sign::zero) return;
        if (detail::are_collinear(a, b, c) && detail::are_collinear(a, b, d)) {
            const auto [low, high] = std::minmax(a, b, less);
            const auto [from, to] = std::minmax(c, d, less);
            if (std::max(low, from, less) < std::min(high, to, less))
                ++contact(e.body, f.body).edges;
            return;
        }
        for (int axis = 0; axis < 3; ++axis) {
            const Segment2 s{drop(a, axis), drop(b, axis)}, t{drop(c, axis), drop(d, axis)};
            if (orientation(s.source, s.target, t.source) == Sign::zero &&
                orientation(s.source, s.target, t.target) == Sign::zero)
                continue;
            if (crossing(s, t) == SegmentCrossing::proper) ++contact(e.body, f.body).places;
            return;
        }
    }
    static bool less(const Point3& a, const Point3& b) { return a < b; }

    void touch_in_faces(const SceneBoxTree3& tree) {
        std::set<std::pair<FaceId, FaceId>> pairs;
        for (std::uint32_t t = 0; t < scene_.triangles().size(); ++t)
            tree.query(tree.box(t), [&](std::uint32_t u) {
                const FaceId f = scene_.triangles()[t].face;
                const FaceId g = scene_.triangles()[u].face;
                if (f < g && !pairs.contains({f, g}) && overlap(corners_of(t), corners_of(u)))
                    pairs.insert({f, g});
            });
        for (const auto& [f, g] : pairs) ++contact(scene_[f].body, scene_[g].body).faces;
    }

    /// Whether two triangles of one plane have a common piece: none of their sides separates them.
    static bool overlap(const Corners3& a, const Corners3& b) {
        for (const Point3& p : b)
            if (orientation3(a[0], a[1], a[2], p) != Sign::zero) return false;
        const auto plane = detail::Plane3::through(a[0], a[1], a[2]);
        const auto separates = [&](const Corners3& c, const Corners3& other) {
            const Sign sense = plane.turn(c[0], c[1], c[2]);
            for (std::size_t i = 0; i < 3; ++i) {
                const bool outside = std::all_of(other.begin(), other.end(), [&](const Point3& p) {
                    return plane.turn(c[i], c[(i + 1) % 3], p) != sense;
                });
                if (outside) return true;
            }
            return false;
        };
        return !separates(a, b) && !separates(b, a);
    }

    const Scene3& scene_;
    SceneInfo3 info_;
    std::map<std::pair<BodyId, BodyId>, BodyContact3> contacts_;
};

template <typename List, typename Show>
void append_list(std::string& out, std::string_view name, const List& list, const Show& show) {
    if (list.empty()) return;
    out += fmt::format("{}: {} (", name, list.size());
    constexpr std::size_t most = 8;
    for (std::size_t i = 0; i < std::min(list.size(), most); ++i) {
        if (i > 0) out += ", ";
        out += show(list[i]);
    }
    out += list.size() > most ? ", …)\n" : ")\n";
}

}  // namespace

bool SceneInfo3::is_degenerate() const noexcept {
    return !contacts.empty() || !coincident.empty() || !isolated.empty() || !flat.empty() ||
           !coplanar.empty() || !collinear.empty() || !nearly_flat.empty();
}

SceneInfo3 describe(const Scene3& scene) { return Describer3(scene).run(); }

std::string to_text(const SceneInfo3& info) {
    std::string out = fmt::format(
        "vertices: {} ({} features)\nedges: {} ({} on borders)\nfaces: {} (of {} in the input; {} "
        "holes, {} "
        "triangles)\nsolids: {}\nsheets: {}\nworld: {}\n",
        info.vertices, info.feature_vertices, info.edges, info.border_edges, info.faces,
        info.input_faces, info.holes, info.triangles, info.solids, info.sheets,
        info.has_world ? "yes" : "no");
    out += fmt::format("box: ({}, {}, {}) to ({}, {}, {})\n", info.low.x, info.low.y, info.low.z,
                       info.high.x, info.high.y, info.high.z);
    out += fmt::format("shortest edge: about {:.3g}, extent: about {:.3g}\n",
                       info.approx_shortest_edge, info.approx_extent);
    const auto id = [](auto x) { return to_string(x); };
    const auto group = [](const auto& list) {
        return fmt::format("{} with {}", list.size(), to_string(list[0]));
    };
    append_list(out, "touching bodies", info.contacts, [](const BodyContact3& c) {
        return fmt::format("{}-{} {} places {} edges {} faces", to_string(c.first),
                           to_string(c.second), c.places, c.edges, c.faces);
    });
    append_list(out, "places with several vertices", info.coincident, group);
    append_list(out, "vertices on no surface", info.isolated, id);
    append_list(out, "vertices that are no features", info.flat, id);
    append_list(out, "planes with several faces", info.coplanar, group);
    append_list(out, "lines with several edges", info.collinear, group);
    append_list(out, "edges between nearly coplanar faces", info.nearly_flat, id);
    if (info.parallel_edges > 0)
        out += fmt::format("parallel edges: {} in {} directions\n", info.parallel_edges,
                           info.parallel_directions);
    if (!info.is_degenerate() && info.parallel_edges == 0) out += "degeneracies: none\n";
    return out;
}

std::ostream& operator<<(std::ostream& out, const SceneInfo3& info) { return out << to_text(info); }

}  // namespace sightline
