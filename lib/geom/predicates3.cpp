// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/geom/predicates3.hpp"

#include <array>
#include <ostream>

#include "geom/polynomial_sign.hpp"
#include "geom/polynomials3.hpp"

namespace sightline {

namespace {

// The sign of a polynomial in double points.
struct Kernel {
    Arithmetic arithmetic = Arithmetic::filtered;
    Tally* tally = nullptr;

    template <typename Evaluate>
    [[nodiscard]] Sign sign(Predicate predicate, const Evaluate& evaluate) const {
        const CertifiedSign result = detail::polynomial_sign(arithmetic, evaluate);
        if (tally != nullptr) tally->add(predicate, result.decided_by);
        return result.sign;
    }
};

// The sign of a polynomial in rational points.
struct ExactKernel {
    template <typename Evaluate>
    [[nodiscard]] Sign sign(Predicate, const Evaluate& evaluate) const {
        return evaluate.template operator()<Rational>().sign();
    }
};

template <typename Kernel, typename Point>
Sign orientation_in(const Kernel& kernel, Predicate counted_as, const Point& a, const Point& b,
                    const Point& c, const Point& d) {
    return kernel.sign(counted_as, [&]<typename Number>() -> Number {
        return detail::orientation3_polynomial<Number>(a, b, c, d);
    });
}

template <typename Kernel, typename Point>
LineTriangle line_triangle_in(const Kernel& kernel, const Point& p, const Point& q, const Point& a,
                              const Point& b, const Point& c) {
    using Kind = LineTriangle::Kind;
    const auto side = [&](const Point& r, const Point& s) {
        return orientation_in(kernel, Predicate::side_of_line3, p, q, r, s);
    };
    std::array<Sign, 3> sides{side(b, c), side(c, a), Sign::zero};
    if (sides[0] * sides[1] == Sign::negative) return {};
    sides[2] = side(a, b);
    Sign direction = Sign::zero;
    std::uint8_t zeros = 0;
    std::uint8_t last_zero = 0;
    std::uint8_t other = 0;
    for (std::uint8_t i = 0; i < 3; ++i) {
        if (sides[i] == Sign::zero) {
            ++zeros;
            last_zero = i;
            continue;
        }
        if (sides[i] * direction == Sign::negative) return {};
        direction = sides[i];
        other = i;
    }
    // The line meets two edges' lines where they meet each other: at the corner opposite to the
    // third edge.
    switch (zeros) {
        case 0:
            return {Kind::crosses_inside, 0, direction};
        case 1:
            return {Kind::through_edge, last_zero, direction};
        case 2:
            return {Kind::through_vertex, other, direction};
        default:
            return {Kind::in_plane, 0, Sign::zero};
    }
}

template <typename Kernel, typename Point>
LinePlane line_plane_in(const Kernel& kernel, const Point& p, const Point& q, const Point& a,
                        const Point& b, const Point& c) {
    const Sign slope = kernel.sign(Predicate::line_plane3, [&]<typename Number>() -> Number {
        return detail::line_plane_polynomial<Number>(a, b, c, p, q);
    });
    if (slope != Sign::zero) {
        return slope == Sign::positive ? LinePlane::forward : LinePlane::backward;
    }
    const Sign height = orientation_in(kernel, Predicate::orientation3, a, b, c, p);
    return height == Sign::zero ? LinePlane::inside : LinePlane::parallel;
}

Kernel kernel_of(const Predicates3& predicates) {
    return {predicates.arithmetic(), predicates.tally()};
}

}  // namespace

Sign orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return orientation_in(Kernel{}, Predicate::orientation3, a, b, c, d);
}

Sign orientation(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
                 const RationalPoint3& d) {
    return orientation_in(ExactKernel{}, Predicate::orientation3, a, b, c, d);
}

Sign side_of_line(const Point3& p, const Point3& q, const Point3& r, const Point3& s) {
    return orientation_in(Kernel{}, Predicate::side_of_line3, p, q, r, s);
}

Sign side_of_line(const RationalPoint3& p, const RationalPoint3& q, const RationalPoint3& r,
                  const RationalPoint3& s) {
    return orientation_in(ExactKernel{}, Predicate::side_of_line3, p, q, r, s);
}

LineTriangle line_triangle(const Point3& p, const Point3& q, const Point3& a, const Point3& b,
                           const Point3& c) {
    return line_triangle_in(Kernel{}, p, q, a, b, c);
}

LineTriangle line_triangle(const RationalPoint3& p, const RationalPoint3& q,
                           const RationalPoint3& a, const RationalPoint3& b,
                           const RationalPoint3& c) {
    return line_triangle_in(ExactKernel{}, p, q, a, b, c);
}

LinePlane line_plane(const Point3& p, const Point3& q, const Point3& a, const Point3& b,
                     const Point3& c) {
    return line_plane_in(Kernel{}, p, q, a, b, c);
}

LinePlane line_plane(const RationalPoint3& p, const RationalPoint3& q, const RationalPoint3& a,
                     const RationalPoint3& b, const RationalPoint3& c) {
    return line_plane_in(ExactKernel{}, p, q, a, b, c);
}

Sign Predicates3::orientation(const Point3& a, const Point3& b, const Point3& c,
                              const Point3& d) const {
    return orientation_in(kernel_of(*this), Predicate::orientation3, a, b, c, d);
}

Sign Predicates3::side_of_line(const Point3& p, const Point3& q, const Point3& r,
                               const Point3& s) const {
    return orientation_in(kernel_of(*this), Predicate::side_of_line3, p, q, r, s);
}

LineTriangle Predicates3::line_triangle(const Point3& p, const Point3& q, const Point3& a,
                                        const Point3& b, const Point3& c) const {
    return line_triangle_in(kernel_of(*this), p, q, a, b, c);
}

LinePlane Predicates3::line_plane(const Point3& p, const Point3& q, const Point3& a,
                                  const Point3& b, const Point3& c) const {
    return line_plane_in(kernel_of(*this), p, q, a, b, c);
}

const char* name_of(LineTriangle::Kind kind) noexcept {
    switch (kind) {
        case LineTriangle::Kind::misses:
            return "misses";
        case LineTriangle::Kind::crosses_inside:
            return "crosses_inside";
        case LineTriangle::Kind::through_edge:
            return "through_edge";
        case LineTriangle::Kind::through_vertex:
            return "through_vertex";
        case LineTriangle::Kind::in_plane:
            return "in_plane";
    }
    return "unknown";
}

const char* name_of(LinePlane relation) noexcept {
    switch (relation) {
        case LinePlane::forward:
            return "forward";
        case LinePlane::backward:
            return "backward";
        case LinePlane::parallel:
            return "parallel";
        case LinePlane::inside:
            return "inside";
    }
    return "unknown";
}

std::ostream& operator<<(std::ostream& out, const LineTriangle& relation) {
    return out << name_of(relation.kind) << ' ' << static_cast<int>(relation.index) << ' '
               << relation.direction;
}

std::ostream& operator<<(std::ostream& out, LinePlane relation) { return out << name_of(relation); }

}  // namespace sightline
