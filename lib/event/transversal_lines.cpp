// SPDX-License-Identifier: GPL-3.0-or-later
// Single lines against elements and components: certificates and witnesses.
#include <algorithm>
#include <ostream>

#include "event/pencil.hpp"
#include "sightline/event/transversals.hpp"
#include "sightline/scene/result.hpp"

namespace sightline {

namespace {

using Kind = TransversalElement::Kind;
using Family = TransversalComponent::Kind;

template <typename Number>
BasicVector3<Number> as(const Vector3& v) {
    return {v.x, v.y, v.z};
}

template <typename Number>
bool is_zero(const Number& x) {
    return sign_of(x) == Sign::zero;
}

// Whether x, on the line of the segment, lies between its ends; x is a point times a weight.
template <typename Number>
bool is_between(const TransversalElement& e, const HomogeneousPoint3<Number>& x) {
    const BasicVector3<Number> u = as<Number>(e.target() - e.source());
    const auto beyond = [&](const RationalPoint3& end) {
        return sign_of(dot(u, x.p - x.w * as<Number>(vector_to(end))));
    };
    return beyond(e.source()) * beyond(e.target()) != Sign::positive;
}

template <typename Number>
bool meets_element(const BasicLine3<Number>& line, const TransversalElement& e) {
    if (e.kind() == Kind::point) return is_on(line, as<Number>(vector_to(e.source())));
    const RationalLine3 own = e.carrier();
    const BasicLine3<Number> carrier{as<Number>(own.d), as<Number>(own.m)};
    if (!is_zero(side(line, carrier))) return false;
    const auto meeting = meeting_point(line, carrier);
    if (!meeting.is_finite()) return is_on(line, as<Number>(vector_to(e.source())));
    return e.kind() == Kind::line || is_between(e, meeting);
}

// A point x:y of a projective line, in a quadratic field.
using Place = std::array<Surd, 2>;

Surd turn(const Place& p, const Place& q) { return p[0] * q[1] - p[1] * q[0]; }

// Where a line of a regulus meets one of its generators.
Place place_on(const RationalLine3& generator, const SurdLine3& line) {
    const SurdLine3 g = to_surd(generator);
    const auto meeting = meeting_point(line, g);
    if (!meeting.is_finite()) return {1, 0};
    return {dot(meeting.p, g.d), meeting.w};
}

// The direction of a line in a plane, in coordinates that the normal does not flatten.
Place direction_in(const Plane3& plane, const SurdLine3& line) {
    if (!is_zero(plane.normal.x)) return {line.d.y, line.d.z};
    if (!is_zero(plane.normal.y)) return {line.d.x, line.d.z};
    return {line.d.x, line.d.y};
}

Place place_of(const TransversalComponent& component, const SurdLine3& line) {
    if (component.kind == Family::pencil) return direction_in(*component.plane, line);
    return place_on(component.generators.front(), line);
}

bool is_in_range(const TransversalComponent& component, const TransversalRange& range,
                 const Place& place) {
    const Place from = place_of(component, to_surd(range.from));
    const Place to = place_of(component, to_surd(range.to));
    const Place through = place_of(component, to_surd(range.through));
    const Surd to_from = turn(place, from), to_to = turn(place, to);
    if (is_zero(to_from)) return range.has_from;
    if (is_zero(to_to)) return range.has_to;
    return (to_from * to_to).sign() == (turn(through, from) * turn(through, to)).sign();
}

bool is_in_ranges(const TransversalComponent& component, const SurdLine3& line) {
    if (component.ranges.empty()) return true;
    const Place place = place_of(component, line);
    return std::ranges::any_of(component.ranges, [&](const TransversalRange& range) {
        return is_in_range(component, range, place);
    });
}

bool is_in_plane(const SurdLine3& line, const Plane3& plane) {
    const SurdVector3 n = to_surd(plane.normal);
    const auto meeting = meeting_point(line, n, Surd(plane.offset));
    return !meeting.is_finite() && meeting.p.is_zero();
}

}  // namespace

bool meets(const SurdLine3& line, const TransversalElement& element) {
    return meets_element(line, element);
}

bool meets(const RationalLine3& line, const TransversalElement& element) {
    return meets_element(line, element);
}

bool verify(std::span<const TransversalElement> elements, const SurdLine3& line) {
    return line.is_line() && scaled(line) == line &&
           std::ranges::all_of(elements, [&](const auto& e) { return meets(line, e); });
}

SurdVector3 witness(const SurdLine3& line, const TransversalElement& element) {
    SIGHTLINE_EXPECT(meets(line, element));
    const SurdVector3 source = to_surd(vector_to(element.source()));
    if (element.kind() == Kind::point) return source;
    const auto meeting = meeting_point(line, to_surd(element.carrier()));
    return meeting.is_finite() ? meeting.divided() : source;
}

bool is_in_family(const TransversalComponent& component, const SurdLine3& line) {
    const auto is_met = [&](const TransversalElement& e) { return meets(line, e); };
    const auto holds_point = [&] { return is_on(line, to_surd(vector_to(*component.point))); };
    const auto touches = [&](const RationalLine3& g) { return is_zero(side(line, to_surd(g))); };
    switch (component.kind) {
        case Family::pencil:
            return holds_point() && is_in_plane(line, *component.plane) &&
                   is_in_ranges(component, line);
        case Family::regulus:
            return std::ranges::all_of(component.generators, touches) &&
                   is_in_ranges(component, line);
        case Family::plane:
            return is_in_plane(line, *component.plane);
        case Family::bundle:
            return holds_point();
        case Family::congruence:
        case Family::segment:
            break;
    }
    return std::ranges::all_of(component.pieces, is_met);
}

const char* name_of(TransversalComponent::Kind kind) noexcept {
    switch (kind) {
        case Family::pencil:
            return "pencil";
        case Family::regulus:
            return "regulus";
        case Family::plane:
            return "plane";
        case Family::bundle:
            return "bundle";
        case Family::congruence:
            return "congruence";
        case Family::segment:
            return "segment";
    }
    return "unknown";
}

std::ostream& operator<<(std::ostream& out, const TransversalComponent& component) {
    out << name_of(component.kind);
    if (component.point) out << " at " << *component.point;
    if (component.plane) out << " in " << *component.plane;
    for (const TransversalElement& e : component.pieces) {
        out << " over " << e.source() << ' ' << e.target();
    }
    for (const TransversalRange& r : component.ranges) {
        out << " from " << r.from << (r.has_from ? "" : " (without)") << " through " << r.through
            << " to " << r.to << (r.has_to ? "" : " (without)");
    }
    for (const RationalLine3& line : component.extremal) out << " within " << line;
    return out;
}

}  // namespace sightline
