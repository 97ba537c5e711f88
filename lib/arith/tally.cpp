// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/arith/tally.hpp"

namespace sightline {

std::string_view name_of(Predicate predicate) noexcept {
    switch (predicate) {
        case Predicate::orientation2:
            return "orientation2";
        case Predicate::order_along_line2:
            return "order_along_line2";
        case Predicate::order_of_directions2:
            return "order_of_directions2";
        case Predicate::constructed_order2:
            return "constructed_order2";
        case Predicate::point_location2:
            return "point_location2";
        case Predicate::orientation3:
            return "orientation3";
        case Predicate::side_of_line3:
            return "side_of_line3";
        case Predicate::line_plane3:
            return "line_plane3";
        case Predicate::transversals3:
            return "transversals3";
        case Predicate::line_form3:
            return "line_form3";
        case Predicate::curve_parameter3:
            return "curve_parameter3";
        case Predicate::image_orientation3:
            return "image_orientation3";
        case Predicate::constructed_order3:
            return "constructed_order3";
        case Predicate::count_:
            break;
    }
    return "unknown";
}

TierCounts& TierCounts::operator+=(const TierCounts& other) noexcept {
    calls += other.calls;
    filter += other.filter;
    interval += other.interval;
    exact += other.exact;
    undecided += other.undecided;
    return *this;
}

void Tally::add(Predicate p, Tier tier) noexcept {
    TierCounts& counts = (*this)[p];
    ++counts.calls;
    switch (tier) {
        case Tier::filter:
            ++counts.filter;
            break;
        case Tier::interval:
            ++counts.interval;
            break;
        case Tier::exact:
            ++counts.exact;
            break;
        case Tier::undecided:
            ++counts.undecided;
            break;
    }
}

Tally& Tally::operator+=(const Tally& other) noexcept {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
    return *this;
}

}  // namespace sightline
