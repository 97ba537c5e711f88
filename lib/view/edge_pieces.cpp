// SPDX-License-Identifier: GPL-3.0-or-later
// From what hides an edge to its visible pieces.
#include <algorithm>

#include "view/edge_sight.hpp"
#include "view/sight.hpp"

namespace sightline::detail {
namespace {

using Kind = EdgeEvent::Kind;

void add_once(std::vector<std::uint32_t>& list, std::uint32_t x) {
    if (std::find(list.begin(), list.end(), x) == list.end()) list.push_back(x);
}

}  // namespace

void EdgeSight::collect(EdgeView& out) {
    const PlacedScene& view = image_.scene();
    if (!in_plane_.empty() && (view.has_sheets || view.scene->has_touching_bodies())) {
        in_doubt_ = true;
    }
    // Through the body at whose boundary the viewpoint is, one could see what touches its other side.
    if (facings_.backs_hide && view.scene->has_touching_bodies()) in_doubt_ = true;
    if (in_doubt_) add_contact_corners();
    rank_events();
    cover();
    if (in_doubt_) doubt_gaps();
    list_places(out);
}

void EdgeSight::rank_events() {
    const auto n = static_cast<std::uint32_t>(events_.size());
    order_of_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) order_of_[i] = i;
    // Insertion sort: lists are short, and each comparison may be exact.
    for (std::uint32_t i = 1; i < n; ++i) {
        const std::uint32_t x = order_of_[i];
        std::uint32_t j = i;
        while (j > 0 && order_.compare(events_[x], events_[order_of_[j - 1]]) == Sign::negative) {
            order_of_[j] = order_of_[j - 1];
            --j;
        }
        order_of_[j] = x;
    }
    rank_.assign(n, 0);
    ranks_ = 1;
    for (std::uint32_t i = 1; i < n; ++i) {
        if (order_.compare(events_[order_of_[i - 1]], events_[order_of_[i]]) != Sign::zero) {
            ++ranks_;
        }
        rank_[order_of_[i]] = ranks_ - 1;
    }
}

// Which places and which gaps between them are hidden by faces.
void EdgeSight::cover() {
    gap_hidden_.assign(ranks_ == 0 ? 0 : ranks_ - 1, 0);
    place_hidden_.assign(ranks_, 0);
    for (const Hidden& h : hidden_) {
        const std::uint32_t from = h.from == Hidden::beyond ? 0 : rank_[h.from];
        const std::uint32_t to = h.to == Hidden::beyond ? ranks_ - 1 : rank_[h.to];
        for (std::uint32_t r = from; r < to; ++r) gap_hidden_[r] = 1;
        for (std::uint32_t r = from + 1; r < to; ++r) place_hidden_[r] = 1;
        if (h.from == Hidden::beyond || h.from_sealed) place_hidden_[from] = 1;
        if (h.to == Hidden::beyond || h.to_sealed) place_hidden_[to] = 1;
    }
}

bool EdgeSight::is_free_at(const Rational& t) {
    const Vector3& u = image_.exact(u_);
    const Vector3& w = image_.exact(w_);
    const Rational wu = image_.exact_weight(u_);
    const Rational ww = image_.exact_weight(w_);
    const Vector3 delta = u + t * (w - u);
    const double s = t.approx_double();
    const Point3& p = image_.scene().point(u_);
    const Point3& q = image_.scene().point(w_);
    Sight sight(image_, delta,
                {p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z)});
    return sight.is_free_until(wu + t * (ww - wu));
}

// Where sheets or contacts lie in the edge's sight plane, a part may be hidden that no face covers.
void EdgeSight::doubt_gaps() {
    std::vector<std::uint32_t> first(ranks_, no_edge);
    for (std::uint32_t i = 0; i < events_.size(); ++i) first[rank_[i]] = i;
    for (std::uint32_t r = 0; r + 1 < ranks_; ++r) {
        if (gap_hidden_[r] != 0) continue;
        const Rational from = order_.exact(events_[first[r]]);
        const Rational& to = order_.exact(events_[first[r + 1]]);
        if (!is_free_at((from + to) / 2)) gap_hidden_[r] = 1;
    }
}

// Corners of contacts that are no vertices: where sides of faces in the sight plane cross.
void EdgeSight::add_contact_corners() {
    const PlacedScene& view = image_.scene();
    std::vector<std::array<std::uint32_t, 3>> sides{{u_, w_, edge_}};
    for (const std::uint32_t i : in_plane_) {
        const PlacedTriangle& t = view.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
            if (t.edges[k] != no_edge && t.edges[k] != edge_) {
                sides.push_back({t.corners[k], t.corners[(k + 1) % 3], t.edges[k]});
            }
        }
    }
    std::sort(sides.begin(), sides.end(), [](const auto& x, const auto& y) { return x[2] < y[2]; });
    sides.erase(std::unique(sides.begin(), sides.end(),
                            [](const auto& x, const auto& y) { return x[2] == y[2]; }),
                sides.end());
    for (std::size_t i = 0; i < sides.size(); ++i) {
        for (std::size_t j = i + 1; j < sides.size(); ++j) {
            const auto& [a, b, ab] = sides[i];
            const auto& [c, d, cd] = sides[j];
            if (level(a, b, c) * level(a, b, d) != Sign::negative) continue;
            const Rational at_a = exact_level(c, d, a);
            const Rational at_b = exact_level(c, d, b);
            if (at_a.sign() * at_b.sign() != Sign::negative) continue;
            const Rational s = at_a / (at_a - at_b);
            const Vector3 r = image_.exact(a) + s * (image_.exact(b) - image_.exact(a));
            const auto minor = [&](const Vector3& x, const Vector3& y) {
                const Vector3 n = cross(x, y);
                return axis_ == 0 ? n.x : axis_ == 1 ? n.y : n.z;
            };
            const Rational from_u = minor(image_.exact(u_), r);
            const Rational to_w = minor(r, image_.exact(w_));
            if (from_u.sign() * axis_sign_ == Sign::negative) continue;
            if (to_w.sign() * axis_sign_ == Sign::negative) continue;
            const Rational whole = from_u + to_w;
            if (whole.sign() == Sign::zero) continue;
            EdgeEvent event = order_.fraction(from_u / whole);
            event.edge = ab;
            event.other = cd;
            add(event);
        }
    }
}

void EdgeSight::describe(std::uint32_t rank, EdgePlace& place) {
    const auto sides_from = static_cast<std::uint32_t>(image_.scene().edges.size());
    for (std::uint32_t i = 0; i < events_.size(); ++i) {
        if (rank_[i] != rank) continue;
        const EdgeEvent& event = events_[i];
        if (event.kind == Kind::source) place.points.push_back(u_);
        if (event.kind == Kind::target) place.points.push_back(w_);
        if (event.kind == Kind::vertex && event.is_named) add_once(place.points, event.a);
        if (event.kind == Kind::fraction && event.edge != no_edge) {
            place.contacts.emplace_back(std::min(event.edge, event.other),
                                        std::max(event.edge, event.other));
        }
        if (event.kind == Kind::edge && event.edge != no_edge && event.edge != edge_) {
            add_once(place.edges, event.edge);
            if (event.hides && event.edge < sides_from) add_once(place.fronts, event.edge);
        }
    }
    for (const Over& o : over_) {
        const bool from = o.from == Hidden::beyond || rank_[o.from] < rank;
        const bool to = o.to == Hidden::beyond || rank_[o.to] > rank;
        if (from && to) add_once(place.collinear, o.edge);
    }
}

void EdgeSight::list_places(EdgeView& out) {
    std::vector<std::uint32_t> first(ranks_, no_edge);
    for (std::uint32_t i = 0; i < events_.size(); ++i) {
        // An event that needs no arithmetic to be placed on other edges is the better name.
        if (first[rank_[i]] == no_edge || events_[i].kind == Kind::edge) first[rank_[i]] = i;
    }
    for (std::uint32_t r = 0; r < ranks_; ++r) {
        const bool open_before = r > 0 && gap_hidden_[r - 1] == 0;
        const bool open_behind = r + 1 < ranks_ && gap_hidden_[r] == 0;
        const bool is_end = r == 0 || r + 1 == ranks_;
        if (!open_before && !open_behind) {
            if (place_hidden_[r] != 0) continue;
            if (is_end) {
                out.in_question.emplace_back().at = events_[first[r]];
                describe(r, out.in_question.back());
                continue;
            }
            if (!is_free_at(order_.exact(events_[first[r]]))) continue;
        }
        EdgePlace place;
        place.at = events_[first[r]];
        describe(r, place);
        place.piece_begins = !open_before;
        place.piece_ends = !open_behind;
        const bool matters = is_end || place.piece_begins || place.piece_ends ||
                             !place.edges.empty() || !place.points.empty();
        if (matters) out.places.push_back(std::move(place));
    }
}

}  // namespace sightline::detail
