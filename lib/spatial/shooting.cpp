// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/spatial/shooting.hpp"

#include <algorithm>
#include <ostream>
#include <utility>
#include <vector>

#include "sightline/geom/predicates3.hpp"
#include "sightline/scene/result.hpp"
#include "spatial/line_shot.hpp"
#include "spatial/ray_filter.hpp"

namespace sightline {

using detail::Corners;
using detail::pass;
using detail::Passage;
using detail::Policy;
using detail::Ray;
using detail::SceneForms;

namespace {

bool is_ordinary(const Point3& p) {
    return std::abs(p.x) <= detail::largest_filtered && std::abs(p.y) <= detail::largest_filtered &&
           std::abs(p.z) <= detail::largest_filtered;
}

/// What all copies of a shooter share.
struct SharedScene {
    explicit SharedScene(const Scene3& s) : scene(s), forms(s) {
        for (const Triangle3& t : s.triangles()) {
            Corners c;
            for (std::size_t k = 0; k < 3; ++k) {
                const Point3& p = s[t.corners[k]];
                c[k] = {p.x, p.y, p.z};
                ordinary = ordinary && is_ordinary(p);
            }
            corners.push_back(c);
            const bool is_solid = s[s[t.face].body].kind == SurfaceKind::solid;
            solid.push_back(is_solid);
            // Where bodies touch, a sheet may be crossed in a slit that parts its sides already.
            blocks.push_back(is_solid || !s.has_touching_bodies());
        }
        for (const Body3& b : s.bodies()) has_world = has_world || b.is_world;
    }

    const Scene3& scene;
    SceneForms forms;
    std::vector<Corners> corners;  // of triangles
    std::vector<bool> solid;
    std::vector<bool> blocks;  // what crosses the inside is certainly blocked
    bool has_world = false;
    bool ordinary = true;
};

}  // namespace

class SegmentShooter::Impl {
public:
    Impl(std::shared_ptr<const SharedScene> shared, Arithmetic arithmetic, Tally* tally)
        : shared_(std::move(shared)),
          policy_{arithmetic, tally},
          predicates_(arithmetic, tally),
          lines_(shared_->forms) {}
    Impl(const Impl& other) : Impl(other.shared_, other.policy_.arithmetic, other.policy_.tally) {
        counts_ = other.counts_;
    }

    bool is_free(const RationalPoint3& p, const RationalPoint3& q) {
        ++counts_.shots;
        return cut_is_free(p, q);
    }

    bool is_free(const Point3& p, const Point3& q) {
        if (!uses_filter(p, q)) return is_free(to_rational(p), to_rational(q));
        ++counts_.shots;
        switch (look_along(p, q)) {
            case View::blocked:
                return false;
            case View::touching:
                return cut_is_free(to_rational(p), to_rational(q));
            case View::clear:
                break;
        }
        return !is_inside(p);
    }

    bool sees(const Point3& p, const Point3& q) {
        if (!uses_filter(p, q)) return is_free(to_rational(p), to_rational(q));
        ++counts_.shots;
        const View view = look_along(p, q);
        if (view != View::touching) return view == View::clear;
        return cut_is_free(to_rational(p), to_rational(q));
    }

    FreeEnd3 first_hit(const RationalPoint3& p, const Vector3& d) {
        ++counts_.shots;
        return cut_first_hit(p, d);
    }

    FreeEnd3 first_hit(const Point3& p, const Point3& towards) {
        const RationalPoint3 from = to_rational(p);
        const Vector3 d = to_rational(towards) - from;
        if (!uses_filter(p, towards)) return first_hit(from, d);
        ++counts_.shots;
        const Nearest nearest = find_nearest(p, towards);
        if (nearest.touches) return cut_first_hit(from, d);
        if (nearest.triangle == none) return {};
        return {hit_point(from, d, nearest.triangle), faces_of(nearest, p)};
    }

    SegmentEnd first_faces(const Point3& p, const Point3& towards) {
        const auto cut = [&] {
            const RationalPoint3 from = to_rational(p);
            return cut_first_hit(from, to_rational(towards) - from, false).faces;
        };
        ++counts_.shots;
        if (!uses_filter(p, towards)) return cut();
        const Nearest nearest = find_nearest(p, towards);
        if (nearest.touches) return cut();
        return faces_of(nearest, p);
    }

    [[nodiscard]] const ShootingCounts& counts() const { return counts_; }

private:
    static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

    enum class View : std::uint8_t { clear, blocked, touching };
    /// What a ray meets first.
    struct Nearest {
        std::uint32_t triangle = none;
        bool touches = false;  // something, not later than this: cut the line
    };

    [[nodiscard]] bool is_double() const { return policy_.arithmetic == Arithmetic::double_; }
    [[nodiscard]] bool uses_filter(const Point3& p, const Point3& q) const {
        return policy_.arithmetic != Arithmetic::exact && shared_->ordinary && is_ordinary(p) &&
               is_ordinary(q);
    }

    bool cut_is_free(const RationalPoint3& p, const RationalPoint3& q) {
        ++counts_.cut_lines;
        return lines_.is_free(p, q, policy_);
    }
    FreeEnd3 cut_first_hit(const RationalPoint3& p, const Vector3& d, bool wants_point = true) {
        ++counts_.cut_lines;
        return lines_.first_hit(p, d, wants_point, policy_);
    }

    [[nodiscard]] const Point3& corner(std::uint32_t triangle, std::size_t k) const {
        const Scene3& scene = shared_->scene;
        return scene[scene.triangles()[triangle].corners[k]];
    }

    // How the ray passes the triangle where doubles cannot tell. A crossing gets no bounds of t.
    Passage::Kind settle(std::uint32_t triangle, const Point3& p, const Point3& q,
                         bool is_segment) {
        ++counts_.unsure_triangles;
        const Point3& a = corner(triangle, 0);
        const Point3& b = corner(triangle, 1);
        const Point3& c = corner(triangle, 2);
        const LineTriangle passage = predicates_.line_triangle(p, q, a, b, c);
        if (passage.kind == LineTriangle::Kind::misses) return Passage::Kind::misses;
        // Whether it is reached along its plane is for the line's cut to say.
        if (passage.kind == LineTriangle::Kind::in_plane) return Passage::Kind::unsure;
        const Sign at_p = predicates_.orientation(a, b, c, p);
        if (at_p == passage.direction) return Passage::Kind::misses;  // behind p
        bool inside = at_p != Sign::zero;
        if (is_segment) {
            const Sign at_q = predicates_.orientation(a, b, c, q);
            if (at_q == -passage.direction) return Passage::Kind::misses;  // beyond q
            inside = inside && at_q != Sign::zero;
        }
        return inside && passage.kind == LineTriangle::Kind::crosses_inside ? Passage::Kind::crosses
                                                                            : Passage::Kind::unsure;
    }

    template <bool certified>
    View look(const Ray& ray, const Point3& p, const Point3& q) {
        bool touches = false;
        const bool clear = shared_->forms.triangles().traverse(
            [&](const Box3& box) { return ray.enters(box) < Box3::infinite; },
            [&](std::uint32_t i) {
                Passage::Kind kind = pass<certified>(ray, shared_->corners[i]).kind;
                if (kind == Passage::Kind::unsure) kind = settle(i, p, q, true);
                if (kind == Passage::Kind::crosses && shared_->blocks[i]) return false;
                touches = touches || kind != Passage::Kind::misses;
                return true;
            });
        if (!clear) return View::blocked;
        return touches ? View::touching : View::clear;
    }

    View look_along(const Point3& p, const Point3& q) {
        SIGHTLINE_EXPECT(p != q);
        const Ray ray(p, q, true);
        return is_double() ? look<false>(ray, p, q) : look<true>(ray, p, q);
    }

    Nearest find_nearest(const Point3& p, const Point3& q) {
        SIGHTLINE_EXPECT(p != q);
        const Ray ray(p, q, false);
        return is_double() ? nearest<false>(ray, p, q) : nearest<true>(ray, p, q);
    }

    template <bool certified>
    Nearest nearest(const Ray& ray, const Point3& p, const Point3& q) {
        Nearest result;
        double bound = Box3::infinite;    // the hit lies not beyond
        double contact = Box3::infinite;  // the first contact lies not before
        std::vector<std::pair<double, std::uint32_t>>& hits = hits_;
        hits.clear();
        shared_->forms.triangles().traverse_ordered(
            [&](const Box3& box) { return ray.enters(box); },
            [&](std::uint32_t i) {
                const Passage passage = pass<certified>(ray, shared_->corners[i]);
                if (passage.kind == Passage::Kind::misses) return bound;
                if (passage.kind == Passage::Kind::crosses && shared_->blocks[i]) {
                    if (passage.low <= bound) hits.emplace_back(passage.low, i);
                    bound = std::min(bound, passage.high);
                } else if (passage.kind == Passage::Kind::crosses ||
                           settle(i, p, q, false) != Passage::Kind::misses) {
                    const Box3 box = Box3::of(corner(i, 0), corner(i, 1), corner(i, 2));
                    contact = std::min(contact, ray.enters(box));
                }
                return bound;
            });
        std::size_t candidates = 0;
        for (const auto& [low, triangle] : hits) {
            if (low > bound) continue;
            result.triangle = triangle;
            ++candidates;
        }
        if constexpr (!certified) {
            // The least t that came out.
            const auto first = std::min_element(hits.begin(), hits.end());
            if (first != hits.end()) result.triangle = first->second;
            return result;
        }
        result.touches = candidates > 1 || (contact <= bound && contact < Box3::infinite);
        return result;
    }

    [[nodiscard]] SegmentEnd faces_of(const Nearest& nearest, const Point3& p) const {
        if (nearest.triangle == none) return {};
        const FaceId face = shared_->scene.triangles()[nearest.triangle].face;
        if (shared_->solid[nearest.triangle]) return {{face, false}};
        const Sign side =
            predicates_.orientation(corner(nearest.triangle, 0), corner(nearest.triangle, 1),
                                    corner(nearest.triangle, 2), p);
        return {{face, side == Sign::negative}};
    }

    [[nodiscard]] RationalPoint3 hit_point(const RationalPoint3& p, const Vector3& d,
                                           std::uint32_t triangle) const {
        const Vector3 a = to_rational(corner(triangle, 0)) - p;
        const Vector3 b = to_rational(corner(triangle, 1)) - p;
        const Vector3 c = to_rational(corner(triangle, 2)) - p;
        const Vector3 n = cross(b - a, c - a);
        return p + (dot(n, a) / dot(n, d)) * d;
    }

    // Whether p, which lies on no face, is in B: by the parity of the solids' crossings by a ray. Solids
    // overlap nowhere, so all can be counted together.
    bool is_inside(const Point3& p) {
        // Large enough for q not to be rounded to p.
        const double step = std::max({1.0, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        for (int attempt = 0;; ++attempt) {
            const Point3 q{p.x + 1009 * step, p.y + (104 + 37 * attempt) * step,
                           p.z + (attempt * attempt + 11) * step};
            if (const auto odd = has_odd_crossings(p, q)) return *odd != shared_->has_world;
        }
    }

    // Empty when the ray touches the border of a triangle.
    std::optional<bool> has_odd_crossings(const Point3& p, const Point3& q) {
        const Ray ray(p, q, false);
        bool odd = false;
        const bool decided = shared_->forms.triangles().traverse(
            [&](const Box3& box) { return ray.enters(box) < Box3::infinite; },
            [&](std::uint32_t i) {
                if (!shared_->solid[i]) return true;
                Passage::Kind kind = is_double() ? pass<false>(ray, shared_->corners[i]).kind
                                                 : pass<true>(ray, shared_->corners[i]).kind;
                if (kind == Passage::Kind::unsure) kind = settle(i, p, q, false);
                odd = odd != (kind == Passage::Kind::crosses);
                return kind != Passage::Kind::unsure;
            });
        return decided ? std::optional(odd) : std::nullopt;
    }

    std::shared_ptr<const SharedScene> shared_;
    Policy policy_;
    Predicates3 predicates_;
    detail::LineShot lines_;
    ShootingCounts counts_;
    std::vector<std::pair<double, std::uint32_t>> hits_;
};

SegmentShooter::SegmentShooter(const Scene3& scene, Arithmetic arithmetic, Tally* tally)
    : impl_(std::make_unique<Impl>(std::make_shared<const SharedScene>(scene), arithmetic, tally)) {
}
SegmentShooter::SegmentShooter(const SegmentShooter& other)
    : impl_(std::make_unique<Impl>(*other.impl_)) {}
SegmentShooter::SegmentShooter(SegmentShooter&& other) noexcept = default;
SegmentShooter& SegmentShooter::operator=(SegmentShooter other) noexcept {
    impl_.swap(other.impl_);
    return *this;
}
SegmentShooter::~SegmentShooter() = default;

bool SegmentShooter::is_free(const Point3& p, const Point3& q) { return impl_->is_free(p, q); }
bool SegmentShooter::is_free(const RationalPoint3& p, const RationalPoint3& q) {
    SIGHTLINE_EXPECT(p != q);
    return impl_->is_free(p, q);
}
bool SegmentShooter::sees(const Point3& p, const Point3& q) { return impl_->sees(p, q); }
FreeEnd3 SegmentShooter::first_hit(const Point3& p, const Point3& towards) {
    return impl_->first_hit(p, towards);
}
FreeEnd3 SegmentShooter::first_hit(const RationalPoint3& p, const Vector3& direction) {
    SIGHTLINE_EXPECT(!direction.is_zero());
    return impl_->first_hit(p, direction);
}
SegmentEnd SegmentShooter::first_faces(const Point3& p, const Point3& towards) {
    return impl_->first_faces(p, towards);
}
const ShootingCounts& SegmentShooter::counts() const noexcept { return impl_->counts(); }

std::ostream& operator<<(std::ostream& out, const FreeEnd3& end) {
    if (!end.point) return out << "| inf";
    out << *end.point << " |";
    for (const FaceSide& side : end.faces) {
        out << ' ' << to_string(side.face) << (side.back ? "-" : "");
    }
    return out;
}

}  // namespace sightline
