// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/cone3.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/box_tree3.hpp"
#include "scene/union_find.hpp"
#include "sightline/geom/predicates2.hpp"
#include "sightline/scene/result.hpp"

namespace sightline::detail {
namespace {

struct Arc {
    std::uint32_t from = 0;  ///< a ray
    std::uint32_t to = 0;
    std::uint32_t triangle = 0;  ///< index in the span
    bool is_sheet = false;
};

/// An arc, or a piece of one, as it leaves a ray.
struct HalfArc {
    std::uint32_t toward = 0;  ///< a ray
    int step = 0;              ///< by which the number of solids grows across it, counter-clockwise
    std::uint32_t arc = 0;
    int quarter = 0;
};

Point3 unit(double x, double y, double z) {
    const double size = std::max({std::abs(x), std::abs(y), std::abs(z)});
    x /= size, y /= size, z /= size;
    const double length = std::sqrt(x * x + y * y + z * z);
    return {x / length, y / length, z / length};
}
Point3 approx_direction(const Point3& from, const Point3& to) {
    return unit(to.x - from.x, to.y - from.y, to.z - from.z);
}
Point3 approx_direction(const RationalPoint3& from, const RationalPoint3& to) {
    const Rational x = to.x - from.x, y = to.y - from.y, z = to.z - from.z;
    const Rational size = std::max({abs(x), abs(y), abs(z)});
    return unit((x / size).approx_double(), (y / size).approx_double(), (z / size).approx_double());
}
const Point3& as(const Point3& p, const Point3&) { return p; }
RationalPoint3 as(const Point3& p, const RationalPoint3&) { return to_rational(p); }
const RationalPoint3& as_rational(const RationalPoint3& p) { return p; }
RationalPoint3 as_rational(const Point3& p) { return to_rational(p); }

/// Directions that differ by more than this are certainly different, and arcs this far apart don't meet:
/// unit vectors are computed with errors below 2^-49. What is nearer is decided exactly.
constexpr double margin = 0x1p-40;

/// P is Point3 or RationalPoint3.
template <typename P>
class Cone {
public:
    Cone(const P& apex, std::span<const ConeTriangle> triangles)
        : apex_(apex), triangles_(triangles) {}

    ConeReport run() {
        add_arcs();
        join_equal_rays();
        ConeReport report;
        if ((report.fault = compare_arcs())) return report;
        collect_half_arcs();
        for (std::uint32_t r = 0; r < rays_.size(); ++r)
            if ((report.fault = check_ray(r))) return report;
        if ((report.fault = check_nesting())) return report;
        report.is_regular = is_simple_ && is_regular_;
        report.is_simple = is_simple_;
        return report;
    }

private:
    void add_arcs() {
        std::map<P, std::uint32_t> known;
        const auto ray = [&](const P& target) {
            const auto [found, is_new] =
                known.emplace(target, static_cast<std::uint32_t>(rays_.size()));
            if (is_new) rays_.push_back(target);
            return found->second;
        };
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            const ConeTriangle& triangle = triangles_[t];
            is_regular_ = is_regular_ && triangle.vertex == triangles_[0].vertex &&
                          triangle.is_sheet == triangles_[0].is_sheet;
            std::array<P, 3> corner{as(triangle.corners[0], apex_), as(triangle.corners[1], apex_),
                                    as(triangle.corners[2], apex_)};
            bool at_corner = false;
            for (const P& c : corner) at_corner = at_corner || c == apex_;
            is_regular_ = is_regular_ && at_corner;
            for (std::size_t i = 0; i < 3; ++i) {
                const P& a = corner[i];
                const P& b = corner[(i + 1) % 3];
                // A side through the point leaves no arc.
                if (a == apex_ || b == apex_ || (!at_corner && is_between(a, apex_, b))) continue;
                const std::uint32_t from = ray(a);
                arcs_.push_back({from, ray(b), t, triangle.is_sheet});
            }
        }
    }

    /// Rays of one direction become one.
    void join_equal_rays() {
        for (const P& r : rays_) directions_.push_back(approx_direction(apex_, r));
        std::vector<std::uint32_t> order(rays_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return directions_[a].x < directions_[b].x;
        });
        UnionFind same(rays_.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            const Point3& u = directions_[order[i]];
            for (std::size_t j = i + 1; j < order.size(); ++j) {
                const Point3& w = directions_[order[j]];
                if (w.x - u.x > margin) break;
                if (std::abs(w.y - u.y) > margin || std::abs(w.z - u.z) > margin) continue;
                if (are_collinear(apex_, rays_[order[i]], rays_[order[j]]))
                    same.join(order[i], order[j]);
            }
        }
        for (Arc& arc : arcs_) {
            arc.from = same.root(arc.from);
            arc.to = same.root(arc.to);
        }
    }

    [[nodiscard]] Sign det(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        if (a == b || b == c || c == a) return Sign::zero;
        return orientation3(apex_, rays_[a], rays_[b], rays_[c]);
    }

    /// Turns about the apex in the plane of two rays a, b, positive from a to b.
    class Turns {
    public:
        Turns(const Cone& cone, std::uint32_t a, std::uint32_t b) : cone_(cone) {
            for (axis_ = 2; axis_ > 0; --axis_) {
                facing_ = flat(a, b);
                if (facing_ != Sign::zero) return;
            }
            facing_ = flat(a, b);
        }
        [[nodiscard]] Sign operator()(std::uint32_t a, std::uint32_t b) const {
            return facing_ * flat(a, b);
        }

    private:
        [[nodiscard]] Sign flat(std::uint32_t a, std::uint32_t b) const {
            return orientation(drop(cone_.apex_, axis_), drop(cone_.rays_[a], axis_),
                               drop(cone_.rays_[b], axis_));
        }
        const Cone& cone_;
        int axis_ = 2;
        Sign facing_ = Sign::zero;
    };

    /// For a ray in the plane of an arc: whether it lies inside of the arc.
    [[nodiscard]] bool is_within(std::uint32_t ray, const Arc& arc) const {
        if (ray == arc.from || ray == arc.to) return false;
        const Turns turn(*this, arc.from, arc.to);
        return turn(arc.from, ray) == Sign::positive && turn(ray, arc.to) == Sign::positive;
    }

    /// Notes which rays lie on which arcs; the first pair of arcs that cross.
    std::optional<ConeFault> compare_arcs() {
        constexpr std::size_t many = 24;
        if (arcs_.size() <= many) {
            for (std::uint32_t a = 0; a < arcs_.size(); ++a)
                for (std::uint32_t b = a + 1; b < arcs_.size(); ++b)
                    if (const auto fault = compare(a, b)) return fault;
        } else {
            std::vector<SceneBox3> boxes;
            for (const Arc& arc : arcs_) boxes.push_back(box_of(arc));
            const SceneBoxTree3 tree(boxes);
            std::optional<ConeFault> fault;
            for (std::uint32_t a = 0; a < arcs_.size() && !fault; ++a)
                tree.query(boxes[a], [&](std::uint32_t b) {
                    if (b > a && !fault) fault = compare(a, b);
                });
            if (fault) return fault;
        }
        std::sort(passes_.begin(), passes_.end());
        passes_.erase(std::unique(passes_.begin(), passes_.end()), passes_.end());
        return std::nullopt;
    }

    [[nodiscard]] SceneBox3 box_of(const Arc& arc) const {
        const Point3& u = directions_[arc.from];
        const Point3& w = directions_[arc.to];
        const double cosine = u.x * w.x + u.y * w.y + u.z * w.z;
        if (cosine < 0.5) return {{-2, -2, -2}, {2, 2, 2}};
        // The arc leaves its chord by 1 - cos(angle / 2) at most, which is at most 1 - cosine.
        const double bulge = 1 - cosine + margin;
        SceneBox3 box = SceneBox3::of(u);
        box.include(SceneBox3::of(w));
        for (std::size_t i = 0; i < 3; ++i) {
            box.low[i] -= bulge;
            box.high[i] += bulge;
        }
        return box;
    }

    std::optional<ConeFault> compare(std::uint32_t i, std::uint32_t j) {
        const Arc& a = arcs_[i];
        const Arc& b = arcs_[j];
        const Sign b0 = det(a.from, a.to, b.from);
        const Sign b1 = det(a.from, a.to, b.to);
        if (b0 * b1 == Sign::positive) return std::nullopt;
        const Sign a0 = det(b.from, b.to, a.from);
        const Sign a1 = det(b.from, b.to, a.to);
        if (a0 * a1 == Sign::positive) return std::nullopt;
        // Opposite signs say that the great circles cross on both arcs, or on one and opposite to the other.
        if (b0 * b1 == Sign::negative && a0 * a1 == Sign::negative) {
            if (b0 != a1) return std::nullopt;
            return ConeFault{ConeFault::Kind::crossing, triangles_[a.triangle].id,
                             triangles_[b.triangle].id};
        }
        if (b0 == Sign::zero && is_within(b.from, a)) passes_.emplace_back(b.from, i);
        if (b1 == Sign::zero && is_within(b.to, a)) passes_.emplace_back(b.to, i);
        if (a0 == Sign::zero && is_within(a.from, b)) passes_.emplace_back(a.from, j);
        if (a1 == Sign::zero && is_within(a.to, b)) passes_.emplace_back(a.to, j);
        return std::nullopt;
    }

    void collect_half_arcs() {
        half_arcs_.resize(rays_.size());
        is_simple_ = passes_.empty();
        for (std::uint32_t i = 0; i < arcs_.size(); ++i) {
            const Arc& arc = arcs_[i];
            const int weight = arc.is_sheet ? 0 : 1;
            half_arcs_[arc.from].push_back({arc.to, -weight, i});
            half_arcs_[arc.to].push_back({arc.from, weight, i});
        }
        for (const auto& [ray, i] : passes_) {
            const Arc& arc = arcs_[i];
            const int weight = arc.is_sheet ? 0 : 1;
            half_arcs_[ray].push_back({arc.to, -weight, i});
            half_arcs_[ray].push_back({arc.from, weight, i});
        }
    }

    /// Counter-clockwise round the ray; of coincident half-arcs first those where a solid ends, last those where one
    /// begins.
    void sort_round(std::uint32_t ray, std::vector<HalfArc>& round) const {
        const std::uint32_t reference = round.front().toward;
        const Turns turn(*this, ray, reference);
        for (HalfArc& half : round) {
            const Sign sign =
                half.toward == reference ? Sign::zero : det(ray, reference, half.toward);
            if (sign == Sign::zero) {
                half.quarter = turn(ray, half.toward) == Sign::positive ? 0 : 2;
            } else {
                half.quarter = sign == Sign::positive ? 1 : 3;
            }
        }
        std::sort(round.begin(), round.end(), [&](const HalfArc& a, const HalfArc& b) {
            if (a.quarter != b.quarter) return a.quarter < b.quarter;
            if (a.quarter % 2 == 1) {
                const Sign sign = det(ray, a.toward, b.toward);
                if (sign != Sign::zero) return sign == Sign::positive;
            }
            return a.step != b.step ? a.step < b.step : a.arc < b.arc;
        });
    }

    [[nodiscard]] std::uint32_t id_of(const HalfArc& half) const {
        return triangles_[arcs_[half.arc].triangle].id;
    }

    std::optional<ConeFault> check_ray(std::uint32_t ray) {
        std::vector<HalfArc>& round = half_arcs_[ray];
        if (round.empty()) return std::nullopt;
        const bool solids_only =
            std::none_of(round.begin(), round.end(), [](const HalfArc& h) { return h.step == 0; });
        if (solids_only && round.size() == 2) return std::nullopt;
        is_simple_ = is_simple_ && !solids_only;
        sort_round(ray, round);
        int count = 0;
        int least = 0;
        int most = 0;
        std::size_t top = 0;  // the first half-arc after which the count is highest
        for (std::size_t i = 0; i < round.size(); ++i) {
            count += round[i].step;
            if (count > most) top = i;
            most = std::max(most, count);
            least = std::min(least, count);
        }
        if (most - least > 1) return overlap(round, top);
        if (most == least) return std::nullopt;
        count = 0;
        for (std::size_t i = 0; i < round.size(); ++i) {
            count += round[i].step;
            if (round[i].step != 0 || count == least) continue;
            return ConeFault{ConeFault::Kind::inside, id_of(some_solid(round)), id_of(round[i])};
        }
        return std::nullopt;
    }

    [[nodiscard]] static const HalfArc& some_solid(const std::vector<HalfArc>& round) {
        return *std::find_if(round.begin(), round.end(),
                             [](const HalfArc& h) { return h.step != 0; });
    }

    /// Names the two triangles between which the count is highest, or those where it grew to it.
    [[nodiscard]] ConeFault overlap(const std::vector<HalfArc>& round, std::size_t top) const {
        const std::size_t n = round.size();
        std::size_t end = (top + 1) % n;
        while (round[end].step >= 0 && end != top) end = (end + 1) % n;
        std::size_t start = (top + n - 1) % n;
        while (round[start].step <= 0 && start != top) start = (start + n - 1) % n;
        const bool same_triangle = id_of(round[end]) == id_of(round[top]);
        return {ConeFault::Kind::overlap, id_of(round[top]),
                id_of(round[same_triangle ? start : end])};
    }

    /// Loops of arcs that don't touch: near each of them the others must cover equally much.
    std::optional<ConeFault> check_nesting() {
        UnionFind loops(rays_.size());
        for (const Arc& arc : arcs_) loops.join(arc.from, arc.to);
        for (const auto& [ray, arc] : passes_) loops.join(ray, arcs_[arc].from);
        std::map<std::uint32_t, std::vector<std::uint32_t>> arcs_of;  // by the root of their loop
        for (std::uint32_t i = 0; i < arcs_.size(); ++i)
            arcs_of[loops.root(arcs_[i].from)].push_back(i);
        if (arcs_of.size() <= 1) return std::nullopt;
        is_simple_ = false;
        for (const P& r : rays_) vectors_.push_back(difference(as_rational(r), as_rational(apex_)));
        const auto has_solid = [&](const std::vector<std::uint32_t>& arcs) {
            return std::any_of(arcs.begin(), arcs.end(),
                               [&](std::uint32_t a) { return !arcs_[a].is_sheet; });
        };
        std::optional<int> common;
        std::uint32_t common_arc = 0;
        for (const bool solids : {true, false}) {
            for (const auto& [root, arcs] : arcs_of) {
                if (has_solid(arcs) != solids) continue;
                int level = 0;
                for (const auto& [other, others] : arcs_of)
                    if (other != root && has_solid(others) && is_covered(arcs.front(), others))
                        ++level;
                if (!common && solids) {
                    common = level;
                    common_arc = arcs.front();
                }
                if (!common || level == *common) continue;
                return ConeFault{solids ? ConeFault::Kind::overlap : ConeFault::Kind::inside,
                                 triangles_[arcs_[common_arc].triangle].id,
                                 triangles_[arcs_[arcs.front()].triangle].id};
            }
        }
        return std::nullopt;
    }

    static RationalPoint3 difference(const RationalPoint3& a, const RationalPoint3& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    static Sign det(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c) {
        return (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
                a.z * (b.x * c.y - b.y * c.x))
            .sign();
    }

    /// A point inside of an arc.
    [[nodiscard]] RationalPoint3 inside_of(std::uint32_t arc, int weight) const {
        const RationalPoint3& u = vectors_[arcs_[arc].from];
        const RationalPoint3& w = vectors_[arcs_[arc].to];
        const Rational k(weight);
        return {u.x + k * w.x, u.y + k * w.y, u.z + k * w.z};
    }

    /// Whether the solids that a loop bounds cover another loop, on which `arc` is. Walks from a point of the arc to a
    /// point of the loop; of all such ways only finitely many meet an end of an arc or the opposite of one.
    [[nodiscard]] bool is_covered(std::uint32_t arc, const std::vector<std::uint32_t>& loop) const {
        for (int weight = 1;; ++weight) {
            const RationalPoint3 start = inside_of(arc, weight * weight + 1);
            for (const std::uint32_t i : loop) {
                if (arcs_[i].is_sheet) continue;
                if (const auto covered = is_covered(start, inside_of(i, weight), loop))
                    return *covered;
            }
        }
    }

    [[nodiscard]] std::optional<bool> is_covered(const RationalPoint3& start,
                                                 const RationalPoint3& goal,
                                                 const std::vector<std::uint32_t>& loop) const {
        bool covered = false;
        bool flips = false;
        for (const std::uint32_t i : loop) {
            if (arcs_[i].is_sheet) continue;
            const RationalPoint3& c = vectors_[arcs_[i].from];
            const RationalPoint3& d = vectors_[arcs_[i].to];
            const Sign c_side = det(start, goal, c);
            const Sign d_side = det(start, goal, d);
            if (c_side == Sign::zero || d_side == Sign::zero) return std::nullopt;
            if (c_side == d_side) continue;
            const Sign start_side = det(c, d, start);
            const Sign goal_side = det(c, d, goal);
            if (goal_side == Sign::zero) {
                // The way ends on this arc, or opposite to it.
                if (!is_on_same_side(goal, c, d)) continue;
                if (start_side == Sign::zero) return std::nullopt;
                covered = covered || start_side == Sign::negative;
            } else if (start_side * goal_side == Sign::negative && c_side == goal_side) {
                flips = !flips;
            }
        }
        return covered != flips;
    }

    // For a vector in the plane of c and d, which lie on different sides of it in that plane.
    static bool is_on_same_side(const RationalPoint3& goal, const RationalPoint3& c,
                                const RationalPoint3& d) {
        const RationalPoint3 normal{c.y * d.z - c.z * d.y, c.z * d.x - c.x * d.z,
                                    c.x * d.y - c.y * d.x};
        return det(normal, c, goal) == Sign::positive && det(normal, goal, d) == Sign::positive;
    }

    const P& apex_;
    std::span<const ConeTriangle> triangles_;
    std::vector<P> rays_;  ///< a point on each
    std::vector<Point3> directions_;
    std::vector<RationalPoint3> vectors_;
    std::vector<Arc> arcs_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> passes_;  ///< ray inside of an arc
    std::vector<std::vector<HalfArc>> half_arcs_;                  ///< a ray
    bool is_regular_ = true;  ///< as far as corners tell
    bool is_simple_ = true;
};

}  // namespace

ConeReport look_around(const Point3& point, std::span<const ConeTriangle> triangles) {
    return Cone<Point3>(point, triangles).run();
}

ConeReport look_around(const RationalPoint3& point, std::span<const ConeTriangle> triangles) {
    return Cone<RationalPoint3>(point, triangles).run();
}

}  // namespace sightline::detail
