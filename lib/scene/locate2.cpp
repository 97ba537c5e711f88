// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/locate2.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sightline/geom/predicates2.hpp"

namespace sightline {
namespace {

/// A rational point next to doubles: most comparisons need only the neighbours of its nearest double.
class QueryPoint {
public:
    explicit QueryPoint(const RationalPoint2& p) : p_(p) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const double nearest = p.x.approx_double();
        low_ = std::nextafter(nearest, -infinity);
        high_ = std::nextafter(nearest, infinity);
    }

    /// Lexicographic order of q and this point.
    [[nodiscard]] std::strong_ordering compare(const Point2& q) const {
        if (q.x < low_) return std::strong_ordering::less;
        if (q.x > high_) return std::strong_ordering::greater;
        return to_rational(q) <=> p_;
    }
    [[nodiscard]] Sign side(const Point2& low, const Point2& high) const {
        return orientation(low, high, p_);
    }
    [[nodiscard]] const RationalPoint2& point() const { return p_; }

private:
    const RationalPoint2& p_;
    double low_ = 0;
    double high_ = 0;
};

/// A boundary edge's ray from the point: `end` lies on it, B on its left or right.
struct Ray {
    Point2 end;
    bool to_greater = false;
    bool solid_left = false;
    BodyId body;
};

class Locator {
public:
    Locator(const Scene2& scene, const RationalPoint2& p) : scene_(scene), query_(p) {}

    Location2 run() {
        std::vector<bool> odd(scene_.body_count() + 1, false);  // last: the world
        for (std::uint32_t i = 0; i < scene_.edge_count(); ++i) visit(EdgeId{i}, odd);
        for (const VertexId v : scene_.points()) see_vertex(v);
        if (!rays_.empty()) return on_boundary();
        if (scene_.has_world() && !odd.back()) {
            location_.kind = PlaceKind2::outside_world;
            return location_;
        }
        const auto body = std::find(odd.begin(), odd.end() - 1, true);
        if (body != odd.end() - 1) {
            location_.kind = PlaceKind2::inside_body;
            location_.body = BodyId{static_cast<std::uint32_t>(body - odd.begin())};
        }
        return location_;
    }

private:
    void see_vertex(VertexId v) {
        if (query_.compare(scene_[v]) == 0) location_.vertex = std::min(location_.vertex, v);
    }

    /// Parity of the edges below the point, per solid; and what contains the point.
    void visit(EdgeId id, std::vector<bool>& odd) {
        const Edge2& e = scene_[id];
        const Point2& source = scene_[e.source];
        const Point2& target = scene_[e.target];
        const bool rightwards = source < target;
        const Point2& low = rightwards ? source : target;
        const Point2& high = rightwards ? target : source;
        const auto to_low = query_.compare(low);
        const auto to_high = query_.compare(high);
        if (to_low > 0 || to_high < 0) return;
        const Sign side = query_.side(low, high);
        if (side == Sign::zero) {
            touch(id, to_low == 0, to_high == 0);
        } else if (side == Sign::positive && to_low < 0 && to_high > 0 &&
                   e.kind != EdgeKind2::wall) {
            const std::size_t owner = e.kind == EdgeKind2::world ? odd.size() - 1 : e.body.index();
            odd[owner] = !odd[owner];
        }
    }

    void touch(EdgeId id, bool at_low, bool at_high) {
        const Edge2& e = scene_[id];
        location_.edge = std::min(location_.edge, id);
        see_vertex(e.source);
        see_vertex(e.target);
        if (e.kind == EdgeKind2::wall) return;
        const bool rightwards = scene_[e.source] < scene_[e.target];
        const bool at_source = rightwards ? at_low : at_high;
        const bool at_target = rightwards ? at_high : at_low;
        if (!at_target) rays_.push_back({scene_[e.target], rightwards, true, e.body});
        if (!at_source) rays_.push_back({scene_[e.source], !rightwards, false, e.body});
    }

    /// All round solid when each ray has its opposite: B on both sides of it.
    Location2 on_boundary() {
        BodyId least = BodyId::none();
        for (const Ray& ray : rays_) {
            const bool sealed = std::any_of(rays_.begin(), rays_.end(), [&](const Ray& other) {
                return ray.to_greater == other.to_greater && ray.solid_left != other.solid_left &&
                       orientation(ray.end, other.end, query_.point()) == Sign::zero;
            });
            least = std::min(least, ray.body);
            if (sealed) continue;
            location_.kind = PlaceKind2::boundary;
            return location_;
        }
        location_.kind = least.is_none() ? PlaceKind2::outside_world : PlaceKind2::inside_body;
        location_.body = least;
        return location_;
    }

    const Scene2& scene_;
    QueryPoint query_;
    Location2 location_;
    std::vector<Ray> rays_;
};

}  // namespace

Location2 locate(const Scene2& scene, const RationalPoint2& p) { return Locator(scene, p).run(); }

Location2 locate(const Scene2& scene, const Point2& p) { return locate(scene, to_rational(p)); }

}  // namespace sightline
