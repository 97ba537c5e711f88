// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/common_transversals3.hpp"

#include <algorithm>

namespace sightline::reference::detail {
namespace {

using Row = std::array<Rational, 6>;

// The lines that meet an edge's line are the zeros of this form on (d, m).
Row side_form(const ExactEdge& e) {
    return {e.moment[0], e.moment[1], e.moment[2], e.direction[0], e.direction[1], e.direction[2]};
}

// Gauss and Jordan: rows that span the same, each with a 1 in its pivot's column and 0 in the others'.
struct Reduced {
    std::vector<Row> rows;
    std::vector<std::size_t> pivots;
};

Reduced reduced(const std::vector<const ExactEdge*>& edges) {
    std::vector<Row> rows;
    for (const ExactEdge* e : edges) rows.push_back(side_form(*e));
    std::vector<std::size_t> pivots;
    for (std::size_t column = 0; column < 6; ++column) {
        const std::size_t next = pivots.size();
        const auto pivot =
            std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(next), rows.end(),
                         [&](const Row& r) { return !is_zero(r[column]); });
        if (pivot == rows.end()) continue;
        std::iter_swap(rows.begin() + static_cast<std::ptrdiff_t>(next), pivot);
        const Rational scale = rows[next][column];
        for (Rational& x : rows[next]) x /= scale;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Rational factor = rows[i][column];
            if (i == next || is_zero(factor)) continue;
            for (std::size_t k = 0; k < 6; ++k) rows[i][k] -= factor * rows[next][k];
        }
        pivots.push_back(column);
    }
    rows.resize(pivots.size());
    return {std::move(rows), std::move(pivots)};
}

std::vector<Row> nullspace(const Reduced& forms) {
    std::vector<Row> result;
    for (std::size_t free = 0; free < 6; ++free) {
        if (std::ranges::count(forms.pivots, free) > 0) continue;
        Row x{};
        x[free] = 1;
        for (std::size_t i = 0; i < forms.pivots.size(); ++i) {
            x[forms.pivots[i]] = -forms.rows[i][free];
        }
        result.push_back(std::move(x));
    }
    return result;
}

Rational side(const Row& a, const Row& b) {
    Rational sum;
    for (std::size_t i = 0; i < 3; ++i) sum += a[i] * b[i + 3] + a[i + 3] * b[i];
    return sum;
}

// Appends s a + t b, unless it is a line at infinity.
void add_line(const Surd& s, const Row& a, const Surd& t, const Row& b,
              std::vector<PluckerVector>& lines) {
    PluckerVector x;
    for (std::size_t i = 0; i < 6; ++i) x[i] = s * Surd(a[i]) + t * Surd(b[i]);
    const auto first =
        std::find_if(x.begin(), x.begin() + 3, [](const Surd& c) { return !is_zero(c); });
    if (first == x.begin() + 3) return;
    const Surd scale = *first;
    for (Surd& c : x) c /= scale;
    lines.push_back(std::move(x));
}

}  // namespace

PluckerVector plucker_vector(const ExactLine& line) {
    const SurdTriple m = cross(line.base, line.direction);
    return {line.direction[0], line.direction[1], line.direction[2], m[0], m[1], m[2]};
}

std::size_t rank(const std::vector<const ExactEdge*>& edges) {
    return reduced(edges).pivots.size();
}

std::vector<PluckerVector> common_transversals(const std::vector<const ExactEdge*>& edges) {
    const auto basis = nullspace(reduced(edges));
    if (basis.size() != 2) return {};
    // The lines among s a + t b: aa s² + 2 ab s t + bb t² = 0.
    const Row& a = basis[0];
    const Row& b = basis[1];
    const Rational aa = side(a, a);
    const Rational ab = side(a, b);
    const Rational bb = side(b, b);
    const Rational discriminant = ab * ab - aa * bb;
    std::vector<PluckerVector> lines;
    if (discriminant.sign() == Sign::negative) return lines;
    if (is_zero(aa)) {
        add_line(1, a, 0, b, lines);
        if (!is_zero(ab)) add_line(-bb, a, 2 * ab, b, lines);
    } else {
        add_line(Surd(-ab, 1, discriminant), a, aa, b, lines);
        if (!is_zero(discriminant)) add_line(Surd(-ab, -1, discriminant), a, aa, b, lines);
    }
    std::ranges::sort(lines);
    return lines;
}

}  // namespace sightline::reference::detail
