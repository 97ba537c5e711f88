// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Places along one edge where other features pass before it, in exact order. Private.

#include <cstdint>
#include <memory>
#include <vector>

#include "view/image.hpp"

namespace sightline::detail {

/// A place u + t (w - u) of the edge uw, kept as what makes it.
struct EdgeEvent {
    enum class Kind : std::uint8_t {
        source,
        target,
        edge,     ///< where the image of the segment ab crosses
        vertex,   ///< where the image of a lies, which is on the edge's great circle
        plane,    ///< where the edge crosses the plane of a, b, c
        fraction  ///< at the parameter `value`
    };
    Kind kind = Kind::source;
    bool hides = false;     ///< the edge is hidden on one side
    bool is_named = false;  ///< of vertices: known to be before the edge
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t c = 0;
    std::uint32_t edge = no_edge;   ///< the placed edge that passes here, or a side of the cone
    std::uint32_t other = no_edge;  ///< for fractions: another one
    std::uint32_t exact = no_edge;  ///< index into EdgeOrder's table, or none
    Near t;
    std::shared_ptr<const Rational> value{};  ///< of fractions
};

/// Orders places of one edge.
class EdgeOrder {
public:
    explicit EdgeOrder(Image& image) : image_(image) {}

    /// Begins with another edge; `axis` is a component in which u × w does not vanish.
    void begin(std::uint32_t u, std::uint32_t w, std::size_t axis) {
        u_ = u;
        w_ = w;
        axis_ = axis;
        table_.clear();
    }
    [[nodiscard]] EdgeEvent source() const {
        return {.kind = EdgeEvent::Kind::source, .t = {0, 0}};
    }
    [[nodiscard]] EdgeEvent target() const {
        return {.kind = EdgeEvent::Kind::target, .t = {1, 0}};
    }
    [[nodiscard]] EdgeEvent crossing(std::uint32_t a, std::uint32_t b, std::uint32_t edge) const;
    [[nodiscard]] EdgeEvent vertex(std::uint32_t a) const;
    [[nodiscard]] EdgeEvent plane(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
    [[nodiscard]] EdgeEvent fraction(const Rational& t);

    /// The order of two places of the edge.
    [[nodiscard]] Sign compare(EdgeEvent& x, EdgeEvent& y);
    /// The exact parameter.
    [[nodiscard]] const Rational& exact(EdgeEvent& x);

private:
    [[nodiscard]] bool certainly_equal(const EdgeEvent& x, const EdgeEvent& y) const;
    [[nodiscard]] Rational parameter(const EdgeEvent& x);

    Image& image_;
    std::uint32_t u_ = 0;
    std::uint32_t w_ = 0;
    std::size_t axis_ = 0;
    std::vector<Rational> table_;
};

}  // namespace sightline::detail
