// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A line given by its Plücker vector, for what cuts lines. Private.

#include "sightline/geom/plucker.hpp"
#include "spatial/exact_line.hpp"
#include "spatial/scene_forms.hpp"

namespace sightline::detail {

class SurdLineSource final : public LineSource {
public:
    /// The coordinates lie in one quadratic field.
    SurdLineSource(const SurdLine3& line, const SceneForms& forms)
        : line_(&line), scale_exponent_(forms.scale_exponent()) {}

    [[nodiscard]] PluckerOf<Real> real_line() const;
    [[nodiscard]] ExactLine exact_line() const override;

private:
    const SurdLine3* line_;
    int scale_exponent_;
};

}  // namespace sightline::detail
