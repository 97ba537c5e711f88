// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The events nearest to a sample of a curve, on both sides. Private.

#include <span>

#include "skeleton/parameter.hpp"
#include "spatial/line_cut.hpp"

namespace sightline::detail {

/// What happens at an event: the line meets the edge's line, and the vertex when there is one.
struct EventName {
    EdgeId edge;
    VertexId vertex;
    int branch = 0;
    EdgeId crossing;  ///< the second of two edges that cross

    friend bool operator==(const EventName&, const EventName&) = default;
};

/// How far a state reaches round a sample: to the nearest events, or to the ends of the interval.
struct Reach {
    Parameter left, right;
    bool left_is_event = false;
    bool right_is_event = false;
    /// What happens there, at the interval's ends too.
    EventName left_event, right_event;
};

/// A piece of a curve, between events.
struct CurveInterval {
    Parameter first, last;
    EventName first_event, last_event;
};

class ReachSearch {
public:
    ReachSearch(const Curve& curve, const CurveInterval& interval, const Parameter& sample)
        : curve_(curve),
          policy_(curve.policy()),
          sample_(sample),
          reach_{interval.first, interval.last,        false,
                 false,          interval.first_event, interval.last_event} {}

    /// Considers the events at which lines touch some edge of the scene within the segment that ends
    /// at the stopping faces.
    void search_segment(const StoppingFaces& stopping, std::span<const EventName> dismissed);
    /// Considers all events of the scene.
    void search_all(std::span<const EventName> dismissed);
    /// Considers the events at which lines meet the lines of these edges.
    void search_edges(std::span<const EdgeId> edges);

    /// Whether the sample turned out to be an event itself: nothing is known then.
    [[nodiscard]] bool hit_sample() const { return hit_sample_; }
    [[nodiscard]] const Reach& reach() const { return reach_; }

private:
    bool consider_edge(EdgeId e, bool everywhere);
    bool consider_crossings(EdgeId e, bool everywhere);
    [[nodiscard]] bool surely_passes_outside(VertexId v) const;
    [[nodiscard]] bool contains_all(EdgeId e) const;
    bool consider_form(const EventForm& form, EdgeId e, bool everywhere);
    bool offer(Parameter&& t, EdgeId e, const EventForm& form, bool everywhere);
    [[nodiscard]] bool surely_outside(const Quadratic<Real>& q) const;
    [[nodiscard]] bool surely_irrelevant(const Parameter& t, EdgeId e) const;

    const Curve& curve_;
    const Policy& policy_;
    const Parameter& sample_;
    Reach reach_;
    bool hit_sample_ = false;
    const StoppingFaces* stopping_ = nullptr;
    std::span<const EventName> dismissed_;
};

}  // namespace sightline::detail
