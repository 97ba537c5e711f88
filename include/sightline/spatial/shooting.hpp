// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/geom/point.hpp"
#include "sightline/geom/vector3.hpp"
#include "sightline/scene/scene3.hpp"
#include "sightline/spatial/free_segment3.hpp"

namespace sightline {

/// Where a free ray ends.
struct FreeEnd3 {
    /// Empty at infinity.
    std::optional<RationalPoint3> point;
    /// What stops it there.
    SegmentEnd faces;

    friend bool operator==(const FreeEnd3&, const FreeEnd3&) = default;
    /// "(1, 2, 3) | f1 f2-", or "| inf".
    friend std::ostream& operator<<(std::ostream& out, const FreeEnd3& end);
};

/// How a shooter's answers were found.
struct ShootingCounts {
    std::uint64_t shots = 0;
    /// Triangles that doubles with their error bound could not decide.
    std::uint64_t unsure_triangles = 0;
    /// Shots that touch something and were answered by cutting the whole line exactly.
    std::uint64_t cut_lines = 0;

    friend bool operator==(const ShootingCounts&, const ShootingCounts&) = default;
};

/// Answers whether segments are free and where rays end, exactly (semantics: docs/structures/shooting.md):
/// grazing a vertex, an edge or a face is free, contacts between solids are sealed, nothing passes
/// between two triangles.
///
/// Between points with double coordinates most shots are decided in doubles with error bounds, in
/// O(log n) for scenes of small things; those that touch an edge, a vertex or a plane's face cut their
/// line at everything it meets. Rational points always do. Under Arithmetic::double_ no bound is kept
/// and every sign is taken as it comes out: answers may be wrong, and rays leak.
///
/// Keeps buffers: use one shooter a thread. Copies are independent and share what has been computed
/// of the scene, which must outlive them.
class SegmentShooter {
public:
    explicit SegmentShooter(const Scene3& scene, Arithmetic arithmetic = Arithmetic::filtered,
                            Tally* tally = nullptr);
    SegmentShooter(const SegmentShooter& other);
    SegmentShooter(SegmentShooter&& other) noexcept;
    SegmentShooter& operator=(SegmentShooter other) noexcept;
    ~SegmentShooter();

    /// Whether the segment pq is free. Contract: p ≠ q.
    [[nodiscard]] bool is_free(const Point3& p, const Point3& q);
    [[nodiscard]] bool is_free(const RationalPoint3& p, const RationalPoint3& q);

    /// The same where p is known not to lie in the interior of B, or q is: saves locating it.
    /// Contract: this, which is not checked, and p ≠ q.
    [[nodiscard]] bool sees(const Point3& p, const Point3& q);

    /// Where the free segment from p through `towards` and beyond ends; p itself when the first step is
    /// blocked. Contract: p ≠ towards, and p is not in the interior of B.
    [[nodiscard]] FreeEnd3 first_hit(const Point3& p, const Point3& towards);
    /// The same, in a direction, which is not zero.
    [[nodiscard]] FreeEnd3 first_hit(const RationalPoint3& p, const Vector3& direction);
    /// The faces of first_hit(), without the point; empty at infinity.
    [[nodiscard]] SegmentEnd first_faces(const Point3& p, const Point3& towards);

    [[nodiscard]] const ShootingCounts& counts() const noexcept;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sightline
