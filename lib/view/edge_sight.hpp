// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which parts of one edge are visible, and what passes before it there. Private.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "view/edge_events.hpp"
#include "view/image.hpp"

namespace sightline::detail {

/// A visible place on an edge where another feature is seen too, or where a piece ends.
struct EdgePlace {
    EdgeEvent at;
    std::vector<std::uint32_t> edges;  ///< that cross there; numbers of sides follow those of edges
    std::vector<std::uint32_t> collinear{};  ///< that lie before the edge on its great circle
    std::vector<std::uint32_t> points{};     ///< vertices, its own included
    std::vector<std::uint32_t> fronts{};     ///< those of `edges` behind which the edge disappears
    /// Two edges in the edge's sight plane that cross each other in space on this line of sight, if any.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> contacts{};
    bool piece_begins = false;
    bool piece_ends = false;
};

/// The visible part of an edge, as places in the order from source to target. Pieces run from a place that begins
/// one to the next that ends one; a place may do both.
struct EdgeView {
    std::vector<EdgePlace> places;
    /// Ends that may be visible though what is next to them is hidden, and what is seen there if they are.
    std::vector<EdgePlace> in_question;
};

/// What each face and edge is to one viewpoint.
struct Facings {
    Facings(Image& image, bool viewpoint_on_boundary);

    std::vector<Sign> face;       ///< positive: the front is seen
    std::vector<char> is_hidden;  ///< per placed edge: the solid itself lies before it
    /// Per placed edge: lines of sight that cross it are blocked there.
    std::vector<char> is_sealed;
    /// From a point on the boundary of a solid, backs hide as well: one looks through the inside.
    bool backs_hide = false;
};

/// Looks at edges one after the other.
class EdgeSight {
public:
    EdgeSight(Image& image, const Facings& facings, std::uint32_t cone_sides)
        : image_(image), facings_(facings), cone_sides_(cone_sides), order_(image) {}

    /// The visible part of placed edge e; empty for edges that are seen end-on.
    void look(std::uint32_t e, EdgeView& out);

private:
    struct Hidden {
        static constexpr std::uint32_t beyond = no_edge;
        std::uint32_t from = beyond;  ///< an event, or beyond the end
        std::uint32_t to = beyond;
        bool from_sealed = false;
        bool to_sealed = false;
    };
    struct Over {
        std::uint32_t edge = 0;
        std::uint32_t from = Hidden::beyond;
        std::uint32_t to = Hidden::beyond;
    };
    /// Where a convex image enters and leaves the edge's great circle, and which part of the edge it covers.
    struct Cut {
        EdgeEvent event;
        bool is_sealed = false;
        Sign at_u{};  ///< positive: u is on the inner side
        Sign at_w{};
    };
    enum class Depth : std::uint8_t { before, level, behind };

    void gather(std::vector<std::uint32_t>& out) const;
    void meet(std::uint32_t triangle);
    void meet_cone();
    void meet_edge_on(const PlacedTriangle& t, const std::array<Sign, 3>& s);
    void meet_across(const PlacedTriangle& t, const std::array<Sign, 3>& s);
    void meet_side(const PlacedTriangle& t, std::size_t k);
    void meet_vertex(std::uint32_t a);
    void meet_crossing(std::uint32_t a, std::uint32_t b, std::uint32_t edge, Sign at_a);
    [[nodiscard]] Cut cut_at_side(const PlacedTriangle& t, std::size_t k, Sign facing) const;
    [[nodiscard]] Cut cut_at_vertex(std::uint32_t a, bool entering) const;
    /// Whether the cut covers a part of positive length; touched ends become events.
    [[nodiscard]] bool covers(const Cut& in, const Cut& out, Hidden& covered);
    /// Keeps what of `covered` lies behind a plane, whose heights at u and w are positive before it, and which
    /// `crossing` cuts.
    template <typename Crossing>
    [[nodiscard]] Depth keep_behind(Sign height_u, Sign height_w, const Crossing& crossing,
                                    Hidden& covered);
    std::uint32_t add(const EdgeEvent& event);
    [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b) const;
    /// A vertex off the edge's sight plane; none when the whole scene lies in it.
    [[nodiscard]] std::uint32_t off_plane();
    /// In the edge's sight plane: positive when x is on the viewpoint's side of the line pq.
    [[nodiscard]] Sign level(std::uint32_t p, std::uint32_t q, std::uint32_t x);
    [[nodiscard]] Rational exact_level(std::uint32_t p, std::uint32_t q, std::uint32_t x);
    void collect(EdgeView& out);
    void rank_events();
    void cover();
    void doubt_gaps();
    void add_contact_corners();
    [[nodiscard]] bool is_free_at(const Rational& t);
    void list_places(EdgeView& out);
    void describe(std::uint32_t rank, EdgePlace& place);

    Image& image_;
    const Facings& facings_;
    std::uint32_t cone_sides_;
    EdgeOrder order_;

    std::uint32_t edge_ = 0;
    std::uint32_t u_ = 0;
    std::uint32_t w_ = 0;
    std::size_t axis_ = 0;
    Sign axis_sign_{};
    SightPlane plane_;
    std::uint32_t off_plane_ = no_edge;
    bool all_hidden_ = false;
    bool in_doubt_ =
        false;  ///< features in the edge's own sight plane may hide it without a face that covers it

    std::vector<std::uint32_t> near_;
    std::vector<std::uint32_t> in_plane_;
    std::vector<EdgeEvent> events_;
    std::vector<Hidden> hidden_;
    std::vector<Over> over_;
    std::vector<std::uint32_t> order_of_;  ///< events, sorted
    std::vector<std::uint32_t> rank_;      ///< per event
    std::uint32_t ranks_ = 0;
    std::vector<char> gap_hidden_;
    std::vector<char> place_hidden_;
};

}  // namespace sightline::detail
