// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether a line that is known with error bounds may meet a box, for inner loops. Private.

#include <cmath>

#include "sightline/spatial/box3.hpp"
#include "spatial/plucker_forms.hpp"

namespace sightline::detail {

/// Tests the line's three projections along the axes. Doubles, rounded to nearest; the slack covers the
/// line's own error and the rounding of the test: fewer than 16 operations a component, each
/// losing a relative 2^-53 of the sum of the absolute values.
class LineBoxTest {
public:
    explicit LineBoxTest(const PluckerOf<Real>& line) {
        for (std::size_t i = 0; i < 3; ++i) {
            d_[i] = line.d[i].value();
            m_[i] = line.m[i].value();
            d_error_[i] = line.d[i].upper() - line.d[i].lower();
            m_error_[i] = line.m[i].upper() - line.m[i].lower();
        }
    }

    [[nodiscard]] bool operator()(const Box3& box) const {
        std::array<double, 3> c;
        std::array<double, 3> h;
        for (std::size_t i = 0; i < 3; ++i) {
            c[i] = box.low[i] / 2 + box.high[i] / 2;
            h[i] = (box.high[i] / 2 - box.low[i] / 2) * (1 + 0x1p-50);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const std::size_t k = (i + 2) % 3;
            const double off = m_[i] - (c[j] * d_[k] - c[k] * d_[j]);
            const double reach = h[j] * std::abs(d_[k]) + h[k] * std::abs(d_[j]);
            const double far_j = std::abs(c[j]) + h[j];
            const double far_k = std::abs(c[k]) + h[k];
            const double size = std::abs(m_[i]) + far_j * std::abs(d_[k]) + far_k * std::abs(d_[j]);
            const double slack =
                m_error_[i] + far_j * d_error_[k] + far_k * d_error_[j] + size * 0x1p-47;
            if (std::abs(off) > reach + slack + 0x1p-1000) return false;
        }
        return true;
    }

private:
    std::array<double, 3> d_, m_, d_error_, m_error_;
};

}  // namespace sightline::detail
