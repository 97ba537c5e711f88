// SPDX-License-Identifier: GPL-3.0-or-later
// The lines that meet four whole lines.
#include <algorithm>

#include "event/swath_polynomials.hpp"
#include "sightline/event/transversals.hpp"

namespace sightline {

namespace {

using Row = std::array<Rational, 6>;

Row row_of(const RationalLine3& l) { return {l.m.x, l.m.y, l.m.z, l.d.x, l.d.y, l.d.z}; }

bool is_zero(const Rational& x) { return x.sign() == Sign::zero; }

// Brings the rows to reduced echelon form; the column of each row's leading one.
std::vector<std::size_t> reduce(std::array<Row, 4>& rows) {
    std::vector<std::size_t> pivots;
    for (std::size_t column = 0; column < 6 && pivots.size() < 4; ++column) {
        const std::size_t rank = pivots.size();
        std::size_t found = rank;
        while (found < 4 && is_zero(rows[found][column])) ++found;
        if (found == 4) continue;
        std::swap(rows[rank], rows[found]);
        const Rational by = rows[rank][column];
        for (Rational& x : rows[rank]) x /= by;
        for (std::size_t i = 0; i < 4; ++i) {
            const Rational factor = rows[i][column];
            if (i == rank || is_zero(factor)) continue;
            for (std::size_t k = column; k < 6; ++k) rows[i][k] -= factor * rows[rank][k];
        }
        pivots.push_back(column);
    }
    return pivots;
}

// A basis of the vectors that have side zero to the four lines.
std::vector<RationalLine3> null_space(const std::array<RationalLine3, 4>& lines) {
    std::array<Row, 4> rows{row_of(lines[0]), row_of(lines[1]), row_of(lines[2]), row_of(lines[3])};
    const std::vector<std::size_t> pivots = reduce(rows);
    std::vector<RationalLine3> basis;
    for (std::size_t column = 0; column < 6; ++column) {
        if (std::ranges::find(pivots, column) != pivots.end()) continue;
        Row x;
        x[column] = 1;
        for (std::size_t i = 0; i < pivots.size(); ++i) x[pivots[i]] = -rows[i][column];
        basis.push_back({{x[0], x[1], x[2]}, {x[3], x[4], x[5]}});
    }
    return basis;
}

SurdLine3 combined(const Surd& s, const RationalLine3& a, const Surd& t, const RationalLine3& b) {
    const SurdLine3 x = to_surd(a);
    const SurdLine3 y = to_surd(b);
    return {s * x.d + t * y.d, s * x.m + t * y.m};
}

// The lines s·a + t·b with s²A + 2stB + t²C = 0, not all three zero.
std::vector<SurdLine3> null_lines(const RationalLine3& a, const RationalLine3& b, const Rational& A,
                                  const Rational& B, const Rational& C) {
    std::vector<SurdLine3> lines;
    if (is_zero(A)) {
        lines.push_back(to_surd(a));
        if (!is_zero(B)) lines.push_back(combined(C, a, Rational(-2) * B, b));
        return lines;
    }
    const Rational discriminant = B * B - A * C;
    if (discriminant.sign() == Sign::negative) return {};
    const Surd root(-B, 1, discriminant);
    lines.push_back(combined(root, a, A, b));
    if (!is_zero(discriminant)) lines.push_back(combined(Surd(-B, -1, discriminant), a, A, b));
    return lines;
}

}  // namespace

std::optional<std::vector<SurdLine3>> lines_meeting(const std::array<RationalLine3, 4>& lines) {
    const std::vector<RationalLine3> basis = null_space(lines);
    if (basis.size() > 2) return std::nullopt;
    const RationalLine3& a = basis[0];
    const RationalLine3& b = basis[1];
    const Rational A = side(a, a), B = side(a, b), C = side(b, b);
    if (is_zero(A) && is_zero(B) && is_zero(C)) return std::nullopt;
    std::vector<SurdLine3> found = null_lines(a, b, A, B, C);
    std::erase_if(found, [](const SurdLine3& l) { return l.d.is_zero(); });
    for (SurdLine3& line : found) line = scaled(line);
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace sightline
