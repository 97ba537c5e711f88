// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/result.hpp"

namespace sightline {

const char* name_of(Errc code) noexcept {
    switch (code) {
        case Errc::cannot_open:
            return "cannot_open";
        case Errc::syntax:
            return "syntax";
        case Errc::unsupported:
            return "unsupported";
        case Errc::cannot_write:
            return "cannot_write";
        case Errc::not_finite:
            return "not_finite";
        case Errc::too_few_vertices:
            return "too_few_vertices";
        case Errc::repeated_vertex:
            return "repeated_vertex";
        case Errc::zero_length:
            return "zero_length";
        case Errc::spike:
            return "spike";
        case Errc::self_intersection:
            return "self_intersection";
        case Errc::body_overlap:
            return "body_overlap";
        case Errc::hole_outside:
            return "hole_outside";
        case Errc::wrong_nesting:
            return "wrong_nesting";
        case Errc::outside_world:
            return "outside_world";
        case Errc::wall_crosses_body:
            return "wall_crosses_body";
        case Errc::point_in_body:
            return "point_in_body";
        case Errc::coordinate_too_large:
            return "coordinate_too_large";
        case Errc::empty_scene:
            return "empty_scene";
        case Errc::unknown_vertex:
            return "unknown_vertex";
        case Errc::degenerate_face:
            return "degenerate_face";
        case Errc::non_planar:
            return "non_planar";
        case Errc::open_surface:
            return "open_surface";
        case Errc::non_manifold:
            return "non_manifold";
        case Errc::wrong_orientation:
            return "wrong_orientation";
        case Errc::duplicate_vertex:
            return "duplicate_vertex";
        case Errc::sheet_crosses:
            return "sheet_crosses";
        case Errc::inside_body:
            return "inside_body";
        case Errc::outside_of_world:
            return "outside_of_world";
        case Errc::unreachable:
            return "unreachable";
        case Errc::limit_reached:
            return "limit_reached";
        case Errc::cancelled:
            return "cancelled";
        case Errc::bad_parameter:
            return "bad_parameter";
    }
    return "unknown";
}

void detail::contract_violated(const char* condition, const char* file, int line) {
    throw ContractViolation(std::string(file) + ":" + std::to_string(line) +
                            ": contract violated: " + condition);
}

}  // namespace sightline
