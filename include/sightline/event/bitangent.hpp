// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <tuple>

#include "sightline/geom/point.hpp"
#include "sightline/scene/id.hpp"
#include "sightline/scene/result.hpp"

/// The critical lines of the plane, named by what they touch. docs/structures/bitangents.md
namespace sightline {

/// On which side of a directed line the thing lies that the line touches at a vertex. What counts
/// is the scene's own edges at that vertex (two on a ring, one or two on a wall, none at a point).
///
/// Degeneracy
/// - One edge along the line: the side of the other. Both along it: for a body (or the world) the
///   side of its inside; a wall is `on` the line.
/// - A point, and a wall that runs along the line: `on`; they have no side.
/// - The line passes between the two edges: `both`. Of lines that are locally tangent this happens
///   only where the ring is pinched (the line leads through a pinhole of one body).
enum class Side : std::uint8_t { left, right, on, both };

/// The same side for whoever looks the other way.
[[nodiscard]] constexpr Side reversed(Side s) noexcept {
    return s == Side::left ? Side::right : s == Side::right ? Side::left : s;
}

/// One letter: L, R, O (on) or B (both).
[[nodiscard]] char letter_of(Side side) noexcept;
std::ostream& operator<<(std::ostream& out, Side side);

/// A directed line that is locally tangent at two vertices, from the first to the second. Its name
/// is its generators: the contacts; coordinates are those of the scene.
///
/// Laws
///  (1) reversed(reversed(b)) == b
///  (2) reversed exchanges LL with RR and keeps LR and RL: b.separates() == reversed(b).separates()
///  (3) exactly one of b and reversed(b) is canonical
///  (4) a mirror image of the scene exchanges left and right
/// Ordered by source, target, then sides and bodies.
struct Bitangent {
    BodyId source_body;  ///< none when the contact is on the world, a wall or a point
    BodyId target_body;
    Side source_side = Side::left;  ///< looking from source to target, at both contacts
    Side target_side = Side::left;
    VertexId source;
    VertexId target;

    /// LR or RL: *inner*, the two things lie on different sides.
    [[nodiscard]] bool separates() const noexcept {
        return (source_side == Side::left && target_side == Side::right) ||
               (source_side == Side::right && target_side == Side::left);
    }
    /// LL or RR: *outer*, both lie on one side.
    [[nodiscard]] bool is_outer() const noexcept {
        return source_side == target_side &&
               (source_side == Side::left || source_side == Side::right);
    }
    /// Whether it is the canonical one of its two directions: from the lesser vertex.
    [[nodiscard]] bool is_canonical() const noexcept { return source < target; }
    /// Two letters, e.g. "LR".
    [[nodiscard]] std::string type() const;

    friend bool operator==(const Bitangent&, const Bitangent&) = default;
    friend std::strong_ordering operator<=>(const Bitangent& a, const Bitangent& b) noexcept {
        const auto key = [](const Bitangent& x) {
            return std::tie(x.source, x.target, x.source_side, x.target_side, x.source_body,
                            x.target_body);
        };
        return key(a) <=> key(b);
    }
};

/// A bitangent whose segment between the contacts is free and contains no other scene vertex.
using FreeBitangent = Bitangent;

/// The same line in the other direction.
[[nodiscard]] constexpr Bitangent reversed(const Bitangent& b) noexcept {
    return {b.target_body,           b.source_body, reversed(b.target_side),
            reversed(b.source_side), b.target,      b.source};
}
/// The direction that stands for both: from the lesser vertex.
[[nodiscard]] constexpr Bitangent canonical(const Bitangent& b) noexcept {
    return b.source < b.target ? b : reversed(b);
}

/// "LR v1 v3 b0 b1": type, contacts, their bodies (b- for none).
[[nodiscard]] std::string to_string(const Bitangent& b);
/// Reads what to_string writes. Fails with Errc::syntax.
[[nodiscard]] Result<Bitangent> bitangent_from_text(std::string_view text);
std::ostream& operator<<(std::ostream& out, const Bitangent& b);

/// A directed line from a point that is locally tangent to a body at a vertex.
/// Ordered by contact, then the rest.
struct SupportingLine2 {
    VertexId contact;
    BodyId body;
    Side side = Side::left;  ///< of the body, looking from the point to the contact
    Point2 from;

    friend bool operator==(const SupportingLine2&, const SupportingLine2&) = default;
    friend std::partial_ordering operator<=>(const SupportingLine2&,
                                             const SupportingLine2&) = default;
};

/// "L v3 b0 (1, 2.5)": side, contact, body, the point.
[[nodiscard]] std::string to_string(const SupportingLine2& line);
/// Reads what to_string writes. Fails with Errc::syntax.
[[nodiscard]] Result<SupportingLine2> supporting_line_from_text(std::string_view text);
std::ostream& operator<<(std::ostream& out, const SupportingLine2& line);

}  // namespace sightline

template <>
struct std::hash<sightline::Bitangent> {
    /// Bodies follow from the vertices of a scene.
    std::size_t operator()(const sightline::Bitangent& b) const noexcept {
        const std::uint64_t vertices = std::uint64_t{b.source.value} << 32U | b.target.value;
        const auto sides = static_cast<std::uint64_t>(b.source_side) * 4 +
                           static_cast<std::uint64_t>(b.target_side);
        return std::hash<std::uint64_t>{}(vertices * 0x9E3779B97F4A7C15U + sides);
    }
};

template <>
struct std::hash<sightline::SupportingLine2> {
    std::size_t operator()(const sightline::SupportingLine2& line) const noexcept {
        // Adding zero makes 0 and -0, which are equal, the same.
        const std::hash<double> of;
        const std::size_t point = of(line.from.x + 0.0) * 31 + of(line.from.y + 0.0);
        return (point * 31 + line.contact.value) * 31 + static_cast<std::size_t>(line.side);
    }
};
