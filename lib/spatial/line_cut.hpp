// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A line cut at every place where it touches the scene, and the maximal free segments on it. Private.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sightline/spatial/free_segment3.hpp"
#include "spatial/exact_line.hpp"
#include "spatial/exact_triangles.hpp"
#include "spatial/local_cone.hpp"
#include "spatial/scene_forms.hpp"

namespace sightline::detail {

enum class Feature : std::uint8_t { vertex, edge, face };

/// A feature that meets the line in one point: a vertex, an edge's relative interior, a face's.
struct Contact {
    Feature feature = Feature::vertex;
    std::uint32_t id = 0;
    Real position;  ///< coordinate along the line's main axis
    std::uint32_t place = 0;
};

/// A maximal free segment of the line: between two places, `first` = none for one that comes from
/// infinity, `last` likewise.
struct Run {
    static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
    std::uint32_t first = none;
    std::uint32_t last = none;

    [[nodiscard]] bool contains(std::uint32_t place) const {
        return (first == none || first <= place) && (last == none || place <= last);
    }
};

/// For both ends of a segment: what is behind all planes of an end is behind the end.
using StoppingFaces = std::array<std::vector<FaceId>, 2>;

/// What is known to be on a line before it is cut: signs that need no computing, and what is asked for.
struct KnownFeatures {
    /// The line passes through these.
    std::span<const VertexId> vertices;
    /// The line meets the lines of these.
    std::span<const EdgeId> edges;
    /// The line is no special member of its family: it meets those edges in their relative interior, and
    /// contains no edge that ends at those vertices.
    bool is_general = false;
    /// Only the segment that touches all of the above matters: what is surely behind something that stops it
    /// need not be found, and nothing at all when something surely stands between them.
    bool only_their_segment = false;
    /// One more feature of each kind, of which only this is known; may be none.
    VertexId also_vertex{};
    EdgeId also_edge{};
};

/// Keeps its buffers from one line to the next.
class LineCut {
public:
    explicit LineCut(const SceneForms& forms);

    /// Cuts the line. The line must live until the next call.
    void cut(const Line& line, const KnownFeatures& known = {});

    [[nodiscard]] std::span<const Contact> contacts() const { return contacts_; }
    [[nodiscard]] std::uint32_t place_count() const { return place_count_; }
    [[nodiscard]] std::span<const Run> runs() const { return runs_; }
    /// The coordinate that contacts' positions are, and the sign of the direction's.
    [[nodiscard]] int axis() const { return axis_; }
    [[nodiscard]] Sign axis_sign() const { return axis_sign_; }
    /// The place where the line meets an edge (anywhere on it, ends included) or a vertex; none when
    /// it does not, or runs along the edge.
    [[nodiscard]] std::uint32_t place_of(EdgeId e) const;
    [[nodiscard]] std::uint32_t place_of(VertexId v) const;
    /// Edges that the line runs along.
    [[nodiscard]] std::span<const EdgeId> collinear_edges() const { return collinear_; }

    [[nodiscard]] SegmentLabel label(const Run& run) const;
    /// What stops a segment that arrives at a place where the next piece is blocked, or a sheet crossed.
    [[nodiscard]] SegmentEnd end_at(std::uint32_t place, std::uint32_t blocked_piece,
                                    Heading towards) const;
    /// The faces in which what is blocked behind the run's ends runs, between solids pressed on each other;
    /// ascending.
    [[nodiscard]] std::vector<FaceId> contact_faces(const Run& run) const;
    /// Whether the line runs along an edge on both sides of a place.
    [[nodiscard]] bool runs_along(EdgeId e, std::uint32_t place) const;
    /// A body that blocks some piece between two places by itself; none when there is none.
    [[nodiscard]] BodyId blocker_between(std::uint32_t first, std::uint32_t last) const;
    /// The faces along which the line runs where bodies in contact first block it, if that is between two
    /// places.
    [[nodiscard]] std::vector<FaceId> seal_between(std::uint32_t first, std::uint32_t last) const;
    /// With only_their_segment: a face that surely stands between the known features. Nothing else is known of
    /// the line then.
    [[nodiscard]] FaceId blocking_face() const { return blocking_; }
    /// A face that the line crosses inside, strictly between two places; none when there is none.
    [[nodiscard]] FaceId face_between(std::uint32_t first, std::uint32_t last) const;
    /// For each end of the run, all faces there, at least one of which the line crosses from front to back. (Where
    /// lines near it pass the end, they do so beside one of the faces; so none may be left out.)
    /// Empty where a sheet's back stops it.
    [[nodiscard]] StoppingFaces stopping_faces(const Run& run) const;
    /// The run that contains all places from first to last, which are two different ones.
    [[nodiscard]] std::optional<Run> run_through(std::uint32_t first, std::uint32_t last) const;

private:
    /// A body at a place, before and after it.
    struct Touch {
        BodyId body;
        std::uint32_t place;
        LocalState before, after;
    };

    void collect(const KnownFeatures& known);
    void collect_near(const KnownFeatures& known);
    [[nodiscard]] bool find_window(const KnownFeatures& known);
    [[nodiscard]] Real position_of(const Contact& c) const;
    void assume(const KnownFeatures& known);
    void add_triangle(std::uint32_t triangle);
    [[nodiscard]] Sign side_of(std::size_t line_index);
    void add_edge(EdgeId e);
    void add_vertex(VertexId v);
    void find_axis();
    void position_contacts();
    [[nodiscard]] int order(const Contact& a, const Contact& b) const;
    void sort_into_places();
    void find_touches();
    void find_blocked();
    void follow_solid(std::span<const Touch> touches);
    void follow_sheet(std::span<const Touch> touches);
    void seal();
    [[nodiscard]] bool is_last_before(std::size_t touch, std::uint32_t piece) const;
    void find_runs();
    [[nodiscard]] BodyId body_of(const Contact& c) const;
    void add_contact(std::uint32_t piece, std::vector<FaceId>& faces) const;
    [[nodiscard]] bool stops(BodyId body, std::uint32_t place, std::uint32_t piece) const;
    [[nodiscard]] Integer axis_form(const Contact& c, PlaneOf<Integer>& plane) const;
    [[nodiscard]] std::int64_t place_or_side(VertexId v) const;
    void add_support(const Run& run, Support& support) const;

    const SceneForms* forms_;
    const Line* line_ = nullptr;
    int axis_ = 0;
    Sign axis_sign_ = Sign::positive;
    std::vector<Contact> contacts_;
    std::uint32_t place_count_ = 0;
    std::vector<EdgeId> collinear_;
    std::vector<Touch> touches_;
    std::vector<bool> blocked_;    // piece i lies before place i
    std::vector<BodyId> blocker_;  // one body that blocks the piece
    /// Places at which the line runs along sheets in between; a single one where it does not.
    struct Stay {
        std::uint32_t first, last;
    };
    [[nodiscard]] bool is_sheet(BodyId b) const;
    void judge_joint_stays();
    [[nodiscard]] bool is_on_sheet(std::uint32_t place) const;
    [[nodiscard]] bool runs_along_sheet(std::uint32_t piece) const;
    [[nodiscard]] bool is_joint(const Stay& stay) const;
    void judge(const Stay& stay);
    template <typename Number>
    [[nodiscard]] std::vector<BodyId> crossed_sheets(const Stay& stay) const;

    struct SheetCut {
        BodyId sheet;
        std::uint32_t first, last;  // the places where a crossed stay on a sheet begins and ends
    };
    std::vector<SheetCut> cuts_;                                     // by first place
    mutable std::shared_ptr<const ExactTriangles> exact_triangles_;  // made when first needed
    bool has_sheets_ = false;
    std::vector<std::pair<std::uint32_t, FaceId>>
        seals_;  ///< sealed pieces and the faces round them
    std::vector<Run> runs_;

    FaceId blocking_;
    // Along the main axis: bounds of the known features' places, and of what can matter.
    double first_ = 0, last_ = 0, window_low_ = 0, window_high_ = 0;

    std::uint32_t stamp_ = 0;
    std::vector<std::uint32_t> side_stamp_, edge_stamp_, vertex_stamp_, face_stamp_;
    std::vector<Sign> side_sign_;
};

}  // namespace sightline::detail
