// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/root_order.hpp"

#include <algorithm>

namespace sightline::detail {

namespace {

/// A number a + b√c of the field that two lines share.
struct FieldNumber {
    Integer a, b;
};

FieldNumber product(const FieldNumber& x, const FieldNumber& y, const Integer& c) {
    return {Integer(x.a * y.a + x.b * y.b * c), Integer(x.a * y.b + x.b * y.a)};
}

std::array<FieldNumber, 6> coordinates(const ExactLine& line) {
    std::array<FieldNumber, 6> result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = {line.a.d[i], line.is_rational() ? Integer(0) : line.b.d[i]};
        result[i + 3] = {line.a.m[i], line.is_rational() ? Integer(0) : line.b.m[i]};
    }
    return result;
}

/// Order of two lines of one field by their scaled Plücker vectors.
Sign compare_lines(const ExactLine& x, const ExactLine& y, const Integer& c) {
    const auto p = coordinates(x);
    const auto q = coordinates(y);
    const auto sign = [&](const FieldNumber& n) { return sign_of_surd(n.a, n.b, c); };
    const auto scale = [&](const std::array<FieldNumber, 6>& l) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (sign(l[i]) != Sign::zero) return i;
        }
        return std::size_t{0};
    };
    const FieldNumber& by_p = p[scale(p)];
    const FieldNumber& by_q = q[scale(q)];
    const Sign turn = sign(by_p) * sign(by_q);
    for (std::size_t i = 0; i < 6; ++i) {
        const FieldNumber left = product(p[i], by_q, c);
        const FieldNumber right = product(q[i], by_p, c);
        const Sign order = sign({Integer(left.a - right.a), Integer(left.b - right.b)});
        if (order != Sign::zero) return order * turn;
    }
    return Sign::zero;
}

bool is_line(const ExactLine& l) {
    return std::ranges::any_of(coordinates(l), [&, i = 0](const FieldNumber& n) mutable {
        return i++ < 3 && sign_of_surd(n.a, n.b, l.c) != Sign::zero;
    });
}

/// The other root of q on the curve, as a line; empty when there is none.
std::optional<ExactLine> other_line(const Curve& curve, const Quadratic<Integer>& q,
                                    const Parameter& t) {
    ExactLine line;
    const auto& l = curve.coefficients<Integer>();
    if (sgn(q.q2) == 0) {
        line.a = l[2];  // at t = ∞: parallel to the base edge
    } else {
        const ExactParameter& x = t.exact();
        if (sgn(x.D) != 0) {
            line = CurvePoint(curve, t).exact_line();
            line.b = Integer(-1) * line.b;
        } else {
            // Rational: the roots' sum is −q₁/q₂.
            const Parameter other = Parameter::rational(
                Integer((-q.q1 * x.r - q.q2 * x.p) * sgn(q.q2)), Integer(q.q2 * x.r * sgn(q.q2)));
            line = CurvePoint(curve, other).exact_line();
        }
    }
    if (!is_line(line)) return std::nullopt;
    return line;
}

bool meets(const ExactLine& line, const PluckerOf<Integer>& edge) {
    const Integer a = side(line.a, edge);
    const Integer b = line.is_rational() ? Integer(0) : side(line.b, edge);
    return sign_of_surd(a, b, line.c) == Sign::zero;
}

}  // namespace

Root root_of(const Curve& curve, const Parameter& t, const Line& line, const SkeletonNode& node) {
    const bool by_edges =
        node.type == NodeType::eeee || node.type == NodeType::fee || node.type == NodeType::ff;
    if (!by_edges || curve.kind() != CurveKind::regulus || t.is_double()) return Root::only;
    const SceneForms& forms = curve.forms();
    std::optional<ExactLine> other;
    std::vector<EdgeId> edges = node.label.support.edges;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            // Two edges of one plane fix the plane: the other solution, if any, is another kind of line.
            const Integer s =
                side(forms.line<Integer>(edges[i].index()), forms.line<Integer>(edges[j].index()));
            if (sgn(s) == 0) return Root::only;
        }
    }
    for (const EdgeId e : edges) {
        const EventForm form{EventForm::Kind::line, e.value, 0, VertexId::none(), 0};
        if (!other) {
            const Quadratic<Integer> q = curve.evaluate<Integer>(form);
            if (sgn(q.q0) == 0 && sgn(q.q1) == 0 && sgn(q.q2) == 0) continue;
            const Integer discriminant = q.q1 * q.q1 - 4 * q.q0 * q.q2;
            if (sgn(discriminant) == 0) return Root::only;
            other = other_line(curve, q, t);
            if (!other) return Root::only;
        }
        if (!meets(*other, forms.line<Integer>(e.index()))) return Root::only;
    }
    if (!other) return Root::only;
    const ExactLine& self = line.exact();
    const Integer c = self.is_rational() ? other->c : self.c;
    return compare_lines(self, *other, c) == Sign::negative ? Root::first : Root::second;
}

}  // namespace sightline::detail
