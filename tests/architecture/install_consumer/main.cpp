// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>

#include "sightline/geom/predicates2.hpp"

int main() {
    using sightline::Point2;
    // A point one ulp off a line: a program that links the installed library must see the side it is on.
    const Point2 a{0.5, 0.5}, b{12, 12}, above{24, std::nextafter(24.0, 25.0)};
    const bool right = sightline::orientation(a, b, above) == sightline::Sign::positive &&
                       sightline::orientation(a, b, Point2{24, 24}) == sightline::Sign::zero;
    std::cout << (right ? "installed library answers\n" : "wrong answer\n");
    return right ? 0 : 1;
}
