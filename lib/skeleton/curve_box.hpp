// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether the lines of a piece of a curve, between two places where they end, may meet a box: for
/// inner loops, in doubles with certified slack. Private.

#include <vector>

#include "sightline/spatial/box3.hpp"
#include "skeleton/curve.hpp"
#include "spatial/line_cut.hpp"

namespace sightline::detail {

/// n·x − k over boxes.
class BoxForm {
public:
    BoxForm() = default;
    BoxForm(const Vec3<Real>& n, const Real& k);

    /// The sign of the form on the whole box; zero when it is not certain that there is one.
    [[nodiscard]] int sign(const Box3& box) const;

private:
    std::array<double, 3> n_{}, error_{};
    double k_ = 0, k_error_ = 0;
};

class CurveBoxTest {
public:
    /// Lines of the curve for t in [low, high], in front of the planes of the stopping faces.
    CurveBoxTest(const Curve& curve, const StoppingFaces& stopping, double low, double high);

    /// Narrows the interval.
    void set_interval(double low, double high);
    [[nodiscard]] bool operator()(const Box3& box) const;

private:
    [[nodiscard]] bool may_meet_quadric(const Box3& box) const;

    const Curve* curve_;
    std::array<std::vector<BoxForm>, 2> stops_;
    BoxForm plane_;  ///< of a pencil
    Vec3<Real> normal_{};
    // On either side of which the lines at both ends of the interval lie: outside where both signs agree.
    std::array<std::array<BoxForm, 2>, 2> wedges_;
    std::size_t wedge_count_ = 1;
};

}  // namespace sightline::detail
