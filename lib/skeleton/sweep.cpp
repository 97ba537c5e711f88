// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/sweep.hpp"

#include <algorithm>

#include "skeleton/root_order.hpp"

namespace sightline::detail {

namespace {

/// Whether the line meets the closed edge, given that it meets the edge's line; the filter's first word.
/// Empty when it does not know.
std::optional<bool> surely_meets(const SceneForms& forms, const PluckerOf<Real>& line, EdgeId e) {
    const Edge3& edge = forms.scene()[e];
    const Vec3<Real> at_source = normal_from(line, forms.point<Real>(edge.source));
    const Vec3<Real> at_target = normal_from(line, forms.point<Real>(edge.target));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto s = at_source[i].sign();
        const auto t = at_target[i].sign();
        if (!s || !t || *s == Sign::zero || *t == Sign::zero) continue;
        return *s != *t;
    }
    return std::nullopt;
}

}  // namespace

Sweep::Sweep(const SceneForms& forms, const Policy& policy, SweepOutput output)
    : forms_(forms), policy_(policy), output_(std::move(output)), cut_(forms) {}

void Sweep::run(const Curve& curve) {
    const auto valid = intervals(curve);
    if (valid.empty()) return;
    collect_events(curve);
    for (const Interval& interval : valid) sweep(curve, interval);
}

bool Sweep::meets_generators(const Curve& curve, const Parameter& t) const {
    const CurvePoint point(curve, t);
    const Line line(point.real_line(), point, policy_);
    const std::size_t count = curve.kind() == CurveKind::regulus ? 3 : 2;
    for (std::size_t i = 1; i < count; ++i) {
        const Edge3& edge = forms_.scene()[curve.edges()[i]];
        bool apart = false;
        for (int axis = 0; axis < 3 && !apart; ++axis) {
            const auto sign_at = [&](VertexId v) {
                return line.sign(Predicate::line_form3, [&]<typename N>(const PluckerOf<N>& l) {
                    return normal_from(l, forms_.point<N>(v), axis);
                });
            };
            const Sign a = sign_at(edge.source);
            const Sign b = sign_at(edge.target);
            if (a == Sign::zero || b == Sign::zero) continue;
            if (a == b) return false;
            apart = true;
        }
        if (!apart) return false;
    }
    return true;
}

std::vector<Sweep::Interval> Sweep::intervals(const Curve& curve) const {
    const Parameter zero = Parameter::dyadic(0);
    const Parameter one = Parameter::dyadic(1);
    if (curve.kind() == CurveKind::vertex_pencil || curve.kind() == CurveKind::contact_pencil) {
        return {{zero, one}};
    }
    std::vector<Parameter> cuts{zero, one};
    const std::size_t count = curve.kind() == CurveKind::regulus ? 3 : 2;
    for (std::size_t i = 1; i < count; ++i) {
        const EdgeId e = curve.edges()[i];
        for (const VertexId v : {forms_.scene()[e].source, forms_.scene()[e].target}) {
            const auto form = curve.vertex_form(v, e);
            if (!form) continue;
            for (Parameter& t : roots(curve, *form, curve.evaluate<Real>(*form))) {
                if (compare(policy_, t, zero) != Sign::positive) continue;
                if (compare(policy_, t, one) != Sign::negative) continue;
                cuts.push_back(std::move(t));
            }
        }
    }
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        for (std::size_t j = i; j > 0 && compare(policy_, cuts[j], cuts[j - 1]) == Sign::negative;
             --j) {
            std::swap(cuts[j], cuts[j - 1]);
        }
    }
    std::vector<Interval> result;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        if (compare(policy_, cuts[i], cuts[i + 1]) != Sign::negative) continue;
        if (meets_generators(curve, between(cuts[i], cuts[i + 1]))) {
            result.push_back({cuts[i], cuts[i + 1]});
        }
    }
    return result;
}

void Sweep::collect_events(const Curve& curve) {
    events_.clear();
    for (std::uint32_t e = 0; e < forms_.edge_count(); ++e) add_edge_events(curve, EdgeId{e});
    std::ranges::sort(events_, [&](const Event& a, const Event& b) {
        return compare(policy_, a.t, b.t) == Sign::negative;
    });
}

void Sweep::add_edge_events(const Curve& curve, EdgeId e) {
    if (std::ranges::find(curve.edges(), e) != curve.edges().end()) {
        if (e != curve.base()) add_vertex_events(curve, e);
        return;
    }
    const EventForm form{EventForm::Kind::line, e.value, VertexId::none(), 0};
    const Quadratic<Real> q = curve.evaluate<Real>(form);
    if (curve.vanishes(q, form)) {
        add_vertex_events(curve, e);
        return;
    }
    for (Parameter& t : roots(curve, form, q)) {
        if (t.upper() < 0 || t.lower() > 1) continue;
        const CurvePoint point(curve, t);
        if (surely_meets(forms_, point.real_line(), e) == false) continue;
        events_.push_back({std::move(t), e});
    }
}

void Sweep::add_vertex_events(const Curve& curve, EdgeId e) {
    for (const VertexId v : {forms_.scene()[e].source, forms_.scene()[e].target}) {
        const auto form = curve.vertex_form(v, e);
        if (!form) continue;
        for (Parameter& t : roots(curve, *form, curve.evaluate<Real>(*form))) {
            if (t.upper() < 0 || t.lower() > 1) continue;
            events_.push_back({std::move(t), e});
        }
    }
}

void Sweep::sweep(const Curve& curve, const Interval& interval) {
    // Groups of events at one parameter, from the interval's first to its last.
    std::vector<Event> inside;
    for (const Event& e : events_) {
        if (compare(policy_, e.t, interval.first) != Sign::positive) continue;
        if (compare(policy_, e.t, interval.last) != Sign::negative) continue;
        inside.push_back(e);
    }
    State state;
    std::vector<Event> group{{interval.first, EdgeId::none()}};
    std::size_t next = 0;
    while (true) {
        const Parameter& right = next < inside.size() ? inside[next].t : interval.last;
        pass(curve, group, right, true, state);
        if (next >= inside.size()) break;
        group.assign(1, inside[next++]);
        while (next < inside.size() &&
               compare(policy_, group.front().t, inside[next].t) == Sign::zero) {
            group.push_back(inside[next++]);
        }
    }
    group.assign(1, {interval.last, EdgeId::none()});
    pass(curve, group, interval.last, false, state);
}

bool Sweep::concerns(const Curve& /*curve*/, std::span<const Event> group,
                     const State& state) const {
    if (!state.is_known || state.is_free) return true;
    for (const Event& e : group) {
        if (e.edge.is_none()) return true;
        if (state.blocker.is_none() || forms_.scene()[e.edge].body == state.blocker) return true;
    }
    return false;
}

void Sweep::pass(const Curve& curve, std::span<const Event> group, const Parameter& right,
                 bool has_right, State& state) {
    if (!concerns(curve, group, state)) return;
    const Event& event = group.front();
    const bool was_free = state.is_known && state.is_free;
    std::optional<std::uint32_t> node;
    if (was_free) {
        node = node_at(curve, event, &state.label);
        if (!node) return;
        add_arc(curve, state, *node);
    }
    State after;
    if (has_right) look(curve, between(event.t, right), after);
    if (!was_free && !event.edge.is_none()) {
        // A line may be free between two blocked neighbours only where more happens than one crossing.
        const bool may_be_alone =
            group.size() > 1 || event.t.is_double() || forms_.scene().has_touching_bodies();
        if (after.is_free || may_be_alone) node = node_at(curve, event, nullptr);
    } else if (!was_free && after.is_free) {
        node = node_at(curve, event, nullptr);
    }
    if (after.is_free) {
        SIGHTLINE_AUDIT(node.has_value());
        if (!node) after = State{};
        if (node) after.node = *node;
    }
    state = std::move(after);
}

std::optional<std::pair<std::uint32_t, std::uint32_t>> Sweep::generator_places(
    const Curve& curve) const {
    std::uint32_t first = Run::none;
    std::uint32_t last = 0;
    const auto include = [&](std::uint32_t place) {
        if (place == Run::none) return false;
        first = std::min(first, place);
        last = std::max(last, place);
        return true;
    };
    if (curve.kind() == CurveKind::vertex_pencil && !include(cut_.place_of(curve.vertex()))) {
        return std::nullopt;
    }
    for (const EdgeId e : curve.edges()) {
        if (!include(cut_.place_of(e))) return std::nullopt;
    }
    if (first == last) return std::nullopt;
    return std::pair{first, last};
}

void Sweep::look(const Curve& curve, const Parameter& t, State& state) {
    state.is_known = true;
    const CurvePoint point(curve, t);
    const Line line(point.real_line(), point, policy_);
    cut_.cut(line);
    const auto places = generator_places(curve);
    if (!places) return;
    const auto run = cut_.run_through(places->first, places->second);
    if (!run) {
        state.blocker = cut_.blocker_between(places->first, places->second);
        return;
    }
    state.is_free = true;
    state.label = cut_.label(*run);
    state.type = arc_type(forms_, cut_, *run, line, state.label);
}

std::optional<std::uint32_t> Sweep::node_at(const Curve& curve, const Event& event,
                                            const SegmentLabel* unless) {
    const CurvePoint point(curve, event.t);
    const Line line(point.real_line(), point, policy_);
    cut_.cut(line);
    const auto places = generator_places(curve);
    if (!places) return std::nullopt;
    const auto run = cut_.run_through(places->first, places->second);
    if (!run) return std::nullopt;
    SegmentLabel label = cut_.label(*run);
    if (unless != nullptr && label == *unless) return std::nullopt;
    FoundNode found = describe_node(forms_, cut_, *run, line, std::move(label));
    found.node.root = root_of(curve, event.t, line, found.node);
    return output_.add_node(std::move(found));
}

void Sweep::add_arc(const Curve& /*curve*/, const State& state, std::uint32_t last) {
    output_.add_arc({state.type, state.label, {NodeId{state.node}, NodeId{last}}});
}

}  // namespace sightline::detail
