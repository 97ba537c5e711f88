// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/directions2.hpp"

#include <algorithm>

namespace sightline::reference::detail {
namespace {

Sign turn(const Direction& a, const Direction& b) { return (a[0] * b[1] - a[1] * b[0]).sign(); }

// 0: as `start`; 1: less than half a turn; 2: opposite; 3: more.
int quarter(const Direction& start, const Direction& a) {
    if (const Sign s = turn(start, a); s != Sign::zero) return s == Sign::positive ? 1 : 3;
    return (start[0] * a[0] + start[1] * a[1]).sign() == Sign::positive ? 0 : 2;
}

}  // namespace

bool comes_before(const Direction& start, const Direction& a, const Direction& b) {
    const int qa = quarter(start, a);
    const int qb = quarter(start, b);
    return qa != qb ? qa < qb : turn(a, b) == Sign::positive;
}

// The union is the circle when there is a sector and none ends where no other one goes on.
bool covers_circle(const std::vector<Sector>& sectors) {
    return !sectors.empty() && std::ranges::all_of(sectors, [&](const Sector& s) {
        return std::ranges::any_of(
            sectors, [&](const Sector& t) { return comes_before(t.from, s.to, t.to); });
    });
}

}  // namespace sightline::reference::detail
