// SPDX-License-Identifier: GPL-3.0-or-later
// From arcs to regions.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "view/assembly.hpp"

namespace sightline::detail {
namespace {

using Kind = ViewRegion::Kind;

std::uint64_t next_random(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

void unite(std::vector<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) {
    a = find_root(parent, a);
    b = find_root(parent, b);
    parent[std::max(a, b)] = std::min(a, b);
}

}  // namespace

void Assembly::sort_round_nodes() {
    round_.assign(nodes_.size(), {});
    for (std::uint32_t i = 0; i < arcs_.size(); ++i) {
        round_[arcs_[i].source].push_back({i, false});
        round_[arcs_[i].target].push_back({i, true});
    }
    // A half arc's plane has its normal on the left of the way, and its tip ahead.
    const auto way = [&](const ViewHalfArc& h) {
        const Arc& arc = arcs_[h.arc];
        auto [u, w] = ends(arc.edges.front());
        if (h.reversed) std::swap(u, w);
        return std::pair{u, w};
    };
    for (auto& leaving : round_) {
        if (leaving.size() < 3) continue;
        const auto [u, w] = way(leaving.front());
        const SightPlane first = image_.plane(u, w);
        // 0: ahead, 1: left, 2: back, 3: right of the first half arc.
        std::vector<std::pair<int, ViewHalfArc>> sorted;
        sorted.emplace_back(0, leaving.front());
        for (std::size_t i = 1; i < leaving.size(); ++i) {
            const Sign s = image_.side(first, way(leaving[i]).second);
            sorted.emplace_back(s == Sign::positive ? 1 : s == Sign::zero ? 2 : 3, leaving[i]);
        }
        std::sort(sorted.begin() + 1, sorted.end(), [&](const auto& a, const auto& b) {
            if (a.first != b.first) return a.first < b.first;
            const auto [c, d] = way(a.second);
            return image_.side(image_.plane(c, d), way(b.second).second) == Sign::positive;
        });
        for (std::size_t i = 0; i < sorted.size(); ++i) leaving[i] = sorted[i].second;
    }
}

void Assembly::trace_rings() {
    std::vector<std::uint32_t> place(arcs_.size() * 2);  // of a half arc round its node
    for (const auto& leaving : round_) {
        for (std::uint32_t i = 0; i < leaving.size(); ++i) {
            place[leaving[i].arc * 2 + (leaving[i].reversed ? 1U : 0U)] = i;
        }
    }
    std::vector<char> is_done(arcs_.size() * 2, 0);
    for (std::uint32_t start = 0; start < arcs_.size() * 2; ++start) {
        if (is_done[start] != 0) continue;
        Ring ring;
        const auto name = static_cast<std::uint32_t>(rings_.size());
        std::uint32_t at = start;
        while (is_done[at] == 0) {
            is_done[at] = 1;
            const bool reversed = (at & 1U) != 0;
            Arc& arc = arcs_[at / 2];
            ring.arcs.push_back({at / 2, reversed});
            arc.ring[reversed ? 1 : 0] = name;
            // The next one clockwise from the way back has the same region on its left.
            const auto& leaving = round_[reversed ? arc.source : arc.target];
            const std::size_t n = leaving.size();
            const ViewHalfArc& next = leaving[(place[at ^ 1U] + n - 1) % n];
            at = next.arc * 2 + (next.reversed ? 1U : 0U);
        }
        rings_.push_back(std::move(ring));
    }
}

// The face that begins on the left of an edge (of its source→target, or the other way), where that is certain.
std::optional<SightEnd> Assembly::known_left(std::uint32_t edge, bool forward) const {
    if (is_side(edge)) {
        // Sides run counter-clockwise: the cone is on their left.
        if (forward) return std::nullopt;
        return SightEnd{Kind::outside, {}, {}};
    }
    const PlacedScene& view = image_.scene();
    const Scene3& scene = *view.scene;
    // What covers the face next to a visible edge has an edge there too, or is a sheet that lies on it.
    if (scene.has_touching_bodies() && view.has_sheets) return std::nullopt;
    if (facings_.backs_hide) return std::nullopt;
    std::optional<FaceSide> found;
    for (const EdgeId id : view.ids(view.edges[edge])) {
        for (std::size_t k = 0; k < 2; ++k) {
            const FaceId f = scene[id].faces[k];
            if (f.is_none()) continue;
            const Sign facing = facings_.face[f.index()];
            if (facing == Sign::zero) continue;
            const bool is_sheet = view.face_is_sheet[f.index()] != 0;
            if (facing == Sign::negative && !is_sheet) continue;
            const bool on_left = (k == 0) == (facing == Sign::positive);
            if (on_left != forward) continue;
            const FaceSide side{f, facing == Sign::negative};
            if (found && *found != side) return std::nullopt;
            found = side;
        }
    }
    if (!found) return std::nullopt;
    return SightEnd{Kind::face, {*found}, {}};
}

SightEnd Assembly::look_left(const Arc& arc, bool reversed) {
    const std::uint32_t edge = arc.edges.front();
    const auto [u, w] = ends(edge);
    const auto axis = image_.main_axis(image_.plane(u, w));
    order_.begin(u, w, *axis);
    EdgeEvent from = arc.from;
    EdgeEvent to = arc.to;
    from.exact = to.exact = no_edge;
    const double middle = from.t.value / 2 + to.t.value / 2;
    Rational t(std::isfinite(middle) ? middle : 0.5);
    if (!(middle > from.t.value + from.t.error && middle < to.t.value - to.t.error)) {
        const Rational a = order_.exact(from);
        t = (a + order_.exact(to)) / 2;
    }
    const Vector3& a = image_.exact(u);
    const Vector3& b = image_.exact(w);
    Vector3 aside = cross(b, a);
    if (reversed) aside = -aside;
    const double s = t.approx_double();
    std::array<double, 3> near{};
    if (!is_side(edge)) {
        const Point3& p = image_.scene().point(u);
        const Point3& q = image_.scene().point(w);
        near = {p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z)};
    } else {
        const Point3 p = image_.corner(u);
        const Point3 q = image_.corner(w);
        near = {p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z)};
    }
    Sight sight(image_, a + t * (b - a), near);
    return sight.look(aside, b);
}

void Assembly::label_ring(Ring& ring) {
    for (const ViewHalfArc& h : ring.arcs) {
        const Arc& arc = arcs_[h.arc];
        // A side of the cone that is met from outside says enough, whatever else is there.
        for (const std::uint32_t e : arc.edges) {
            if (!is_side(e)) continue;
            const bool same = e == arc.edges.front() || !collinear_against(e, arc.edges.front());
            if (same == h.reversed) {
                ring.end = SightEnd{Kind::outside, {}, {}};
                return;
            }
        }
    }
    for (const ViewHalfArc& h : ring.arcs) {
        const Arc& arc = arcs_[h.arc];
        if (arc.edges.size() != 1) continue;
        if (auto end = known_left(arc.edges.front(), !h.reversed)) {
            ring.end = std::move(*end);
            return;
        }
    }
    const ViewHalfArc& h = ring.arcs.front();
    ring.end = look_left(arcs_[h.arc], h.reversed);
}

// Whether two edges on one great circle run in opposite senses.
bool Assembly::collinear_against(std::uint32_t e, std::uint32_t f) {
    const auto [a, b] = ends(e);
    const auto [c, d] = ends(f);
    const auto axis = image_.main_axis(image_.plane(a, b));
    return image_.minor(a, b, *axis) * image_.minor(c, d, *axis) == Sign::negative;
}

// A direction near the middle of an arc, of length about 1.
std::array<double, 3> Assembly::middle(const Arc& arc) {
    const auto [u, w] = ends(arc.edges.front());
    const auto parameter = [&, u = u, w = w](EdgeEvent event) {
        if (event.t.error < 0x1p-30) return event.t.value;
        order_.begin(u, w, *image_.main_axis(image_.plane(u, w)));
        event.exact = no_edge;
        return order_.exact(event).approx_double();
    };
    const double t = parameter(arc.from) / 2 + parameter(arc.to) / 2;
    std::array<double, 3> r{};
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        r[k] = (1 - t) * image_.rounded(u)[k] + t * image_.rounded(w)[k];
        size = std::max(size, std::abs(r[k]));
    }
    for (double& x : r) x /= size;
    return r;
}

Vector3 Assembly::exact_middle(const Arc& arc) {
    const auto [u, w] = ends(arc.edges.front());
    order_.begin(u, w, *image_.main_axis(image_.plane(u, w)));
    EdgeEvent from = arc.from;
    EdgeEvent to = arc.to;
    from.exact = to.exact = no_edge;
    const Rational first = order_.exact(from);
    const Rational t = (first + order_.exact(to)) / 2;
    return image_.exact(u) + t * (image_.exact(w) - image_.exact(u));
}

// Joins the rings of one region: those that follow each other on a way from each component of the map to one
// that has been linked before. As components and regions form a tree, that is enough.
void Assembly::link_rings() {
    ring_parent_.resize(rings_.size());
    std::iota(ring_parent_.begin(), ring_parent_.end(), 0U);
    std::vector<std::uint32_t> component(nodes_.size());
    std::iota(component.begin(), component.end(), 0U);
    for (const Arc& arc : arcs_) unite(component, arc.source, arc.target);
    std::vector<std::vector<std::uint32_t>> arcs_of(nodes_.size());
    std::vector<std::array<double, 3>> middles;
    for (std::uint32_t i = 0; i < arcs_.size(); ++i) {
        arcs_of[find_root(component, arcs_[i].source)].push_back(i);
        middles.push_back(middle(arcs_[i]));
    }
    std::vector<std::uint32_t> linked;
    std::uint64_t seed = 1;
    for (const auto& arcs : arcs_of) {
        if (arcs.empty()) continue;
        // Rounded: any arc will do, a near one is quick.
        const auto& m = middles[arcs.front()];
        const auto distance = [&](std::uint32_t i) {
            const auto& x = middles[i];
            return std::abs(x[0] - m[0]) + std::abs(x[1] - m[1]) + std::abs(x[2] - m[2]);
        };
        const auto nearest = std::min_element(
            linked.begin(), linked.end(),
            [&](std::uint32_t i, std::uint32_t j) { return distance(i) < distance(j); });
        if (nearest != linked.end()) walk(arcs.front(), *nearest, seed);
        linked.insert(linked.end(), arcs.begin(), arcs.end());
    }
}

// A way from the middle of one arc to that of another, a little prolonged, over a third point (so that arcs on
// one great circle can be joined); in doubles taken as exact. What it crosses follows each other round regions.
// When it is not in general position to all arcs, another way is tried.
void Assembly::walk(std::uint32_t from_arc, std::uint32_t to_arc, std::uint64_t& seed) {
    const auto exactly = [](const std::array<double, 3>& r) {
        return Vector3{Rational(r[0]), Rational(r[1]), Rational(r[2])};
    };
    const auto random = [&] { return Rational(static_cast<int>(next_random(seed) % 2001) - 1000); };
    // A multiple of v about as long as w.
    const auto matched = [](const Vector3& v, const Vector3& w) {
        const auto norm = [](const Vector3& x) { return abs(x.x) + abs(x.y) + abs(x.z); };
        return (norm(w) / norm(v)) * v;
    };
    const auto near = middle(arcs_[from_arc]);
    const auto far = middle(arcs_[to_arc]);
    const double distance =
        std::abs(near[0] - far[0]) + std::abs(near[1] - far[1]) + std::abs(near[2] - far[2]);
    const Vector3 near_exact = exactly(near);
    const Vector3 far_exact = exactly(far);
    for (int attempt = 0; attempt < 1000; ++attempt) {
        // Directions that doubles hardly tell apart need exact ones.
        const bool rounded = attempt < 8;
        const Arithmetic arithmetic = image_.arithmetic();
        if (!rounded && arithmetic != Arithmetic::filtered && arithmetic != Arithmetic::exact)
            return;
        const Vector3 a = rounded ? near_exact : exact_middle(arcs_[from_arc]);
        const Vector3 b = rounded ? far_exact : matched(exact_middle(arcs_[to_arc]), a);
        const Vector3 d = b - a;
        const Rational apart = rounded ? Rational(std::max(distance, 0x1p-20))
                                       : std::max({abs(d.x), abs(d.y), abs(d.z)});
        const Rational scale = Rational(0x1p-13 * (1 + attempt % 32)) * apart;
        const Vector3 over = a + b + Vector3{scale * random(), scale * random(), scale * random()};
        const Rational prolong(0x1p-10 * static_cast<double>(1 + next_random(seed) % 64));
        std::vector<Crossing> crossings;
        if (!cross_arcs(a - prolong * (over - a), over, crossings)) continue;
        if (!std::any_of(crossings.begin(), crossings.end(),
                         [&](const Crossing& c) { return c.arc == from_arc; })) {
            continue;
        }
        const std::size_t half = crossings.size();
        if (!cross_arcs(over, b + prolong * (b - over), crossings)) continue;
        if (!std::any_of(crossings.begin() + static_cast<std::ptrdiff_t>(half), crossings.end(),
                         [&](const Crossing& c) { return c.arc == to_arc; })) {
            continue;
        }
        for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            // What is ahead of the way lies on one side of an arc that it meets from the other.
            const Crossing& x = crossings[i];
            const Crossing& y = crossings[i + 1];
            unite(ring_parent_, arcs_[x.arc].ring[x.leaves_left ? 1 : 0],
                  arcs_[y.arc].ring[y.leaves_left ? 0 : 1]);
        }
        return;
    }
    SIGHTLINE_EXPECT(false);
}

// Appends the arcs that the way from a to b crosses, in order; false when it meets a node or crosses two arcs at once.
bool Assembly::cross_arcs(const Vector3& a, const Vector3& b, std::vector<Crossing>& crossings) {
    const Vector3 normal = cross(a, b);
    if (normal.is_zero()) return false;
    const auto first = static_cast<std::ptrdiff_t>(crossings.size());
    const std::array<double, 3> n{normal.x.approx_double(), normal.y.approx_double(),
                                  normal.z.approx_double()};
    const auto rounded_side = [&](std::uint32_t x) {
        const auto& r = image_.rounded(x);
        const auto& s = image_.size(x);
        const double value = n[0] * r[0] + n[1] * r[1] + n[2] * r[2];
        const double error =
            0x1p-48 * (std::abs(n[0]) * s[0] + std::abs(n[1]) * s[1] + std::abs(n[2]) * s[2]) +
            0x1p-1000;
        return value > error ? 1 : value < -error ? -1 : 0;
    };
    // Linear forms that are not negative on the way; where both ends of an edge are certainly off it, the edge is.
    const auto times = [](const std::array<double, 3>& x, const std::array<double, 3>& y) {
        return std::array<double, 3>{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2],
                                     x[0] * y[1] - x[1] * y[0]};
    };
    const auto rounded = [](const Vector3& v) {
        return std::array<double, 3>{v.x.approx_double(), v.y.approx_double(), v.z.approx_double()};
    };
    const auto norm = [](const std::array<double, 3>& v) {
        return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
    };
    const auto from_form = times(n, rounded(a));
    const auto to_form = times(rounded(b), n);
    const double form_error = 0x1p-40 * norm(n) * std::max(norm(rounded(a)), norm(rounded(b)));
    const auto is_off = [&](const std::array<double, 3>& form, std::uint32_t x) {
        const auto& r = image_.rounded(x);
        return form[0] * r[0] + form[1] * r[1] + form[2] * r[2] <
               -form_error * norm(image_.size(x)) - 0x1p-1000;
    };
    for (std::uint32_t i = 0; i < arcs_.size(); ++i) {
        const Arc& arc = arcs_[i];
        const auto [u, w] = ends(arc.edges.front());
        // The whole edge lies on one side of the way: most do.
        const int side_u = rounded_side(u);
        if (side_u != 0 && side_u == rounded_side(w)) continue;
        if (is_off(from_form, u) && is_off(from_form, w)) continue;
        if (is_off(to_form, u) && is_off(to_form, w)) continue;
        const Rational at_u = dot(normal, image_.exact(u));
        const Rational at_w = dot(normal, image_.exact(w));
        const auto on_way = [&](const Vector3& c) {
            return dot(normal, cross(a, c)).sign() != Sign::negative &&
                   dot(normal, cross(c, b)).sign() != Sign::negative;
        };
        if (at_u.sign() == Sign::zero && at_w.sign() == Sign::zero) return false;
        if (at_u.sign() * at_w.sign() == Sign::positive) continue;
        // Where the edge crosses the way's great circle, and whether that is on the arc and on the way.
        const Rational t = at_u / (at_u - at_w);
        const auto axis = image_.main_axis(image_.plane(u, w));
        order_.begin(u, w, *axis);
        EdgeEvent here = order_.fraction(t);
        EdgeEvent from = arc.from;
        EdgeEvent to = arc.to;
        from.exact = to.exact = no_edge;
        const Sign after = order_.compare(here, from);
        const Sign before = order_.compare(here, to);
        if (after == Sign::negative || before == Sign::positive) continue;
        const Vector3 c = image_.exact(u) + t * (image_.exact(w) - image_.exact(u));
        if (after == Sign::zero || before == Sign::zero) {
            // A node, but it may be behind the viewpoint.
            if (on_way(c)) return false;
            continue;
        }
        // c = x a + y b up to a factor: turns from a and to b.
        const Rational from_a = dot(normal, cross(a, c));
        const Rational to_b = dot(normal, cross(c, b));
        if (from_a.sign() != Sign::positive || to_b.sign() != Sign::positive) continue;
        // The normal's positive side is on the right of the way.
        crossings.push_back({from_a / (from_a + to_b), i, at_u.sign() == Sign::positive});
    }
    std::sort(crossings.begin() + first, crossings.end(),
              [](const Crossing& x, const Crossing& y) { return x.at < y.at; });
    return std::adjacent_find(crossings.begin() + first, crossings.end(),
                              [](const Crossing& x, const Crossing& y) { return x.at == y.at; }) ==
           crossings.end();
}

SightEnd Assembly::look_anywhere() {
    const Vector3 c = vector_to(image_.from().coordinates);
    const Point3 p = approx_point(image_.from().coordinates);
    if (image_.at_infinity()) return {};
    Sight sight(image_, {1, 0, 0}, {p.x + std::max(1.0, std::abs(p.x)), p.y, p.z});
    return sight.look({0, 1, 0}, {0, 0, 1});
}

std::vector<EdgeId> Assembly::ids_of(const std::vector<std::uint32_t>& edges) const {
    std::vector<EdgeId> ids;
    for (const std::uint32_t e : edges) {
        if (is_side(e)) continue;
        const auto of_edge = image_.scene().ids(image_.scene().edges[e]);
        ids.insert(ids.end(), of_edge.begin(), of_edge.end());
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

void Assembly::name_nodes(ViewMap3& map, std::vector<std::uint32_t>& rank) const {
    std::vector<std::pair<ViewNode, std::uint32_t>> named;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        const Node& node = nodes_[i];
        if (parent_[i] != i) continue;
        ViewNode name;
        for (const std::uint32_t v : node.points) {
            if (v < image_.vertex_count()) {
                name.vertices.push_back(VertexId{v});
            } else {
                const std::uint32_t corner = v - image_.vertex_count();
                name.sides.push_back(corner);
                name.sides.push_back((corner + sides_ - 1) % sides_);
            }
        }
        for (const std::uint32_t e : node.edges) {
            if (is_side(e)) name.sides.push_back(e - edge_count_);
        }
        std::sort(name.sides.begin(), name.sides.end());
        name.sides.erase(std::unique(name.sides.begin(), name.sides.end()), name.sides.end());
        name.edges = ids_of(node.edges);
        named.emplace_back(std::move(name), i);
    }
    std::sort(named.begin(), named.end());
    rank.assign(nodes_.size(), no_edge);
    for (std::uint32_t i = 0; i < named.size(); ++i) {
        rank[named[i].second] = i;
        map.nodes.push_back(std::move(named[i].first));
    }
}

ViewMap3 Assembly::canonical(std::optional<BodyId>& blocked_by) {
    ViewMap3 map;
    std::vector<std::uint32_t> node_rank;
    name_nodes(map, node_rank);
    struct Named {
        ViewArc arc;
        std::uint32_t old;
        bool turned;
    };
    std::vector<Named> arcs;
    for (std::uint32_t i = 0; i < arcs_.size(); ++i) {
        Named named;
        named.old = i;
        named.arc.edges = ids_of(arcs_[i].edges);
        for (const std::uint32_t e : arcs_[i].edges) {
            if (is_side(e)) named.arc.side = e - edge_count_;
        }
        named.arc.source = node_rank[arcs_[i].source];
        named.arc.target = node_rank[arcs_[i].target];
        named.turned = named.arc.source > named.arc.target;
        if (named.turned) std::swap(named.arc.source, named.arc.target);
        arcs.push_back(std::move(named));
    }
    std::sort(arcs.begin(), arcs.end(), [](const Named& a, const Named& b) {
        return std::tie(a.arc.source, a.arc.target, a.arc.edges) <
               std::tie(b.arc.source, b.arc.target, b.arc.edges);
    });
    std::vector<std::uint32_t> arc_rank(arcs_.size());
    std::vector<char> turned(arcs_.size());
    for (std::uint32_t i = 0; i < arcs.size(); ++i) {
        arc_rank[arcs[i].old] = i;
        turned[arcs[i].old] = static_cast<char>(arcs[i].turned);
    }
    std::vector<std::pair<ViewRegion, std::uint32_t>> regions;
    std::vector<std::uint32_t> region_of(rings_.size(), no_edge);
    for (std::uint32_t i = 0; i < rings_.size(); ++i) {
        const std::uint32_t r = find_root(ring_parent_, i);
        if (region_of[r] == no_edge) {
            region_of[r] = static_cast<std::uint32_t>(regions.size());
            regions.push_back({{rings_[r].end.kind, rings_[r].end.faces, {}}, r});
        }
        region_of[i] = region_of[r];
        std::vector<ViewHalfArc> ring;
        for (const ViewHalfArc& h : rings_[i].arcs) {
            ring.push_back({arc_rank[h.arc], h.reversed != (turned[h.arc] != 0)});
        }
        std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
        regions[region_of[i]].first.rings.push_back(std::move(ring));
    }
    if (rings_.empty()) {
        const SightEnd end = look_anywhere();
        regions.push_back({{end.kind, end.faces, {}}, 0});
        if (end.kind == Kind::blocked) blocked_by = end.body;
    }
    if (!rings_.empty() && std::all_of(rings_.begin(), rings_.end(), [](const Ring& r) {
            return r.end.kind == Kind::blocked || r.end.kind == Kind::outside;
        })) {
        for (const Ring& r : rings_) {
            if (r.end.kind == Kind::blocked) blocked_by = r.end.body;
        }
    }
    for (auto& [region, old] : regions) std::sort(region.rings.begin(), region.rings.end());
    std::vector<std::uint32_t> order(regions.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return regions[a].first < regions[b].first;
    });
    std::vector<std::uint32_t> region_rank(regions.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        region_rank[order[i]] = i;
        map.regions.push_back(std::move(regions[order[i]].first));
    }
    for (Named& named : arcs) {
        const Arc& old = arcs_[named.old];
        named.arc.left = region_rank[region_of[old.ring[named.turned ? 1 : 0]]];
        named.arc.right = region_rank[region_of[old.ring[named.turned ? 0 : 1]]];
        map.arcs.push_back(std::move(named.arc));
    }
    const PlacedScene& view = image_.scene();
    for (const Junction& j : junctions_) {
        for (const EdgeId front : view.ids(view.edges[j.front])) {
            for (const EdgeId back : view.ids(view.edges[j.back])) {
                map.t_junctions.push_back({front, back, node_rank[root(j.node)]});
            }
        }
    }
    for (const Piece& p : pieces_) {
        for (const EdgeId id : view.ids(view.edges[p.edge])) {
            map.pieces.push_back({id, node_rank[p.from], node_rank[p.to]});
        }
    }
    const auto sort_unique = [](auto& list) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    };
    sort_unique(map.t_junctions);
    sort_unique(map.pieces);
    return map;
}

}  // namespace sightline::detail
