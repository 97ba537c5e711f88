// SPDX-License-Identifier: GPL-3.0-or-later
// What sheets do to a line that is cut: each by its own state before and after, and where a line meets more
// than that can tell, by the local pictures.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "sightline/geom/plucker.hpp"
#include "spatial/line_cut.hpp"
#include "spatial/sheet_crossing.hpp"

namespace sightline::detail {
namespace {

Rational rational_of(const Integer& x) { return *Rational::parse(x.get_str()); }

/// 2^exponent, also where that is no double.
Rational power_of_two(int exponent) {
    const int half = exponent / 2;
    return Rational(std::ldexp(1.0, half)) * Rational(std::ldexp(1.0, exponent - half));
}

template <typename Number>
Number number_of(const ExactLine& line, const Integer& a, const Integer& b) {
    if constexpr (std::is_same_v<Number, Rational>) {
        return rational_of(a);
    } else {
        return Surd(rational_of(a), rational_of(b), rational_of(line.c));
    }
}

template <typename Number>
BasicLine3<Number> line_over(const ExactLine& line) {
    const auto vector = [&](const Vec3<Integer>& a, const Vec3<Integer>& b) {
        return BasicVector3<Number>{number_of<Number>(line, a[0], b[0]),
                                    number_of<Number>(line, a[1], b[1]),
                                    number_of<Number>(line, a[2], b[2])};
    };
    return {vector(line.a.d, line.b.d), vector(line.a.m, line.b.m)};
}

/// The solids into which directions lead from a point, seen from the triangles that contain it alone. No
/// other solid contains the point.
template <typename Number>
class NearSolids {
public:
    using Vector = BasicVector3<Number>;

    NearSolids(const std::vector<const ExactTriangle*>& near, const Vector& x) : x_(x) {
        for (const ExactTriangle* t : near) {
            if (!t->is_sheet) triangles_[t->body].push_back(t);
        }
    }

    std::vector<BodyId> operator()(const Vector& direction) const {
        std::vector<BodyId> result;
        for (const auto& [body, triangles] : triangles_) {
            if (contains(triangles, direction)) result.push_back(body);
        }
        return result;
    }

private:
    using Triangles = std::vector<const ExactTriangle*>;

    // Turns the direction towards points of the solid's triangles, until one is reached without
    // passing a border; the first triangle that is passed shows its front or its back.
    [[nodiscard]] bool contains(const Triangles& triangles, const Vector& direction) const {
        for (int attempt = 1;; ++attempt) {
            for (const ExactTriangle* target : triangles) {
                if (const auto inside = seen_towards(triangles, *target, direction, attempt)) {
                    return *inside;
                }
            }
        }
    }

    [[nodiscard]] std::optional<bool> seen_towards(const Triangles& triangles,
                                                   const ExactTriangle& target,
                                                   const Vector& direction, int attempt) const {
        const auto& [a, b, c] = target.corners;
        const Vector towards = over<Number>(a) + Number(1 + 7 * attempt) * over<Number>(b) +
                               Number(3 + attempt * attempt) * over<Number>(c) -
                               Number(5 + 7 * attempt + attempt * attempt) * x_;
        Number first(1);
        const Number target_side = dot(over<Number>(target.normal), direction);
        bool inside = sign_of(target_side) == Sign::negative;
        for (const ExactTriangle* t : triangles) {
            const Vector n = over<Number>(t->normal);
            const Number from = dot(n, direction);
            const Number to = dot(n, towards);
            if (sign_of(to) == Sign::zero) {
                if (cross(n, over<Number>(target.normal)).is_zero()) continue;
                return std::nullopt;
            }
            if (sign_of(from) == sign_of(to)) continue;
            const Number share = from / (from - to);
            const Vector passed = direction + share * (towards - direction);
            const Sign within = side_of_borders(*t, passed);
            if (within == Sign::zero) return std::nullopt;
            if (within == Sign::negative || first < share) continue;
            first = share;
            inside = sign_of(from) == Sign::negative;
        }
        return inside;
    }

    // Positive when the direction, in t's plane, leads from x into t, zero along its border.
    [[nodiscard]] Sign side_of_borders(const ExactTriangle& t, const Vector& direction) const {
        Sign result = Sign::positive;
        for (std::size_t i = 0; i < 3; ++i) {
            if (sign_of(inward(t, i, x_)) != Sign::zero) continue;
            result = std::min(result, sign_of(inward(t, i, direction, false)));
        }
        return result;
    }

    Vector x_;
    std::map<BodyId, Triangles> triangles_;
};

template <typename Number>
Box3 box_round(const BasicVector3<Number>& x) {
    Box3 box;
    const std::array<Interval, 3> hulls{enclosure(x.x), enclosure(x.y), enclosure(x.z)};
    for (std::size_t i = 0; i < 3; ++i) {
        box.low[i] = hulls[i].lower;
        box.high[i] = hulls[i].upper;
    }
    return box;
}

template <typename Number>
LocalPicture<Number> picture_at(const ExactTriangles& exact, const Bvh& boxes,
                                const BasicVector3<Number>& x) {
    const Box3 place = box_round(x);
    std::vector<const ExactTriangle*> near;
    boxes.traverse([&](const Box3& box) { return box.meets(place); },
                   [&](std::uint32_t i) {
                       const ExactTriangle& t = exact.triangles()[i];
                       if (contains(t, x)) near.push_back(&t);
                   });
    return {near, x, true, NearSolids<Number>(near, x)};
}

}  // namespace

bool LineCut::is_sheet(BodyId b) const { return forms_->scene()[b].kind == SurfaceKind::sheet; }

void LineCut::follow_sheet(std::span<const Touch> touches) {
    using Where = LocalState::Where;
    Where side = Where::open;
    std::uint32_t begin = 0;
    for (const Touch& t : touches) {
        if (t.before.where != Where::on) {
            side = t.before.where;
            begin = t.place;
        }
        if (t.after.where == Where::on) continue;
        const bool known = side != Where::open && t.after.where != Where::open;
        if (known && side != t.after.where) cuts_.push_back({t.body, begin, t.place});
        side = Where::open;
    }
}

bool LineCut::is_on_sheet(std::uint32_t place) const {
    return std::ranges::any_of(
        touches_, [&](const Touch& t) { return t.place == place && is_sheet(t.body); });
}

bool LineCut::runs_along_sheet(std::uint32_t piece) const {
    for (std::size_t i = 0; i < touches_.size(); ++i) {
        const Touch& t = touches_[i];
        if (is_sheet(t.body) && t.place < piece && t.after.where == LocalState::Where::on &&
            is_last_before(i, piece)) {
            return true;
        }
    }
    return false;
}

void LineCut::judge_joint_stays() {
    for (std::uint32_t place = 0; place < place_count_; ++place) {
        if (!is_on_sheet(place)) continue;
        Stay stay{place, place};
        while (stay.last + 1 < place_count_ && !blocked_[stay.last + 1] &&
               runs_along_sheet(stay.last + 1)) {
            ++stay.last;
        }
        if (is_joint(stay)) judge(stay);
        place = stay.last;
    }
}

// Whether more than one body, or more than one feature of a sheet at one place, takes part.
bool LineCut::is_joint(const Stay& stay) const {
    BodyId only;
    std::vector<std::uint32_t> met(stay.last - stay.first + 1);
    for (std::size_t i = 0; i < touches_.size(); ++i) {
        const Touch& t = touches_[i];
        if (stay.first <= t.place && t.place <= stay.last) {
            if (!is_sheet(t.body) || (!only.is_none() && t.body != only)) return true;
            if (++met[t.place - stay.first] > 1) return true;
            only = t.body;
        } else if (t.place < stay.first && t.after.where == LocalState::Where::on &&
                   !is_sheet(t.body) && is_last_before(i, stay.first)) {
            return true;
        }
    }
    return false;
}

void LineCut::judge(const Stay& stay) {
    std::erase_if(cuts_,
                  [&](const SheetCut& c) { return stay.first <= c.first && c.last <= stay.last; });
    // A stay at which the line begins or ends to be free does not block.
    if (blocked_[stay.first] || blocked_[stay.last + 1]) return;
    const auto crossed =
        line_->exact().is_rational() ? crossed_sheets<Rational>(stay) : crossed_sheets<Surd>(stay);
    for (const BodyId b : crossed) cuts_.push_back({b, stay.first, stay.last});
}

template <typename Number>
std::vector<BodyId> LineCut::crossed_sheets(const Stay& stay) const {
    using Vector = BasicVector3<Number>;
    const Scene3& scene = forms_->scene();
    if (!exact_triangles_) exact_triangles_ = std::make_shared<const ExactTriangles>(scene);
    const BasicLine3<Number> line = line_over<Number>(line_->exact());
    const Number scale(power_of_two(forms_->scale_exponent()));
    const Vector& d = line.d;
    const Vector p = (Number(1) / (scale * dot(d, d))) * cross(d, line.m);
    const auto vertex = [&](VertexId v) {
        return over<Number>(ExactTriangles::vector_to(scene[v]));
    };
    std::vector<Vector> points(stay.last - stay.first + 1);
    for (const Contact& c : contacts_) {
        if (c.place < stay.first || c.place > stay.last) continue;
        Vector& x = points[c.place - stay.first];
        if (c.feature == Feature::vertex) {
            x = vertex(VertexId{c.id});
        } else if (c.feature == Feature::face) {
            const Face3& face = scene[FaceId{c.id}];
            const Vector a = vertex(face.plane[0]);
            const Vector n = cross(vertex(face.plane[1]) - a, vertex(face.plane[2]) - a);
            x = p + (dot(n, a - p) / dot(n, d)) * d;
        } else {
            const Edge3& edge = scene[EdgeId{c.id}];
            const Vector a = vertex(edge.source);
            const Vector e = vertex(edge.target) - a;
            const Vector across = cross(d, e);
            x = p + (determinant(a - p, e, across) / dot(across, across)) * d;
        }
    }
    std::vector<LocalPicture<Number>> pictures;
    for (const Vector& x : points) {
        pictures.push_back(picture_at(*exact_triangles_, forms_->triangles(), x));
    }
    const auto crossed = SheetCrossing<Number>(std::move(pictures), d).crossed();
    return {crossed.begin(), crossed.end()};
}

}  // namespace sightline::detail
