// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/sweep.hpp"

#include <algorithm>

#include "skeleton/root_order.hpp"

namespace sightline::detail {

Sweep::Sweep(const SceneForms& forms, const Policy& policy, SweepOutput output)
    : forms_(forms), policy_(policy), output_(std::move(output)), cut_(forms) {}

void Sweep::run(const Curve& curve) {
    for (const Interval& interval : intervals(curve)) {
        rank_ = 0;
        do {
            has_more_ = false;
            blocked_.clear();
            explore(curve, interval, 0);
            if (rank_ == 0) find_lonely_nodes(curve);
            ++rank_;
        } while (has_more_);
    }
    rank_ = 0;
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
    struct Cut {
        Parameter t;
        VertexId vertex;
    };
    std::vector<Cut> cuts{{Parameter::dyadic(0), {}}, {Parameter::dyadic(1), {}}};
    if (curve.kind() != CurveKind::border_pencil) {
        const Edge3& base = forms_.scene()[curve.base()];
        cuts[0].vertex = base.source;
        cuts[1].vertex = base.target;
    }
    const auto interval = [](const Cut& a, const Cut& b) -> Interval {
        return {a.t, b.t, {EdgeId::none(), a.vertex, 0, {}}, {EdgeId::none(), b.vertex, 0, {}}};
    };
    if (curve.kind() != CurveKind::regulus && curve.kind() != CurveKind::plane_pencil) {
        return {interval(cuts[0], cuts[1])};
    }
    const std::size_t count = curve.kind() == CurveKind::regulus ? 3 : 2;
    for (std::size_t i = 1; i < count; ++i) {
        const EdgeId e = curve.edges()[i];
        for (const VertexId v : {forms_.scene()[e].source, forms_.scene()[e].target}) {
            const auto form = curve.vertex_form(v, e);
            if (!form) continue;
            for (Parameter& t : roots(curve, *form, curve.evaluate<Real>(*form))) {
                if (compare(policy_, t, cuts[0].t) != Sign::positive) continue;
                if (compare(policy_, t, cuts[1].t) != Sign::negative) continue;
                cuts.push_back({std::move(t), v});
            }
        }
    }
    const auto is_before = [&](const Cut& a, const Cut& b) {
        return compare(policy_, a.t, b.t) == Sign::negative;
    };
    // Insertion sort: plain doubles may order inconsistently.
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        for (std::size_t j = i; j > 0 && is_before(cuts[j], cuts[j - 1]); --j) {
            std::swap(cuts[j], cuts[j - 1]);
        }
    }
    std::vector<Interval> result;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        if (!is_before(cuts[i], cuts[i + 1])) continue;
        if (meets_generators(curve, between(cuts[i].t, cuts[i + 1].t))) {
            result.push_back(interval(cuts[i], cuts[i + 1]));
        }
    }
    return result;
}

void Sweep::explore(const Curve& curve, const Interval& interval, unsigned depth) {
    // A sample may happen to be an event: then another one is taken.
    for (unsigned attempt = 0; attempt < 64; ++attempt) {
        const Parameter t = between(interval.first, interval.last, depth + attempt);
        const State state = look(curve, t);
        auto found = reach_of(curve, interval, t, state);
        if (!found) continue;
        Reach& reach = *found;
        if (state.is_arc) follow_arc(curve, interval, t, state, reach);
        if (reach.left_is_event) {
            explore(curve, {interval.first, reach.left, interval.first_event, reach.left_event},
                    depth + 1);
        }
        if (!state.is_arc) blocked_.push_back(reach);
        if (reach.right_is_event) {
            explore(curve, {reach.right, interval.last, reach.right_event, interval.last_event},
                    depth + 1);
        }
        return;
    }
}

std::optional<Reach> Sweep::reach_of(const Curve& curve, const Interval& interval,
                                     const Parameter& t, const State& state) const {
    if (state.is_event) return std::nullopt;
    if (!state.is_free) {
        bool hit = false;
        Reach reach = blocked_reach(curve, interval, t, state, hit);
        return hit ? std::nullopt : std::optional(std::move(reach));
    }
    ReachSearch search(curve, interval, t);
    search_free(search, curve, state, {});
    return search.hit_sample() ? std::nullopt : std::optional(search.reach());
}

/// What touches no generator may make a free line one of a family in a contact's plane.
void Sweep::search_free(ReachSearch& search, const Curve& curve, const State& state,
                        std::span<const EventName> dismissed) const {
    if (curve.contact().is_none()) {
        search.search_segment(state.stopping, dismissed);
    } else {
        search.search_all(dismissed);
    }
}

Reach Sweep::blocked_reach(const Curve& curve, const Interval& interval, const Parameter& t,
                           const State& state, bool& hit) const {
    ReachSearch search(curve, interval, t);
    if (rank_ > 0) {
        search.search_all({});
    } else if (!state.blocker.is_none()) {
        search.search_edges(forms_.edges_of(state.blocker));
    } else if (!curve.contact().is_none()) {
        search.search_all({});
    } else if (!state.seal.empty()) {
        for (const FaceId f : state.seal) search.search_edges(forms_.edges_of(f));
    } else if (!state.blocker_body.is_none()) {
        search.search_edges(forms_.edges_of(state.blocker_body));
    } else {
        search.search_all({});  // sheets that join
    }
    hit = search.hit_sample();
    return search.reach();
}

/// Records the arc through t. Events that do not touch the segment after all are dismissed, and the
/// search goes on behind them.
void Sweep::follow_arc(const Curve& curve, const Interval& interval, const Parameter& t,
                       const State& state, Reach& reach) {
    std::vector<EventName> dismissed;
    while (true) {
        const auto left =
            node_at(curve, reach.left, reach.left_event, reach.left_is_event ? &state : nullptr);
        const auto right =
            node_at(curve, reach.right, reach.right_event, reach.right_is_event ? &state : nullptr);
        if (left && right) {
            add_arcs(curve, state, reach, *left, *right);
            return;
        }
        if (!left && reach.left_is_event) dismissed.push_back(reach.left_event);
        if (!right && reach.right_is_event) dismissed.push_back(reach.right_event);
        if ((!left && !reach.left_is_event) || (!right && !reach.right_is_event)) return;
        ReachSearch search(curve, interval, t);
        search_free(search, curve, state, dismissed);
        reach = search.reach();
    }
}

void Sweep::add_arcs(const Curve& curve, const State& state, const Reach& reach, std::uint32_t left,
                     std::uint32_t right) {
    std::uint32_t begin = left;
    const auto add = [&](std::uint32_t end) {
        output_.add_arc({state.type, state.label, {NodeId{begin}, NodeId{end}}});
        begin = end;
    };
    if (curve.kind() == CurveKind::vertex_pencil || curve.kind() == CurveKind::contact_pencil) {
        for (const std::uint32_t node : dividing_nodes(curve, state, reach)) add(node);
    }
    add(right);
}

/// The edges that end at a pencil's point or contain it.
std::vector<EdgeId> Sweep::edges_round(const Curve& curve) const {
    std::vector<EdgeId> edges;
    const auto add = [&](EdgeId e) {
        if (std::ranges::find(edges, e) == edges.end()) edges.push_back(e);
    };
    if (curve.kind() == CurveKind::contact_pencil) {
        const EdgeId first = curve.edges()[1];
        add(first);
        add(curve.edges()[2]);
        const auto point = crossing<Integer>(forms_, first, curve.edges()[2]);
        for (const EdgeId e : forms_.crossing_edges(first)) {
            const auto other = crossing<Integer>(forms_, first, e);
            if (point.second * other.first == other.second * point.first) add(e);
        }
        return edges;
    }
    std::vector<VertexId> vertices{curve.vertex()};
    for (const VertexId v : forms_.vertices_at(forms_.place(curve.vertex()))) {
        vertices.push_back(v);
    }
    for (const VertexId v : vertices) {
        for (const EdgeId e : forms_.scene().edges_at(v)) add(e);
        for (const EdgeId e : forms_.edges_through(v)) add(e);
    }
    return edges;
}

std::vector<std::uint32_t> Sweep::dividing_nodes(const Curve& curve, const State& state,
                                                 const Reach& reach) {
    struct Candidate {
        Parameter t;
        EdgeId a, b;
    };
    std::vector<Candidate> candidates;
    const std::vector<EdgeId> edges = edges_round(curve);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const EventForm form{EventForm::Kind::edge_plane, edges[i].value, edges[j].value,
                                 VertexId::none(), 0};
            const Quadratic<Real> q = curve.evaluate<Real>(form);
            if (curve.vanishes(q, form)) continue;
            for (Parameter& t : roots(curve, form, q)) {
                if (compare(policy_, reach.left, t) != Sign::negative) continue;
                if (compare(policy_, t, reach.right) != Sign::negative) continue;
                candidates.push_back({std::move(t), edges[i], edges[j]});
            }
        }
    }
    std::ranges::stable_sort(candidates, [&](const Candidate& x, const Candidate& y) {
        return compare(policy_, x.t, y.t) == Sign::negative;
    });
    std::vector<std::uint32_t> nodes;
    const Parameter* last = nullptr;
    for (const Candidate& c : candidates) {
        if (last != nullptr && compare(policy_, *last, c.t) == Sign::zero) continue;
        for (const EdgeId e : state.label.support.edges) {
            if (e == c.a || e == c.b) continue;
            const auto end = planar_end(curve, {c.a, c.b, e});
            if (!end) continue;
            nodes.push_back(*end);
            last = &c.t;
            break;
        }
    }
    return nodes;
}

/// The node in which an arc of lines in the plane of two edges round the curve's point, that meet a third edge,
/// ends at that point.
std::optional<std::uint32_t> Sweep::planar_end(const Curve& curve, std::array<EdgeId, 3> edges) {
    const auto crossed = Curve::through_edges(forms_, policy_, edges);
    if (crossed && crossed->kind() == CurveKind::plane_pencil && crossed->edges()[2] == edges[2]) {
        if (const auto end = planar_end(curve, *crossed)) return end;
    }
    for (const auto& plane : forms_.contact_planes()) {
        const auto is_in_plane = [&](EdgeId e) {
            return std::ranges::binary_search(plane.edges, e);
        };
        if (!is_in_plane(edges[0]) || !is_in_plane(edges[1])) continue;
        for (const EdgeId base : {edges[0], edges[1]}) {
            const auto pressed = Curve::in_face(forms_, policy_, plane.faces[0], base, edges[2]);
            if (!pressed) continue;
            if (const auto end = planar_end(curve, *pressed)) return end;
        }
    }
    return std::nullopt;
}

std::optional<std::uint32_t> Sweep::planar_end(const Curve& curve, const Curve& planar) {
    const auto form = curve.kind() == CurveKind::contact_pencil
                          ? planar.crossing_form(curve.edges()[1], curve.edges()[2])
                          : planar.vertex_form(curve.vertex(), planar.base());
    if (!form) return std::nullopt;
    for (const Parameter& t : roots(planar, *form, planar.evaluate<Real>(*form))) {
        for (const Interval& interval : intervals(planar)) {
            const Sign after_first = compare(policy_, t, interval.first);
            const Sign before_last = compare(policy_, interval.last, t);
            if (after_first == Sign::negative || before_last == Sign::negative) continue;
            const bool ends = (after_first == Sign::positive &&
                               is_arc_next_to(planar, {interval.first, t, {}, {}}, false)) ||
                              (before_last == Sign::positive &&
                               is_arc_next_to(planar, {t, interval.last, {}, {}}, true));
            if (ends) return node_at(planar, t, {}, nullptr);
        }
    }
    return std::nullopt;
}

/// Whether the lines of an interval that are nearer to one of its ends than any event make an arc.
bool Sweep::is_arc_next_to(const Curve& curve, Interval interval, bool at_left) {
    for (unsigned attempt = 0; attempt < 64; ++attempt) {
        const Parameter t = between(interval.first, interval.last, attempt);
        const State state = look(curve, t);
        const auto reach = reach_of(curve, interval, t, state);
        if (!reach) continue;
        if (!(at_left ? reach->left_is_event : reach->right_is_event)) return state.is_arc;
        (at_left ? interval.last : interval.first) = at_left ? reach->left : reach->right;
    }
    return false;
}

/// Between two blocked neighbours a single line may be free, where both stays end at once.
void Sweep::find_lonely_nodes(const Curve& curve) {
    for (std::size_t i = 1; i < blocked_.size(); ++i) {
        const Reach& left = blocked_[i - 1];
        const Reach& right = blocked_[i];
        if (!left.right_is_event || !right.left_is_event) continue;
        if (compare(policy_, left.right, right.left) != Sign::zero) continue;
        (void)node_at(curve, left.right, left.right_event, nullptr);
    }
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
    if (curve.has_vertex() && !curve.vertex().is_none() &&
        !include(cut_.place_of(curve.vertex()))) {
        return std::nullopt;
    }
    for (const EdgeId e : curve.edges()) {
        if (!include(cut_.place_of(e))) return std::nullopt;
    }
    if (first == last && curve.kind() != CurveKind::border_pencil) return std::nullopt;
    return std::pair{first, last};
}

/// The cut line's run that touches the generators; of a border pencil, the run that ends there, if it is not at
/// the pencil's limit.
std::optional<Run> Sweep::run_of(const Curve& curve, bool at_limit) {
    const auto places = generator_places(curve);
    if (!places) return std::nullopt;
    if (curve.kind() != CurveKind::border_pencil || at_limit) {
        std::vector<Run> through;
        for (const Run& run : cut_.runs()) {
            if (run.contains(places->first) && run.contains(places->second)) through.push_back(run);
        }
        has_more_ = has_more_ || through.size() > rank_ + 1;
        if (through.empty() || (rank_ >= through.size() && !at_limit)) return std::nullopt;
        return through[std::min<std::size_t>(rank_, through.size() - 1)];
    }
    for (const Run& run : cut_.runs()) {
        if (run.first == places->first || run.last == places->first) return run;
    }
    return std::nullopt;
}

/// Whether all lines of a pencil are parallel to a face.
bool Sweep::keeps_to_plane(const Curve& curve, FaceId f) const {
    const auto keeps = [&](std::size_t i) {
        const auto of = [&]<typename N>(const N&) {
            return dot(forms_.plane<N>(f).n, curve.coefficients<N>()[i].d);
        };
        return policy_.sign(Predicate::line_form3, of(Real{}),
                            [&] { return sign_of_integer(of(Integer{})); }) == Sign::zero;
    };
    return curve.degree() == 1 && keeps(0) && keeps(1);
}

/// Whether the contact behind the run is in the plane that the curve needs.
bool Sweep::is_pressed(const Curve& curve, const std::vector<FaceId>& contact) const {
    return curve.contact().is_none() || std::ranges::any_of(contact, [&](FaceId f) {
               return f == curve.contact() || forms_.are_coplanar(f, curve.contact());
           });
}

Sweep::State Sweep::look(const Curve& curve, const Parameter& t) {
    State state;
    const CurvePoint point(curve, t);
    const Line line(point.real_line(), point, policy_);
    KnownFeatures known;
    const VertexId vertex = curve.vertex();
    if (curve.has_vertex() && !vertex.is_none()) known.vertices = {&vertex, 1};
    known.edges = curve.edges();
    known.is_general = curve.kind() != CurveKind::contact_pencil;
    known.only_their_segment = true;
    cut_.cut(line, known);
    if (!cut_.blocking_face().is_none()) {
        state.blocker = cut_.blocking_face();
        return state;
    }
    const auto run = run_of(curve, false);
    if (!run) {
        const auto places = generator_places(curve);
        if (!places) return state;
        state.blocker = cut_.face_between(places->first, places->second);
        state.blocker_body = cut_.blocker_between(places->first, places->second);
        state.seal = cut_.seal_between(places->first, places->second);
        return state;
    }
    state.is_free = true;
    state.label = cut_.label(*run);
    state.parts = cell_parts(forms_, cut_, *run);
    state.is_arc = is_pressed(curve, state.parts.contact);
    state.is_event = !std::ranges::all_of(state.parts.contact,
                                          [&](FaceId f) { return keeps_to_plane(curve, f); });
    state.type = arc_type(curve, cut_, *run, state.label);
    state.stopping = cut_.stopping_faces(*run);
    return state;
}

std::optional<std::uint32_t> Sweep::node_at(const Curve& curve, const Parameter& t,
                                            const EventName& at, const State* unless) {
    const CurvePoint point(curve, t);
    const Line line(point.real_line(), point, policy_);
    KnownFeatures known;
    const VertexId vertex = curve.vertex();
    if (curve.has_vertex() && !vertex.is_none()) known.vertices = {&vertex, 1};
    known.edges = curve.edges();
    known.only_their_segment = true;
    known.also_edge = at.edge;
    known.also_vertex = at.vertex;
    cut_.cut(line, known);
    if (!cut_.blocking_face().is_none()) return std::nullopt;
    const auto run = run_of(curve, true);
    if (!run) return std::nullopt;
    SegmentLabel label = cut_.label(*run);
    if (unless != nullptr && label == unless->label &&
        cell_parts(forms_, cut_, *run) == unless->parts) {
        return std::nullopt;
    }
    SkeletonNode node = describe_node(forms_, cut_, *run, line, std::move(label));
    node.root = root_of(curve, t, line, node);
    const auto [number, is_new] = output_.add_node(std::move(node));
    if (is_new && output_.add_swath) leave_node(line, *run);
    return number;
}

/// Whether the line lies in the plane of two edges that it meets at one point.
bool Sweep::lies_in_plane(const Line& line, EdgeId a, EdgeId b) const {
    return line.sign(Predicate::line_form3, [&]<typename N>(const PluckerOf<N>& l) {
        return dot(cross(forms_.line<N>(a.index()).d, forms_.line<N>(b.index()).d), l.d);
    }) == Sign::zero;
}

/// Reports every three edges that lines near a node's may meet in different points. Two edges that end
/// in one point are met near it, in different points, only by lines in their plane.
void Sweep::leave_node(const Line& line, const Run& run) {
    find_near_edges(forms_, cut_, run, near_);
    const auto go_together = [&](const NearEdge& a, const NearEdge& b) {
        return a.edge != b.edge && (a.place != b.place || lies_in_plane(line, a.edge, b.edge));
    };
    for (std::size_t i = 0; i < near_.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (!go_together(near_[i], near_[j])) continue;
            for (std::size_t k = 0; k < j; ++k) {
                if (near_[i].place == near_[j].place && near_[j].place == near_[k].place) continue;
                if (!go_together(near_[i], near_[k]) || !go_together(near_[j], near_[k])) continue;
                std::array edges{near_[i].edge, near_[j].edge, near_[k].edge};
                std::ranges::sort(edges);
                output_.add_swath(edges);
            }
        }
    }
}

}  // namespace sightline::detail
