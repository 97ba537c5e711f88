// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/arith/sign.hpp"

#include <ostream>

namespace sightline {

std::ostream& operator<<(std::ostream& out, Sign sign) {
    switch (sign) {
        case Sign::negative:
            return out << "negative";
        case Sign::zero:
            return out << "zero";
        case Sign::positive:
            break;
    }
    return out << "positive";
}

std::ostream& operator<<(std::ostream& out, Tier tier) {
    switch (tier) {
        case Tier::filter:
            return out << "filter";
        case Tier::interval:
            return out << "interval";
        case Tier::exact:
            return out << "exact";
        case Tier::undecided:
            break;
    }
    return out << "undecided";
}

std::ostream& operator<<(std::ostream& out, const CertifiedSign& sign) {
    return out << sign.sign << " by " << sign.decided_by;
}

}  // namespace sightline
