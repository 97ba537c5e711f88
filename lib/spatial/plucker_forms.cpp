// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial/plucker_forms.hpp"

namespace sightline::detail {

Sign sign_of_surd(const Integer& a, const Integer& b, const Integer& c) {
    const Sign rational = sign_of_integer(a);
    const Sign root = sgn(c) == 0 ? Sign::zero : sign_of_integer(b);
    if (root == Sign::zero || rational == root) return rational;
    if (rational == Sign::zero) return root;
    const Integer difference = a * a - b * b * c;
    return rational * sign_of_integer(difference);
}

Sign sign_of_surds(const Integer& a, const Integer& b, const Integer& c, const Integer& e,
                   const Integer& f) {
    const Sign first = sign_of_surd(a, b, c);
    const Sign second = sgn(f) == 0 ? Sign::zero : sign_of_integer(e);
    if (second == Sign::zero || first == second) return first;
    if (first == Sign::zero) return second;
    // (a + b√c)² − e²f, a number of Q(√c), compares the two parts' sizes.
    const Integer rational = a * a + b * b * c - e * e * f;
    const Integer root = 2 * a * b;
    return first * sign_of_surd(rational, root, c);
}

}  // namespace sightline::detail
