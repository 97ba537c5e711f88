// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/reference/view3.hpp"

#include <algorithm>
#include <map>
#include <ostream>
#include <set>

#include "sightline/reference/free_segment3.hpp"

namespace sightline::reference {
namespace {

using Kind = ViewRegion::Kind;

class Looker {
public:
    Looker(const Scene3& scene, const Viewpoint3& from) : scene_(scene), from_(from) {
        for (const Point3& p : scene.vertices()) points_.push_back(to_rational(p));
        const Vector3 d = vector_to(from.coordinates);
        if (!from.at_infinity) return;
        Rational low = dot(d, vector_to(points_.front()));
        Rational high = low;
        for (const RationalPoint3& p : points_) {
            const Rational at = dot(d, vector_to(p));
            low = std::min(low, at);
            high = std::max(high, at);
        }
        distance_ = (high - low) / dot(d, d) + 1;
    }

    ViewLabels3 look() {
        for (std::uint32_t v = 0; v < points_.size(); ++v) {
            if (!scene_.is_feature(VertexId{v}) || is_here(points_[v])) continue;
            if (sees(points_[v])) nodes_.insert(label_of(points_[v]));
        }
        // A place that is a node for one edge is one for all edges over it.
        for (const bool draws : {false, true}) {
            for (std::uint32_t e = 0; e < scene_.edges().size(); ++e) look_at(EdgeId{e}, draws);
        }
        ViewLabels3 labels;
        labels.nodes.assign(nodes_.begin(), nodes_.end());
        labels.arcs.assign(arcs_.begin(), arcs_.end());
        return labels;
    }

private:
    [[nodiscard]] const RationalPoint3& source(EdgeId e) const {
        return points_[scene_[e].source.index()];
    }
    [[nodiscard]] const RationalPoint3& target(EdgeId e) const {
        return points_[scene_[e].target.index()];
    }
    [[nodiscard]] bool is_here(const RationalPoint3& x) const {
        return !from_.at_infinity && x == from_.coordinates;
    }
    /// The direction of sight through x.
    [[nodiscard]] Vector3 sight(const RationalPoint3& x) const {
        return from_.at_infinity ? vector_to(from_.coordinates) : x - from_.coordinates;
    }
    [[nodiscard]] RationalPoint3 start(const RationalPoint3& x) const {
        if (!from_.at_infinity) return from_.coordinates;
        return x + (-distance_) * vector_to(from_.coordinates);
    }
    [[nodiscard]] bool sees(const RationalPoint3& x) const { return is_free(scene_, start(x), x); }

    /// Normal of the plane of sight through two points, to the left of a→b as seen.
    [[nodiscard]] Vector3 left_of(const RationalPoint3& a, const RationalPoint3& b) const {
        return from_.at_infinity ? cross(b - a, vector_to(from_.coordinates))
                                 : cross(sight(b), sight(a));
    }
    /// Whether two points are on one line of sight.
    [[nodiscard]] bool same_sight(const RationalPoint3& x, const RationalPoint3& y) const {
        if (from_.at_infinity) return cross(y - x, sight(x)).is_zero();
        return cross(sight(x), sight(y)).is_zero() &&
               dot(sight(x), sight(y)).sign() == Sign::positive;
    }
    /// Where the line of sight through x meets the inside of an edge that it does not run along.
    [[nodiscard]] std::optional<RationalPoint3> meets(const RationalPoint3& x, EdgeId e) const {
        const Vector3 normal = left_of(source(e), target(e));
        if (normal.is_zero() || dot(normal, x - source(e)).sign() != Sign::zero) return {};
        // In the plane of sight, a plane through the line of sight only.
        const Vector3 across = cross(sight(x), normal);
        const Rational a = dot(across, source(e) - x);
        const Rational b = dot(across, target(e) - x);
        if (a.sign() * b.sign() != Sign::negative) return {};
        const RationalPoint3 y = source(e) + (a / (a - b)) * (target(e) - source(e));
        if (!same_sight(x, y)) return {};
        return y;
    }

    ViewNode label_of(const RationalPoint3& x) const {
        ViewNode node;
        for (std::uint32_t v = 0; v < points_.size(); ++v) {
            if (!scene_.is_feature(VertexId{v}) || is_here(points_[v])) continue;
            if (same_sight(x, points_[v]) && sees(points_[v])) node.vertices.push_back(VertexId{v});
        }
        node.edges = edges_over(x);
        return node;
    }
    std::vector<EdgeId> edges_over(const RationalPoint3& x) const {
        std::vector<EdgeId> edges;
        for (std::uint32_t e = 0; e < scene_.edges().size(); ++e) {
            const auto y = meets(x, EdgeId{e});
            if (y && sees(*y)) edges.push_back(EdgeId{e});
        }
        return edges;
    }
    [[nodiscard]] bool cross_in_image(EdgeId e, EdgeId f) const {
        return !cross(left_of(source(e), target(e)), left_of(source(f), target(f))).is_zero();
    }

    /// Parameters of an edge at which other features' images may lie.
    std::set<Rational> cuts(EdgeId e) const {
        const RationalPoint3& u = source(e);
        const Vector3 d = target(e) - u;
        const Vector3 own = left_of(u, target(e));
        std::set<Rational> cuts{0, 1};
        const auto cut_with = [&](const Vector3& normal, const RationalPoint3& x) {
            const Rational slope = dot(normal, d);
            if (slope.sign() == Sign::zero) return;
            const Rational t = dot(normal, x - u) / slope;
            if (t.sign() == Sign::positive && t < Rational(1)) cuts.insert(t);
        };
        const auto cut_through = [&](const RationalPoint3& x) {
            if (!is_here(x) && dot(own, x - u).sign() == Sign::zero)
                cut_with(cross(sight(x), own), x);
        };
        for (const RationalPoint3& v : points_) cut_through(v);
        for (std::uint32_t i = 0; i < scene_.edges().size(); ++i) {
            const EdgeId f{i};
            cut_with(left_of(source(f), target(f)), source(f));
            if (dot(own, source(f) - u).sign() != Sign::zero) continue;
            if (dot(own, target(f) - u).sign() != Sign::zero) continue;
            // Edges in the plane of sight: where they cross each other.
            for (std::uint32_t j = 0; j < i; ++j) {
                const EdgeId g{j};
                const Vector3 flat = cross(own, target(g) - source(g));
                const Rational slope = dot(flat, target(f) - source(f));
                if (slope.sign() == Sign::zero) continue;
                const Rational t = dot(flat, source(g) - source(f)) / slope;
                cut_through(source(f) + t * (target(f) - source(f)));
            }
        }
        return cuts;
    }

    struct Seen {
        RationalPoint3 at;
        bool place = false;
        bool gap = false;  ///< the piece that follows
        RationalPoint3 middle;
    };

    /// One name for all points on a line of sight.
    [[nodiscard]] Vector3 direction_key(const RationalPoint3& x) const {
        const Vector3 d = sight(x);
        if (from_.at_infinity) return vector_to(x) - (dot(d, vector_to(x)) / dot(d, d)) * d;
        const Rational size = abs(d.x) + abs(d.y) + abs(d.z);
        return (Rational(1) / size) * d;
    }

    void look_at(EdgeId e, bool draws) {
        if (left_of(source(e), target(e)).is_zero()) return;
        const auto at = [&](const Rational& t) { return source(e) + t * (target(e) - source(e)); };
        std::vector<Seen> seen;
        const auto all = cuts(e);
        for (auto t = all.begin(); t != all.end(); ++t) {
            Seen s{at(*t), false, false, {}};
            s.place = sees(s.at);
            if (std::next(t) != all.end()) {
                s.middle = at((*t + *std::next(t)) / 2);
                s.gap = sees(s.middle);
            }
            seen.push_back(std::move(s));
        }
        std::optional<ViewNode> last;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            if (!seen[i].place) continue;
            const bool before = i > 0 && seen[i - 1].gap;
            ViewNode node = label_of(seen[i].at);
            const bool is_node = !before || !seen[i].gap || !node.vertices.empty() ||
                                 std::any_of(node.edges.begin(), node.edges.end(),
                                             [&](EdgeId f) { return cross_in_image(e, f); });
            if (is_node) places_.insert(direction_key(seen[i].at));
            if (!is_node && !(draws && places_.contains(direction_key(seen[i].at)))) continue;
            const bool is_end = i == 0 || i + 1 == seen.size();
            if (is_end || before || seen[i].gap || !node.edges.empty()) nodes_.insert(node);
            if (draws && last && before) add_arc(e, *last, node, seen[i - 1].middle);
            last = node;
        }
    }

    void add_arc(EdgeId e, const ViewNode& from, const ViewNode& to, const RationalPoint3& middle) {
        ViewLabels3::Arc arc;
        arc.edges = edges_over(middle);
        arc.source = from;
        arc.target = to;
        const Vector3 left = left_of(source(e), target(e));
        std::tie(arc.left_kind, arc.left) = beside(middle, left);
        std::tie(arc.right_kind, arc.right) = beside(middle, -left);
        if (arc.target < arc.source) {
            std::swap(arc.source, arc.target);
            std::swap(arc.left, arc.right);
            std::swap(arc.left_kind, arc.right_kind);
        }
        arcs_.insert(std::move(arc));
    }

    /// What is seen aside of x, nearer than any other edge's plane of sight.
    std::pair<Kind, SegmentEnd> beside(const RationalPoint3& x, const Vector3& aside) const {
        Rational step(1);
        for (std::uint32_t i = 0; i < scene_.edges().size(); ++i) {
            const Vector3 normal = left_of(source(EdgeId{i}), target(EdgeId{i}));
            const Rational slope = dot(normal, aside);
            if (slope.sign() == Sign::zero) continue;
            const Rational at = dot(normal, source(EdgeId{i}) - x) / slope;
            if (at.sign() == Sign::positive) step = std::min(step, at);
        }
        const RationalPoint3 y = x + (step / 2) * aside;
        const FreeEnd3 end = first_hit(scene_, start(y), sight(y));
        if (!end.point) return {Kind::infinity, {}};
        if (*end.point == start(y)) return {Kind::blocked, {}};
        return {Kind::face, end.faces};
    }

    const Scene3& scene_;
    const Viewpoint3& from_;
    std::vector<RationalPoint3> points_;
    Rational distance_;
    std::set<ViewNode> nodes_;
    std::set<Vector3> places_;
    std::set<ViewLabels3::Arc> arcs_;
};

void write(std::ostream& out, const ViewNode& node) {
    const char* separator = "";
    for (const auto v : node.vertices) {
        out << separator << to_string(v);
        separator = " ";
    }
    for (const auto e : node.edges) {
        out << separator << to_string(e);
        separator = " ";
    }
}

void write(std::ostream& out, Kind kind, const SegmentEnd& end) {
    if (kind == Kind::infinity) out << " infinity";
    if (kind == Kind::blocked) out << " blocked";
    if (kind == Kind::outside) out << " outside";
    for (const FaceSide& f : end) out << ' ' << to_string(f.face) << (f.back ? "-" : "");
}

}  // namespace

ViewLabels3 labels_of(const View3& view) {
    ViewLabels3 labels;
    const ViewMap3& map = view.map;
    labels.nodes = map.nodes;
    for (const ViewArc& a : map.arcs) {
        const ViewRegion& left = map.regions[a.left];
        const ViewRegion& right = map.regions[a.right];
        labels.arcs.push_back({a.edges, map.nodes[a.source], map.nodes[a.target], left.kind,
                               right.kind, left.faces, right.faces});
    }
    std::sort(labels.arcs.begin(), labels.arcs.end());
    return labels;
}

ViewLabels3 view3(const Scene3& scene, const Viewpoint3& from) {
    return Looker(scene, from).look();
}

std::ostream& operator<<(std::ostream& out, const ViewLabels3& labels) {
    for (const ViewNode& node : labels.nodes) {
        out << "node ";
        write(out, node);
        out << '\n';
    }
    for (const auto& arc : labels.arcs) {
        out << "arc";
        for (const EdgeId e : arc.edges) out << ' ' << to_string(e);
        out << " from ";
        write(out, arc.source);
        out << " to ";
        write(out, arc.target);
        out << " left";
        write(out, arc.left_kind, arc.left);
        out << " right";
        write(out, arc.right_kind, arc.right);
        out << '\n';
    }
    return out;
}

}  // namespace sightline::reference
