// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/assembly.hpp"

#include <algorithm>

namespace sightline::detail {
namespace {

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
}

void sort_unique(std::vector<std::uint32_t>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

Assembly::Assembly(Image& image, const Facings& facings, std::uint32_t cone_sides)
    : image_(image),
      facings_(facings),
      edge_count_(static_cast<std::uint32_t>(image.scene().edges.size())),
      sides_(cone_sides),
      order_(image),
      vertex_node_(image.point_count(), no_edge),
      own_(edge_count_ + cone_sides),
      passing_(edge_count_ + cone_sides) {}

std::array<std::uint32_t, 2> Assembly::ends(std::uint32_t edge) const {
    if (!is_side(edge)) {
        return {image_.scene().edges[edge].source, image_.scene().edges[edge].target};
    }
    const std::uint32_t side = edge - edge_count_;
    return {image_.vertex_count() + side, image_.vertex_count() + (side + 1) % sides_};
}

bool Assembly::collinear(std::uint32_t e, std::uint32_t f) {
    const auto [a, b] = ends(e);
    const auto [c, d] = ends(f);
    const SightPlane plane = image_.plane(a, b);
    return image_.side(plane, c) == Sign::zero && image_.side(plane, d) == Sign::zero;
}

std::uint32_t Assembly::root(std::uint32_t node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
}

void Assembly::join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
}

void Assembly::join_vertex(std::uint32_t point, std::uint32_t node) {
    if (vertex_node_[point] == no_edge) {
        vertex_node_[point] = node;
    } else {
        join(vertex_node_[point], node);
    }
}

void Assembly::join_pair(std::uint32_t e, std::uint32_t f, std::uint32_t node) {
    const auto [it, is_new] = pair_node_.emplace(key_of(e, f), node);
    if (!is_new) join(it->second, node);
}

// Features name a direction: a vertex does, and so do two edges that cross in the image.
void Assembly::name_place(std::uint32_t edge, const EdgePlace& place, std::uint32_t node) {
    const auto [u, w] = ends(edge);
    const bool at_end = std::any_of(place.points.begin(), place.points.end(),
                                    [u = u, w = w](std::uint32_t v) { return v == u || v == w; });
    Node& n = nodes_[node];
    n.points = place.points;
    n.edges = place.edges;
    if (!at_end) n.edges.push_back(edge);
    for (const std::uint32_t v : place.points) join_vertex(v, node);
    n.contacts = place.contacts;
    for (const auto& [e, f] : place.contacts) join_pair(e, f, node);
    if (!at_end) {
        for (const std::uint32_t f : place.edges) join_pair(edge, f, node);
    }
    const auto& crossing = place.edges;
    for (std::size_t i = 0; i < crossing.size(); ++i) {
        for (std::size_t j = i + 1; j < crossing.size(); ++j) {
            if (!collinear(crossing[i], crossing[j])) join_pair(crossing[i], crossing[j], node);
        }
        for (const std::uint32_t g : place.collinear) join_pair(crossing[i], g, node);
    }
    n.edges.insert(n.edges.end(), place.collinear.begin(), place.collinear.end());
}

void Assembly::add(std::uint32_t edge, const EdgeView& view) {
    auto& own = own_[edge];
    own.reserve(view.places.size());
    for (const EdgePlace& place : view.places) {
        const auto node = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        parent_.push_back(node);
        name_place(edge, place, node);
        EdgeEvent at = place.at;
        at.exact = no_edge;  // the table of exact values is another edge's by now
        own.push_back({at, node, place.piece_begins, place.piece_ends});
        for (const std::uint32_t front : place.fronts) {
            if (place.piece_begins || place.piece_ends) junctions_.push_back({front, edge, node});
        }
    }
    const auto [u, w] = ends(edge);
    for (const EdgePlace& place : view.in_question) {
        const auto& points = place.points;
        const bool at_u = std::find(points.begin(), points.end(), u) != points.end();
        questions_.push_back({at_u ? u : w, edge, place});
    }
}

// The sides of the cone are before everything, and seen from end to end.
void Assembly::add_sides() {
    for (std::uint32_t i = 0; i < sides_; ++i) {
        EdgeView view;
        const auto [a, b] = ends(edge_count_ + i);
        EdgePlace begin;
        begin.at = order_.source();
        begin.piece_begins = true;
        begin.points.push_back(a);
        EdgePlace end;
        end.at = order_.target();
        end.piece_ends = true;
        end.points.push_back(b);
        view.places = {begin, end};
        add(edge_count_ + i, view);
    }
}

// Vertices with hidden edges only are visible where the line of sight squeezes through to them.
void Assembly::ask_vertices() {
    std::vector<char> is_known(vertex_node_.size(), 0);
    for (const Question& q : questions_) {
        if (vertex_node_[q.vertex] != no_edge || is_known[q.vertex] != 0) continue;
        is_known[q.vertex] = 1;
        const Point3& p = image_.scene().point(q.vertex);
        Sight sight(image_, image_.exact(q.vertex), {p.x, p.y, p.z});
        if (!sight.is_free_until(image_.exact_weight(q.vertex))) continue;
        const auto node = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        parent_.push_back(node);
        name_place(q.edge, q.place, node);
    }
}

void Assembly::merge_nodes() {
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        const std::uint32_t r = root(i);
        if (r == i) continue;
        Node& into = nodes_[r];
        into.edges.insert(into.edges.end(), nodes_[i].edges.begin(), nodes_[i].edges.end());
        into.points.insert(into.points.end(), nodes_[i].points.begin(), nodes_[i].points.end());
        into.contacts.insert(into.contacts.end(), nodes_[i].contacts.begin(),
                             nodes_[i].contacts.end());
        nodes_[i] = {};
    }
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        if (root(i) != i) continue;
        sort_unique(nodes_[i].edges);
        sort_unique(nodes_[i].points);
        for (const std::uint32_t e : nodes_[i].edges) passing_[e].push_back(i);
    }
}

void Assembly::cut_edges() {
    for (std::uint32_t e = 0; e < own_.size(); ++e) {
        if (!own_[e].empty()) cut_edge(e);
    }
}

// All nodes on an edge, its own and those that others found on it, in order; arcs join neighbours in one piece.
void Assembly::cut_edge(std::uint32_t edge) {
    const auto [u, w] = ends(edge);
    const auto axis = image_.main_axis(image_.plane(u, w));
    SIGHTLINE_EXPECT(axis.has_value());
    order_.begin(u, w, *axis);
    std::vector<Own>& own = own_[edge];
    for (Own& place : own) place.node = root(place.node);
    const std::size_t known = own.size();
    for (const std::uint32_t node : passing_[edge]) {
        const bool is_known =
            std::any_of(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(known),
                        [&](const Own& place) { return place.node == node; });
        if (is_known) continue;
        Own place;
        place.node = node;
        bool found = false;
        if (!nodes_[node].points.empty()) {
            place.at = order_.vertex(nodes_[node].points.front());
            found = true;
        }
        for (const std::uint32_t f : nodes_[node].edges) {
            if (found) break;
            if (f == edge || collinear(edge, f)) continue;
            const auto [a, b] = ends(f);
            place.at = order_.crossing(a, b, f);
            found = true;
        }
        if (!found && !nodes_[node].contacts.empty()) {
            const auto& [g, h] = nodes_[node].contacts.front();
            place.at = contact_on(edge, *axis, g, h);
            found = true;
        }
        if (found) own.push_back(place);
    }
    for (std::size_t i = known; i < own.size(); ++i) {
        for (std::size_t j = i; j > 0; --j) {
            if (order_.compare(own[j].at, own[j - 1].at) != Sign::negative) break;
            std::swap(own[j], own[j - 1]);
        }
    }
    std::optional<std::size_t> last;
    std::uint32_t begin = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (own[i].begins) {
            begin = own[i].node;
        } else if (last && own[*last].node != own[i].node) {
            add_arc(edge, own[*last], own[i]);
        }
        if (own[i].ends) {
            if (!is_side(edge)) pieces_.push_back({edge, begin, own[i].node});
            last.reset();
        } else if (own[i].begins || last) {
            last = i;
        }
    }
}

EdgeEvent Assembly::contact_on(std::uint32_t edge, std::size_t axis, std::uint32_t g,
                               std::uint32_t h) {
    const auto minor = [axis](const Vector3& x, const Vector3& y) {
        const Vector3 n = cross(x, y);
        return axis == 0 ? n.x : axis == 1 ? n.y : n.z;
    };
    const auto [u, w] = ends(edge);
    const auto [a, b] = ends(g);
    const auto [c, d] = ends(h);
    // Up to one factor, the height of x over the line cd in the plane.
    const auto height = [&, c = c, d = d](std::uint32_t x) {
        return image_.exact_weight(c) * minor(image_.exact(d), image_.exact(x)) +
               image_.exact_weight(d) * minor(image_.exact(x), image_.exact(c)) +
               image_.exact_weight(x) * minor(image_.exact(c), image_.exact(d));
    };
    const Rational at_a = height(a);
    const Rational s = at_a / (at_a - height(b));
    const Vector3 r = image_.exact(a) + s * (image_.exact(b) - image_.exact(a));
    const Rational from_u = minor(image_.exact(u), r);
    return order_.fraction(from_u / (from_u + minor(r, image_.exact(w))));
}

void Assembly::add_arc(std::uint32_t edge, const Own& from, const Own& to) {
    const auto [it, is_new] =
        arc_of_.emplace(key_of(from.node, to.node), static_cast<std::uint32_t>(arcs_.size()));
    if (!is_new) {
        arcs_[it->second].edges.push_back(edge);
        return;
    }
    Arc arc;
    arc.edges.push_back(edge);
    arc.forward = true;
    arc.source = from.node;
    arc.target = to.node;
    arc.from = from.at;
    arc.to = to.at;
    arcs_.push_back(std::move(arc));
}

ViewMap3 Assembly::finish(std::optional<BodyId>& blocked_by) {
    add_sides();
    ask_vertices();
    merge_nodes();
    cut_edges();
    sort_round_nodes();
    trace_rings();
    for (Ring& ring : rings_) label_ring(ring);
    link_rings();
    return canonical(blocked_by);
}

}  // namespace sightline::detail
