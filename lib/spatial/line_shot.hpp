// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Shots that are answered by cutting their whole line: any rational points, any contacts. Private.

#include "sightline/geom/vector3.hpp"
#include "sightline/spatial/shooting.hpp"
#include "spatial/line_cut.hpp"

namespace sightline::detail {

class LineShot {
public:
    explicit LineShot(const SceneForms& forms);

    /// Whether the segment pq is free; p ≠ q.
    [[nodiscard]] bool is_free(const RationalPoint3& p, const RationalPoint3& q,
                               const Policy& policy);
    /// Where the free segment from p along d ends; without the point unless it is wanted.
    [[nodiscard]] FreeEnd3 first_hit(const RationalPoint3& p, const Vector3& d, bool wants_point,
                                     const Policy& policy);

private:
    class Cutter;

    const SceneForms* forms_;
    LineCut cut_;
    bool has_world_ = false;
};

}  // namespace sightline::detail
