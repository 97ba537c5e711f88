// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reference/picture.hpp"

namespace sightline::reference {

/// What may lie near a sight line: all edges that touch it, and all scene vertices on it that
/// belong to no edge, are among these.
struct Candidates {
    std::span<const EdgeId> edges;
    std::span<const VertexId> points;
};

/// Every edge and every point of a scene, as candidates.
class Everything {
public:
    explicit Everything(const Scene2& scene);
    [[nodiscard]] Candidates candidates() const { return {edges_, points_}; }

private:
    std::vector<EdgeId> edges_;
    std::vector<VertexId> points_;
};

enum class Reach : std::uint8_t { segment, ray };

/// A segment pq, or the ray from p through q, with everything that it meets: the law of free
/// segments (semantics 2.4), word by word.
///
/// The places where the line meets edges cut it into elementary intervals. An interval is blocked
/// when it lies in the interior of B. A maximal interval I of the line inside the union W of the
/// walls, with something of the line before it and after it, is blocked when the line comes and
/// leaves in different components of the complement of W ∪ B near I, while B alone does not
/// separate them.
class SightLine {
public:
    /// p and q are different, and p is not in the open inside of B (what happens on its boundary is
    /// seen).
    SightLine(const Scene2& scene, const Candidates& near, const Place& p, const Place& q,
              Reach reach);

    /// Whether the open segment (or ray) contains a scene vertex.
    [[nodiscard]] bool passes_vertex() const noexcept { return passes_vertex_; }

    /// Which ends of a segment are extended, a little, for the test.
    struct Extension {
        bool beyond_p = false;
        bool beyond_q = false;
    };
    /// Whether nothing blocks the line.
    [[nodiscard]] bool is_free(const Extension& extension) const;
    [[nodiscard]] bool is_free() const { return is_free({}); }

    /// The farthest place up to which the line is free; empty when it is free to its end. For rays.
    [[nodiscard]] std::optional<Place> stop() const;

    /// Whether the whole segment lies on boundaries of bodies or of the world.
    [[nodiscard]] bool runs_along_bodies() const;

    /// The ways along a free segment that contains no vertex: a sector of the picture at p and one of the
    /// picture at q. Along a wall there is one on each free side, unless another wall crosses it.
    struct Way {
        std::size_t from;
        std::size_t to;
    };
    [[nodiscard]] std::vector<Way> ways() const;
    [[nodiscard]] const Picture& picture_at_p() const { return pictures_.front(); }
    [[nodiscard]] const Picture& picture_at_q() const { return pictures_.back(); }

private:
    struct Run {
        std::size_t first;
        std::size_t last;
    };

    void meet(const Scene2& scene, const Candidates& near, EdgeId edge);
    [[nodiscard]] bool is_pierced(const Scene2& scene, const Candidates& near, EdgeId edge) const;
    void note_vertex(const Place& vertex);
    void take_pictures(const Scene2& scene);
    [[nodiscard]] bool is_within(const Place& x) const;
    [[nodiscard]] Heading forward(std::size_t event) const;
    [[nodiscard]] Heading backward(std::size_t event) const;
    /// Index of the event at which the line ends to be free, if any.
    [[nodiscard]] std::optional<std::size_t> first_block(const Extension& extension) const;
    [[nodiscard]] bool is_crossed(const Run& run) const;

    Place p_;
    Place q_;
    Reach reach_;
    bool cut_ = false;  // a body edge crosses the inside of the segment properly
    bool passes_vertex_ = false;
    std::vector<EdgeId> touching_;
    std::vector<Place> places_;      // where something happens, in order from p
    std::vector<Picture> pictures_;  // and what is there
};

}  // namespace sightline::reference
