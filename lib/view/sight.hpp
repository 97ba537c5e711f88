// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One line of sight in exact numbers: what decides where images coincide. Private.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "view/image.hpp"

namespace sightline::detail {

/// What a line of sight ends on.
struct SightEnd {
    ViewRegion::Kind kind = ViewRegion::Kind::infinity;
    SegmentEnd faces;
    /// The body that blocks it, when kind is blocked.
    BodyId body;

    friend bool operator==(const SightEnd& a, const SightEnd& b) {
        return a.kind == b.kind && a.faces == b.faces;
    }
};

/// The half line from the viewpoint with vector `delta` (a multiple of Image::exact vectors), and everything
/// that its closure meets.
class Sight {
public:
    /// `near` is a point of the line, rounded; seen from a point, one far from the viewpoint.
    Sight(Image& image, const Vector3& delta, const std::array<double, 3>& near);

    /// Whether the segment from the viewpoint to the point with weight w on this line is free (semantics 2.4).
    /// Contract: the viewpoint is in no body's interior.
    [[nodiscard]] bool is_free_until(const Rational& w);

    /// What directions of sight end on that differ from this one by an infinitely small multiple of `aside` and
    /// a still smaller one of `along`. Contract: delta, aside and along are linearly independent.
    [[nodiscard]] SightEnd look(const Vector3& aside, const Vector3& along);

private:
    struct Hit {
        std::uint32_t triangle = 0;
        // The plane n·r + m w = 0, its values positive outside of the face.
        Vector3 n;
        Rational m;
        bool is_sheet = false;
        bool in_plane = false;
        // Where it meets the line, from far to near; equal unless in_plane. Near may be infinite.
        Rational far;
        Rational near;
        bool near_is_infinite = false;
    };
    struct Piece {
        std::optional<Rational> near;  // infinite when empty
        Rational far;
        Rational middle;
        std::vector<const Hit*> fins;
    };
    using Sectors = std::vector<Vector3>;

    void gather(const std::array<double, 3>& near);
    void add(std::uint32_t triangle);
    [[nodiscard]] bool add_in_plane(Hit& hit) const;
    [[nodiscard]] std::vector<Piece> pieces_until(const Rational& w) const;
    [[nodiscard]] Sectors sectors_of(const Piece& piece) const;
    [[nodiscard]] bool is_inside(const Rational& w, const Vector3& aside);
    [[nodiscard]] bool is_hit(const Hit& hit, const Vector3& aside, const Vector3& along);
    [[nodiscard]] Vector3 independent_of(const Vector3& aside) const;
    [[nodiscard]] bool crosses_sheet(const std::vector<Piece>& pieces) const;
    [[nodiscard]] bool run_separates(const std::vector<Piece>& pieces, std::size_t first,
                                     std::size_t last) const;
    [[nodiscard]] bool run_connects(const std::vector<Piece>& pieces, std::size_t first,
                                    std::size_t last, bool with_sheets) const;
    [[nodiscard]] std::vector<const Hit*> hits_at(const Rational& w, bool with_sheets) const;

    Image& image_;
    Vector3 delta_;
    std::vector<Hit> hits_;

    friend class LocalPicture;
};

/// Calls visit(triangle) for every triangle that a line comes near to: no triangle that it meets is left out.
/// Seen from a point, only the half line from the viewpoint through `near` counts.
void for_triangles_near(const Image& image, const std::array<double, 3>& near,
                        std::vector<std::uint32_t>& out);

}  // namespace sightline::detail
