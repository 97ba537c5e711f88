// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "reference/cell3.hpp"
#include "reference/line_picture3.hpp"

namespace sightline::reference::detail {

/// A maximal free segment; indices of points of the line, which are empty at infinity.
struct LineSegment {
    std::optional<std::size_t> from;
    std::optional<std::size_t> to;
    std::array<SegmentEnd, 2> ends;  ///< at `from` and at `to`
    Cell cell;
};

/// A line cut at all points where it meets faces, edges and vertices, into pieces: piece k lies before
/// point k, the last one behind all points.
class LineCut {
public:
    LineCut(const ExactScene& scene, const LinePicture& picture);

    /// t of the points, ascending.
    [[nodiscard]] const std::vector<Surd>& points() const { return points_; }
    /// Where the line meets a closed edge that it is not along.
    [[nodiscard]] std::optional<std::size_t> meeting(EdgeId e) const;
    [[nodiscard]] std::optional<std::size_t> point_at(const Surd& t) const;

    [[nodiscard]] std::vector<LineSegment> maximal_free_segments() const;

private:
    friend class Surroundings;

    /// The closed triangles meet the line in one point (first == last) or run along it.
    struct Trace {
        FaceId face;
        std::size_t triangle;
        std::size_t first;
        std::size_t last;
    };
    struct Crossing {  // of an edge that is not along the line
        EdgeId edge;
        std::size_t at;
    };
    struct Run {  // of an edge that is along the line
        EdgeId edge;
        std::size_t first;
        std::size_t last;
    };
    struct Interval {
        std::size_t first;
        std::size_t last;
    };

    void find_traces();
    void find_features();
    void find_blockers();
    [[nodiscard]] std::size_t index_of(const Surd& t) const;

    [[nodiscard]] BodyId body(FaceId f) const { return scene_->scene[f].body; }
    [[nodiscard]] bool is_sheet(BodyId b) const {
        return scene_->scene[b].kind == SurfaceKind::sheet;
    }
    /// Whether what lies between two points along the line contains piece k.
    template <typename Range>
    [[nodiscard]] static bool covers(const Range& range, std::size_t k) {
        return range.first < k && k <= range.last;
    }
    [[nodiscard]] bool is_on_boundary(BodyId solid, std::size_t piece) const;
    [[nodiscard]] bool is_inside(BodyId solid, std::size_t piece) const;
    [[nodiscard]] bool is_sealed(std::size_t piece) const;
    [[nodiscard]] bool is_blocked(std::size_t piece) const { return !blockers_[piece].empty(); }

    /// The intervals of sheets that block the line, although it is free around them and in them.
    [[nodiscard]] std::vector<std::pair<Interval, std::vector<BodyId>>> crossed_sheets() const;
    [[nodiscard]] std::vector<Interval> sheet_intervals() const;
    [[nodiscard]] SegmentEnd solid_end(std::size_t blocked_piece, std::size_t point) const;
    [[nodiscard]] SegmentEnd sheet_end(const std::vector<BodyId>& sheets, std::size_t point,
                                       int direction) const;
    void add_contact(std::size_t blocked_piece, std::vector<FaceId>& faces) const;
    [[nodiscard]] Cell cell_of(const LineSegment& segment) const;
    [[nodiscard]] bool is_along_inside(std::size_t point, const Run& run) const {
        return run.first < point && point < run.last;
    }

    const ExactScene* scene_;
    const LinePicture* picture_;
    std::vector<Surd> points_;
    std::vector<Trace> traces_;
    std::vector<std::vector<std::size_t>> crossings_of_body_;
    std::vector<std::pair<VertexId, std::size_t>> vertices_;
    std::vector<Crossing> edges_;
    std::vector<Run> runs_;
    std::vector<std::vector<BodyId>>
        blockers_;  // of each piece: the solids that contain it, if blocked
};

}  // namespace sightline::reference::detail
