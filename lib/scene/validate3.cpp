// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/validate3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "scene/cone3.hpp"
#include "scene/union_find.hpp"
#include "scene/winding3.hpp"
#include "sightline/arith/interval.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

/// The point in which two segments that cross in their plane meet.
RationalPoint3 meeting_point(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    const RationalPoint3 p = to_rational(a), q = to_rational(b), r = to_rational(c),
                         s = to_rational(d);
    for (int axis = 2;; --axis) {
        const RationalPoint2 p2 = drop(p, axis), q2 = drop(q, axis), r2 = drop(r, axis),
                             s2 = drop(s, axis);
        const Rational ux = q2.x - p2.x, uy = q2.y - p2.y;
        const Rational vx = s2.x - r2.x, vy = s2.y - r2.y;
        const Rational cross = ux * vy - uy * vx;
        if (cross.sign() == Sign::zero && axis > 0) continue;
        const Rational t = ((r2.x - p2.x) * vy - (r2.y - p2.y) * vx) / cross;
        return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)};
    }
}

class Validator {
public:
    Validator(const Mesh3& mesh, const Features3& features, const std::vector<Triangle3>& triangles)
        : mesh_(mesh),
          features_(features),
          triangles_(triangles),
          tree_(boxes()),
          clusters_(mesh.component_count) {
        for (const Triangle3& t : triangles_) corners_.push_back(corners_of(t));
    }

    Result<Nesting3> run() {
        group_components();
        if (const auto ok = check_signs(); !ok) return tl::unexpected(ok.error());
        if (const auto ok = look_at_vertices(); !ok) return tl::unexpected(ok.error());
        if (const auto ok = look_at_edges(); !ok) return tl::unexpected(ok.error());
        if (const auto ok = check_clusters(); !ok) return tl::unexpected(ok.error());
        if (const auto ok = find_owners(); !ok) return tl::unexpected(ok.error());
        return std::move(nesting_);
    }

private:
    struct Component {
        std::vector<Corners3> triangles;
        std::uint32_t first_face = 0;  ///< an input face
        Point3 least;                  ///< of its corners
        Sign volume = Sign::zero;
        bool is_sheet = false;
        bool is_world = false;
        std::uint32_t mesh = 0;
    };

    [[nodiscard]] Corners3 corners_of(const Triangle3& t) const {
        return {at(t.corners[0]), at(t.corners[1]), at(t.corners[2])};
    }
    [[nodiscard]] std::vector<SceneBox3> boxes() const {
        std::vector<SceneBox3> result;
        result.reserve(triangles_.size());
        for (const Triangle3& t : triangles_) result.push_back(box_of(corners_of(t)));
        return result;
    }
    [[nodiscard]] const Point3& at(VertexId v) const { return mesh_.vertices[v.index()]; }
    [[nodiscard]] std::uint32_t component_of(std::uint32_t triangle) const {
        return features_.faces[triangles_[triangle].face.index()].body.value;
    }
    [[nodiscard]] std::uint32_t input_face(std::uint32_t triangle) const {
        return features_.faces[triangles_[triangle].face.index()].input_faces.front();
    }

    void group_components() {
        components_.resize(mesh_.component_count);
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            Component& component = components_[component_of(t)];
            if (component.triangles.empty()) {
                component.first_face = input_face(t);
                component.is_sheet = mesh_.is_sheet(component.first_face);
                component.is_world = mesh_.is_world(component.first_face);
                component.mesh = mesh_.mesh_of_face[component.first_face];
                component.least = corners_[t][0];
            }
            component.triangles.push_back(corners_[t]);
            for (const Point3& p : corners_[t])
                if (p < component.least) component.least = p;
        }
        for (Component& component : components_)
            if (!component.is_sheet) component.volume = sign_of_volume(component.triangles);
        nesting_.owner.resize(components_.size());
        for (std::uint32_t c = 0; c < components_.size(); ++c) nesting_.owner[c] = c;
    }

    /// A mesh whose solids all look inwards, or a world that has no outer boundary.
    Result<void> check_signs() const {
        for (std::uint32_t m = 0; m < mesh_.input->meshes.size(); ++m) {
            const Component* odd = nullptr;
            bool fine = false;
            for (const Component& component : components_) {
                if (component.mesh != m || component.is_sheet) continue;
                const Sign wanted = component.is_world ? Sign::negative : Sign::positive;
                fine = fine || component.volume == wanted;
                if (odd == nullptr && component.volume == -wanted) odd = &component;
            }
            if (odd != nullptr && !fine) return looks_inwards(*odd);
        }
        return {};
    }

    [[nodiscard]] tl::unexpected<Error> looks_inwards(const Component& component) const {
        return fail(
            Errc::wrong_orientation,
            mesh_.name_of_face(component.first_face) +
                ": the solid with this face looks inwards (clockwise from outside); turn its faces "
                "(repair does)");
    }

    [[nodiscard]] std::string where(const Point3& p) const {
        return fmt::format("({}, {}, {})", p.x, p.y, p.z);
    }

    [[nodiscard]] tl::unexpected<Error> meet_wrongly(std::uint32_t t, std::uint32_t u,
                                                     const Point3& near,
                                                     ConeFault::Kind kind) const {
        if (input_face(u) < input_face(t)) std::swap(t, u);
        const Component& a = components_[component_of(t)];
        const Component& b = components_[component_of(u)];
        const std::string first = mesh_.name_of_face(input_face(t));
        const std::string second = a.mesh == b.mesh ? mesh_.short_name_of_face(input_face(u))
                                                    : mesh_.name_of_face(input_face(u));
        const std::string place = where(near);
        if (a.is_sheet || b.is_sheet) {
            const char* text =
                a.is_sheet && b.is_sheet ? "{}: crosses {} near {}; split sheets where they cross"
                : kind == ConeFault::Kind::inside
                    ? "{}: meets {} near {}, and the sheet is inside the solid there; cut it off"
                    : "{}: crosses {} near {}; cut the sheet off where it enters the solid";
            return fail(Errc::sheet_crosses, fmt::format(fmt::runtime(text), first, second, place));
        }
        if (component_of(t) == component_of(u)) {
            return fail(
                Errc::self_intersection,
                fmt::format("{}: meets {} of the same solid near {} so that it intersects itself; "
                            "separate the two",
                            first, second, place));
        }
        if (a.is_world || b.is_world) {
            return fail(Errc::outside_world,
                        fmt::format("{}: meets {} near {}, and the body reaches out of the "
                                    "world there; move or cut it",
                                    first, second, place));
        }
        return fail(Errc::body_overlap,
                    fmt::format("{}: meets {} near {}, and the bodies overlap there; separate "
                                "or unite them",
                                first, second, place));
    }

    /// All triangles that contain a place, looked at from it.
    template <typename P>
    Result<void> look_at(const P& p, const SceneBox3& box, const Point3& near) {
        around_.clear();
        tree_.query(box, [&](std::uint32_t t) {
            if (!is_on(corners_[t], p)) return;
            std::uint32_t vertex = no_index;
            if constexpr (std::is_same_v<P, Point3>) {
                for (std::size_t i = 0; i < 3; ++i)
                    if (corners_[t][i] == p) vertex = triangles_[t].corners[i].value;
            }
            around_.push_back({corners_[t], t, vertex, components_[component_of(t)].is_sheet});
        });
        const ConeReport report = look_around(p, around_);
        if (report.fault)
            return meet_wrongly(report.fault->first, report.fault->second, near,
                                report.fault->kind);
        for (const ConeTriangle& t : around_)
            clusters_.join(component_of(t.id), component_of(around_[0].id));
        nesting_.touching = nesting_.touching || !report.is_regular;
        return {};
    }

    Result<void> look_at_vertices() {
        std::vector<Point3> places;
        for (const Edge3& edge : features_.edges)
            for (const VertexId v : {edge.source, edge.target}) places.push_back(at(v));
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end()), places.end());
        for (const Point3& p : places)
            if (const auto ok = look_at(p, SceneBox3::of(p), p); !ok) return ok;
        return {};
    }

    /// Where edges cross edges the surfaces are looked at; an edge that crosses the inside of a face is wrong.
    Result<void> look_at_edges() {
        for (const Edge3& edge : features_.edges)
            is_edge_.insert(std::minmax(edge.source.value, edge.target.value));
        for (std::uint32_t e = 0; e < features_.edges.size(); ++e) {
            const Edge3& edge = features_.edges[e];
            SceneBox3 box = SceneBox3::of(at(edge.source));
            box.include(SceneBox3::of(at(edge.target)));
            std::optional<std::uint32_t> pierced;
            tree_.query(box, [&](std::uint32_t t) {
                if (!pierced && !only_ends_meet(box, tree_.box(t)) && crosses_inside(edge, t))
                    pierced = t;
            });
            if (pierced) return pierces(edge, *pierced);
        }
        std::sort(crossings_.begin(), crossings_.end());
        crossings_.erase(std::unique(crossings_.begin(), crossings_.end()), crossings_.end());
        for (const RationalPoint3& p : crossings_) {
            const Interval x = enclosure(p.x), y = enclosure(p.y), z = enclosure(p.z);
            const SceneBox3 box{{x.lower, y.lower, z.lower}, {x.upper, y.upper, z.upper}};
            if (const auto ok = look_at(p, box, approx_point(p)); !ok) return ok;
        }
        return {};
    }

    /// Whether all that an edge's box has in common with a triangle's holds no inner point of the edge.
    [[nodiscard]] static bool only_ends_meet(const SceneBox3& edge, const SceneBox3& triangle) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (edge.low[i] == edge.high[i]) continue;
            if (edge.high[i] == triangle.low[i] || edge.low[i] == triangle.high[i]) return true;
        }
        return false;
    }

    [[nodiscard]] tl::unexpected<Error> pierces(const Edge3& edge, std::uint32_t t) const {
        const FaceId face = edge.faces[0].is_none() ? edge.faces[1] : edge.faces[0];
        const auto own = std::find_if(triangles_.begin(), triangles_.end(),
                                      [&](const Triangle3& u) { return u.face == face; });
        const Point3& near = at(edge.source);
        return meet_wrongly(static_cast<std::uint32_t>(own - triangles_.begin()), t, near,
                            ConeFault::Kind::crossing);
    }

    /// Whether the edge passes through the inside of a face at the triangle. Notes where it crosses other edges.
    bool crosses_inside(const Edge3& edge, std::uint32_t t) {
        const FaceId face = triangles_[t].face;
        if (face == edge.faces[0] || face == edge.faces[1]) return false;
        const Corners3& c = corners_[t];
        const Point3& a = at(edge.source);
        const Point3& b = at(edge.target);
        const Sign a_side = orientation3(c[0], c[1], c[2], a);
        const Sign b_side = orientation3(c[0], c[1], c[2], b);
        if (a_side == Sign::zero && b_side == Sign::zero) {
            note_crossings_in_plane(edge, t);
            return false;
        }
        if (a_side * b_side != Sign::negative) return false;
        std::array<Sign, 3> turn{};
        int zeros = 0;
        std::size_t side = 0;  // the one that is crossed
        for (std::size_t i = 0; i < 3; ++i) {
            turn[i] = orientation3(a, b, c[i], c[(i + 1) % 3]);
            if (turn[i] != Sign::zero) continue;
            ++zeros;
            side = i;
        }
        if (zeros > 1) return false;  // through a corner, which is looked at as a vertex
        const Sign x = turn[(side + 1) % 3];
        const Sign y = turn[(side + 2) % 3];
        if (x != y || (zeros == 0 && turn[side] != x)) return false;
        if (zeros == 0 || !is_feature(t, side)) return true;
        crossings_.push_back(meeting_point(a, b, c[side], c[(side + 1) % 3]));
        return false;
    }

    [[nodiscard]] bool is_feature(std::uint32_t t, std::size_t side) const {
        return is_edge_.contains(std::minmax(triangles_[t].corners[side].value,
                                             triangles_[t].corners[(side + 1) % 3].value));
    }

    void note_crossings_in_plane(const Edge3& edge, std::uint32_t t) {
        const Corners3& c = corners_[t];
        const Plane3 plane = Plane3::through(c[0], c[1], c[2]);
        const Segment2 own{drop(at(edge.source), plane.axis), drop(at(edge.target), plane.axis)};
        for (std::size_t i = 0; i < 3; ++i) {
            const Segment2 other{drop(c[i], plane.axis), drop(c[(i + 1) % 3], plane.axis)};
            if (is_feature(t, i) && crossing(own, other) == SegmentCrossing::proper)
                crossings_.push_back(
                    meeting_point(at(edge.source), at(edge.target), c[i], c[(i + 1) % 3]));
        }
    }

    /// How often each component surrounds a point that lies on none of those that count.
    template <typename Counts>
    [[nodiscard]] std::map<std::uint32_t, int> winding(const Point3& p,
                                                       const Counts& counts) const {
        std::map<std::uint32_t, int> result;
        SceneBox3 ray = SceneBox3::of(p);
        ray.low[0] = -std::numeric_limits<double>::infinity();
        tree_.query(ray, [&](std::uint32_t t) {
            const std::uint32_t c = component_of(t);
            if (!components_[c].is_sheet && counts(c)) result[c] += winding_step(corners_[t], p);
        });
        return result;
    }

    struct Cluster {
        std::vector<Corners3> triangles;  ///< of solids
        std::uint32_t least = no_index;   ///< the component with the least corner
        Sign volume = Sign::zero;
    };

    Result<void> check_clusters() {
        std::map<std::uint32_t, Cluster> clusters;
        for (std::uint32_t c = 0; c < components_.size(); ++c) {
            Cluster& cluster = clusters[clusters_.root(c)];
            const Component& component = components_[c];
            if (cluster.least == no_index || component.least < components_[cluster.least].least)
                cluster.least = c;
            if (!component.is_sheet)
                cluster.triangles.insert(cluster.triangles.end(), component.triangles.begin(),
                                         component.triangles.end());
        }
        for (auto& [root, cluster] : clusters) cluster.volume = sign_of_volume(cluster.triangles);
        // What looks inwards first: it makes others look misplaced.
        for (const bool inwards : {true, false})
            for (const auto& [root, cluster] : clusters)
                if ((cluster.volume == Sign::negative) == inwards)
                    if (const auto ok = check_cluster(root, cluster); !ok) return ok;
        return {};
    }

    Result<void> check_cluster(std::uint32_t root, const Cluster& cluster) {
        const Component& component = components_[cluster.least];
        const auto around =
            winding(component.least, [&](std::uint32_t c) { return clusters_.root(c) != root; });
        int count = mesh_.input->world ? 1 : 0;
        const Component* inside = nullptr;
        for (const auto& [c, times] : around) {
            count += times;
            if (times > 0 && (inside == nullptr || inside->least < components_[c].least))
                inside = &components_[c];
        }
        if (cluster.volume == Sign::negative)
            return count == 1 ? Result<void>{} : looks_inwards(component);
        // A cavity and what fills it; or a solid and its double, turned.
        if (cluster.volume == Sign::zero && !cluster.triangles.empty()) {
            if (count == 1) return {};
            return fail(Errc::body_overlap, mesh_.name_of_face(component.first_face) +
                                                ": the solid with this face and others cover each "
                                                "other; remove all but one");
        }
        if (count == 0) return {};
        const std::string name = mesh_.name_of_face(component.first_face);
        const char* what = component.is_sheet ? "sheet" : "solid";
        if (inside == nullptr) {
            return fail(
                Errc::outside_world,
                fmt::format(
                    "{}: the {} with this face lies outside of the world; move or remove it", name,
                    what));
        }
        return fail(
            component.is_sheet ? Errc::sheet_crosses : Errc::body_overlap,
            fmt::format(
                "{}: the {} with this face lies inside the solid with {}; move or remove one of "
                "them, or turn the faces of the inner one to make it a cavity",
                name, what, mesh_.name_of_face(inside->first_face)));
    }

    /// What looks inwards bounds a cavity of the innermost solid of its file that surrounds it.
    Result<void> find_owners() {
        for (std::uint32_t c = 0; c < components_.size(); ++c) {
            const Component& component = components_[c];
            if (component.is_sheet || component.is_world || component.volume == Sign::positive)
                continue;
            const auto around = winding(free_corner(c), [&](std::uint32_t d) {
                return d != c && components_[d].mesh == component.mesh;
            });
            std::uint32_t owner = no_index;
            for (const auto& [d, times] : around) {
                if (times <= 0 || components_[d].volume != Sign::positive) continue;
                if (owner == no_index || components_[owner].least < components_[d].least) owner = d;
            }
            if (owner == no_index) return looks_inwards(component);
            nesting_.owner[c] = owner;
        }
        return {};
    }

    /// A corner of the component that lies on no other component, or its least one.
    [[nodiscard]] Point3 free_corner(std::uint32_t c) const {
        for (const Corners3& triangle : components_[c].triangles) {
            for (const Point3& p : triangle) {
                bool is_free = true;
                tree_.query(SceneBox3::of(p), [&](std::uint32_t t) {
                    if (component_of(t) != c && is_on(corners_[t], p)) is_free = false;
                });
                if (is_free) return p;
            }
        }
        return components_[c].least;
    }

    const Mesh3& mesh_;
    const Features3& features_;
    const std::vector<Triangle3>& triangles_;
    std::vector<Corners3> corners_;
    SceneBoxTree3 tree_;
    std::vector<Component> components_;
    UnionFind clusters_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> is_edge_;
    std::vector<ConeTriangle> around_;
    std::vector<RationalPoint3> crossings_;
    Nesting3 nesting_;
};

}  // namespace

Result<Nesting3> validate(const Mesh3& mesh, const Features3& features,
                          const std::vector<Triangle3>& triangles) {
    return Validator(mesh, features, triangles).run();
}

}  // namespace sightline::detail
