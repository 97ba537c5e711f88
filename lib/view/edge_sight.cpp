// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/edge_sight.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::detail {
namespace {

bool is_positive(Sign s) { return s == Sign::positive; }
bool is_negative(Sign s) { return s == Sign::negative; }
bool is_zero(Sign s) { return s == Sign::zero; }

bool solid_hides(Sign a, Sign b, bool reflex) {
    return reflex ? is_negative(a) || is_negative(b) : is_negative(a) && is_negative(b);
}

// Whether a line of sight that meets the edge of a solid in one point comes from inside or goes there.
bool solid_seals(Sign a, Sign b, bool reflex) {
    if (reflex) return !is_zero(a) || !is_zero(b);
    return a == b && !is_zero(a);
}

}  // namespace

Facings::Facings(Image& image, bool viewpoint_on_boundary) : backs_hide(viewpoint_on_boundary) {
    const PlacedScene& view = image.scene();
    const Scene3& scene = *view.scene;
    face.reserve(scene.faces().size());
    for (const Face3& f : scene.faces()) {
        face.push_back(image.orientation(f.plane[0].value, f.plane[1].value, f.plane[2].value));
    }
    is_hidden.assign(view.edges.size(), 0);
    is_sealed.assign(view.edges.size(), 0);
    for (std::size_t i = 0; i < view.edges.size(); ++i) {
        bool left = false;
        bool right = false;
        for (const EdgeId id : view.ids(view.edges[i])) {
            const auto& faces = scene[id].faces;
            if (!view.edges[i].is_sheet) {
                const Sign a = face[faces[0].index()];
                const Sign b = face[faces[1].index()];
                const bool reflex = view.is_reflex[id.index()] != 0;
                if (solid_hides(a, b, reflex)) is_hidden[i] = 1;
                if (solid_seals(a, b, reflex)) is_sealed[i] = 1;
                continue;
            }
            for (std::size_t k = 0; k < 2; ++k) {
                if (faces[k].is_none()) continue;
                const Sign side = k == 0 ? face[faces[k].index()] : -face[faces[k].index()];
                left = left || is_positive(side);
                right = right || is_negative(side);
            }
        }
        if (left && right) is_sealed[i] = 1;
    }
}

void EdgeSight::look(std::uint32_t e, EdgeView& out) {
    out.places.clear();
    out.in_question.clear();
    if (facings_.is_hidden[e] != 0) return;
    edge_ = e;
    u_ = image_.scene().edges[e].source;
    w_ = image_.scene().edges[e].target;
    plane_ = image_.plane(u_, w_);
    const auto axis = image_.main_axis(plane_);
    if (!axis) return;
    axis_ = *axis;
    axis_sign_ = image_.minor(u_, w_, axis_);
    order_.begin(u_, w_, axis_);
    off_plane_ = no_edge;
    all_hidden_ = in_doubt_ = false;
    events_.clear();
    hidden_.clear();
    over_.clear();
    in_plane_.clear();
    events_.push_back(order_.source());
    events_.push_back(order_.target());
    meet_cone();
    if (all_hidden_) return;
    near_.clear();
    gather(near_);
    for (const std::uint32_t t : near_) {
        meet(t);
        if (all_hidden_) return;
    }
    collect(out);
}

// The triangle of the viewpoint and the edge (a half strip, from infinity) against boxes.
void EdgeSight::gather(std::vector<std::uint32_t>& out) const {
    const PlacedScene& view = image_.scene();
    const Point3 from = approx_point(image_.from().coordinates);
    const std::array<double, 3> f{from.x, from.y, from.z};
    const Point3& pu = view.point(u_);
    const Point3& pw = view.point(w_);
    const std::array<double, 3> u{pu.x, pu.y, pu.z};
    const std::array<double, 3> w{pw.x, pw.y, pw.z};
    using Vec = std::array<double, 3>;
    const auto minus = [](const Vec& a, const Vec& b) {
        return Vec{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    };
    const auto times = [](const Vec& a, const Vec& b) {
        return Vec{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const auto norm = [](const Vec& a) { return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]); };
    const bool far = image_.at_infinity();
    const Vec d = minus(w, u);
    const Vec a = far ? f : minus(u, f);
    const Vec b = far ? f : minus(w, f);
    const Vec n = far ? times(f, d) : times(a, b);
    struct Half {
        Vec normal;
        Vec base;
        double size;  // of the normal's terms
    };
    const double na = norm(a);
    const double nb = norm(b);
    const double nd = norm(d);
    const double nn = far ? na * nd : na * nb;
    std::array<Half, 3> halves{Half{times(n, d), u, nn * nd},
                               Half{times(n, a), far ? u : f, nn * na},
                               Half{times(b, n), far ? w : f, nn * nb}};
    double scale = norm(f) + norm(u) + norm(w);
    if (far) scale = norm(u) + norm(w);
    const auto outside = [&](const Box3& box, const Vec& normal, const Vec& base, double size,
                             bool both) {
        double at = 0;
        double half = 0;
        double reach = scale;
        for (std::size_t k = 0; k < 3; ++k) {
            const double m = (box.low[k] / 2 + box.high[k] / 2) - base[k];
            const double h = box.high[k] / 2 - box.low[k] / 2;
            at += normal[k] * m;
            half += std::abs(normal[k]) * h;
            reach += std::abs(m) + h;
        }
        // What underflows rejects nothing.
        const double margin = 0x1p-44 * size * reach + 0x1p-1000;
        return both ? std::abs(at) > half + margin : at + half < -margin;
    };
    Box3 bounds = Box3::of(pu, pw);
    if (!far) {
        bounds.include(from);
        for (std::size_t k = 0; k < 3; ++k) {
            // The viewpoint may have been rounded.
            bounds.low[k] -= 0x1p-50 * std::abs(f[k]);
            bounds.high[k] += 0x1p-50 * std::abs(f[k]);
        }
    }
    view.bvh.traverse(
        [&](const Box3& box) {
            if (!far && !box.meets(bounds)) return false;
            if (outside(box, n, u, nn, true)) return false;
            for (const Half& half : halves) {
                if (outside(box, half.normal, half.base, half.size, false)) return false;
            }
            return true;
        },
        [&](std::uint32_t t) { out.push_back(t); });
}

Sign EdgeSight::turn(std::uint32_t a, std::uint32_t b) const {
    return image_.minor(a, b, axis_) * axis_sign_;
}

std::uint32_t EdgeSight::add(const EdgeEvent& event) {
    events_.push_back(event);
    return static_cast<std::uint32_t>(events_.size() - 1);
}

// Sides of the cone hide what is outside of them, and are before everything.
void EdgeSight::meet_cone() {
    const std::uint32_t first = image_.vertex_count();
    for (std::uint32_t i = 0; i < cone_sides_; ++i) {
        const std::uint32_t a = first + i;
        const std::uint32_t b = first + (i + 1) % cone_sides_;
        const auto name = static_cast<std::uint32_t>(image_.scene().edges.size()) + i;
        const SightPlane side = image_.plane(a, b);
        const Sign at_u = image_.side(side, u_);
        const Sign at_w = image_.side(side, w_);
        if (is_positive(at_u) && is_positive(at_w)) continue;
        if (is_zero(at_u) && is_zero(at_w)) {
            over_.push_back({name, Hidden::beyond, Hidden::beyond});
            continue;
        }
        if (is_negative(at_u) && is_negative(at_w)) {
            all_hidden_ = true;
            return;
        }
        EdgeEvent event = order_.crossing(a, b, name);
        if (is_zero(at_u)) event.t = {0, 0};
        if (is_zero(at_w)) event.t = {1, 0};
        event.hides = true;
        const std::uint32_t at = add(event);
        if (is_negative(at_u)) hidden_.push_back({Hidden::beyond, at, false, false});
        if (is_negative(at_w)) hidden_.push_back({at, Hidden::beyond, false, false});
    }
}

void EdgeSight::meet(std::uint32_t triangle) {
    const PlacedTriangle& t = image_.scene().triangles[triangle];
    const Sign facing = facings_.face[t.face];
    const bool is_sheet = image_.scene().face_is_sheet[t.face] != 0;
    if (is_negative(facing) && !is_sheet && !facings_.backs_hide) return;
    std::array<Sign, 3> s{};
    bool left = false;
    bool right = false;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t c = t.corners[k];
        s[k] = c == u_ || c == w_ ? Sign::zero : image_.side(plane_, c);
        left = left || is_positive(s[k]);
        right = right || is_negative(s[k]);
        if (is_zero(s[k])) continue;
        if (off_plane_ == no_edge) off_plane_ = c;
    }
    const bool touches = is_zero(s[0]) || is_zero(s[1]) || is_zero(s[2]);
    if (!touches && !(left && right)) return;
    if (!left && !right) in_plane_.push_back(triangle);
    if (is_zero(facing)) {
        meet_edge_on(t, s);
    } else if (left && right) {
        meet_across(t, s);
    }
    if (!touches) return;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!is_zero(s[k])) continue;
        meet_vertex(t.corners[k]);
        if (is_zero(s[(k + 1) % 3])) meet_side(t, k);
    }
}

std::uint32_t EdgeSight::off_plane() {
    for (std::uint32_t v = 0; off_plane_ == no_edge && v < image_.vertex_count(); ++v) {
        if (!is_zero(image_.side(plane_, v))) off_plane_ = v;
    }
    return off_plane_;
}

// A face seen edge-on hides nothing, but its sides may cross the edge's image.
void EdgeSight::meet_edge_on(const PlacedTriangle& t, const std::array<Sign, 3>& s) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (s[k] * s[next] != Sign::negative || t.edges[k] == no_edge) continue;
        meet_crossing(t.corners[k], t.corners[next], t.edges[k], s[k]);
    }
}

// The segment ab crosses the edge's great circle; where it does before the edge, that is an event.
void EdgeSight::meet_crossing(std::uint32_t a, std::uint32_t b, std::uint32_t edge, Sign at_a) {
    const SightPlane plane = image_.plane(a, b);
    // From left to right, the segment has the edge's beginning on its right.
    const Sign at_u = u_ == a || u_ == b ? Sign::zero : image_.side(plane, u_) * at_a;
    const Sign at_w = w_ == a || w_ == b ? Sign::zero : image_.side(plane, w_) * at_a;
    if (is_positive(at_u) || is_negative(at_w) || (is_zero(at_u) && is_zero(at_w))) return;
    // b is on the viewpoint's side of the plane u, w, a when the segment passes before the edge.
    if (image_.height(u_, w_, a, b) * image_.orientation(u_, w_, a) == Sign::negative) return;
    EdgeEvent event = order_.crossing(a, b, edge);
    if (is_zero(at_u)) event.t = {0, 0};
    if (is_zero(at_w)) event.t = {1, 0};
    add(event);
}

EdgeSight::Cut EdgeSight::cut_at_side(const PlacedTriangle& t, std::size_t k, Sign facing) const {
    const std::uint32_t a = t.corners[k];
    const std::uint32_t b = t.corners[(k + 1) % 3];
    const SightPlane plane = image_.plane(a, b);
    Cut cut;
    cut.at_u = u_ == a || u_ == b ? Sign::zero : image_.side(plane, u_) * facing;
    cut.at_w = w_ == a || w_ == b ? Sign::zero : image_.side(plane, w_) * facing;
    cut.event = order_.crossing(a, b, t.edges[k]);
    cut.is_sealed = t.edges[k] == no_edge || facings_.is_sealed[t.edges[k]] != 0;
    return cut;
}

EdgeSight::Cut EdgeSight::cut_at_vertex(std::uint32_t a, bool entering) const {
    Cut cut;
    cut.at_u = entering ? turn(a, u_) : turn(u_, a);
    cut.at_w = entering ? turn(a, w_) : turn(w_, a);
    cut.event = order_.vertex(a);
    return cut;
}

bool EdgeSight::covers(const Cut& in, const Cut& out, Hidden& covered) {
    const bool u_inside = is_positive(in.at_u) && is_positive(out.at_u);
    const bool w_inside = is_positive(in.at_w) && is_positive(out.at_w);
    const auto add_cut = [&](const Cut& cut) {
        EdgeEvent event = cut.event;
        if (is_zero(cut.at_u)) event.t = {0, 0};
        if (is_zero(cut.at_w)) event.t = {1, 0};
        return add(event);
    };
    covered = {};
    if (!u_inside) {
        if (is_positive(in.at_u) && is_zero(out.at_u)) add_cut(out);
        if (is_positive(in.at_u) || !is_positive(in.at_w)) {
            if (is_zero(in.at_w) && is_positive(out.at_w)) add_cut(in);
            return false;
        }
        covered.from = add_cut(in);
        covered.from_sealed = in.is_sealed;
    }
    if (!w_inside) {
        if (!is_positive(out.at_u) || is_positive(out.at_w)) return false;
        covered.to = add_cut(out);
        covered.to_sealed = out.is_sealed;
    }
    return true;
}

template <typename Crossing>
EdgeSight::Depth EdgeSight::keep_behind(Sign height_u, Sign height_w, const Crossing& cross,
                                        Hidden& covered) {
    if (is_zero(height_u) && is_zero(height_w)) return Depth::level;
    if (!is_negative(height_u) && !is_negative(height_w)) return Depth::before;
    if (!is_positive(height_u) && !is_positive(height_w)) return Depth::behind;
    // The edge crosses the plane; mostly outside of what is covered, else the rest is before.
    EdgeEvent crossing = cross();
    const auto past_from = covered.from == Hidden::beyond
                               ? Sign::positive
                               : order_.compare(crossing, events_[covered.from]);
    const auto past_to = covered.to == Hidden::beyond
                             ? Sign::negative
                             : order_.compare(crossing, events_[covered.to]);
    if (!is_positive(past_from)) return is_negative(height_w) ? Depth::behind : Depth::before;
    if (!is_negative(past_to)) return is_negative(height_u) ? Depth::behind : Depth::before;
    const std::uint32_t at = add(crossing);
    if (is_negative(height_u)) {
        covered.to = at;
        covered.to_sealed = false;
    } else {
        covered.from = at;
        covered.from_sealed = false;
    }
    return Depth::behind;
}

Rational EdgeSight::exact_level(std::uint32_t p, std::uint32_t q, std::uint32_t x) {
    // The plane in two coordinates and the weight; there, the viewpoint is (0, 0, 1).
    const Rational det = image_.exact_weight(p) * image_.exact_minor(q, x, axis_) +
                         image_.exact_weight(q) * image_.exact_minor(x, p, axis_) +
                         image_.exact_weight(x) * image_.exact_minor(p, q, axis_);
    return is_negative(image_.minor(p, q, axis_)) ? -det : det;
}

Sign EdgeSight::level(std::uint32_t p, std::uint32_t q, std::uint32_t x) {
    if (x == p || x == q) return Sign::zero;
    const std::uint32_t off = off_plane();
    if (off == no_edge) return exact_level(p, q, x).sign();
    return image_.height(p, q, off, x) * image_.orientation(p, q, off);
}

// Triangles that have corners on both sides of the edge's great circle.
void EdgeSight::meet_across(const PlacedTriangle& t, const std::array<Sign, 3>& s) {
    const Sign facing = facings_.face[t.face];
    const Sign height_u = image_.height(t.corners[0], t.corners[1], t.corners[2], u_) * facing;
    const Sign height_w = image_.height(t.corners[0], t.corners[1], t.corners[2], w_) * facing;
    const bool touching = image_.scene().scene->has_touching_bodies();
    const bool before = !is_negative(height_u) && !is_negative(height_w);
    const bool level = is_zero(height_u) && is_zero(height_w);
    if (before && !touching) return;
    Cut in;
    Cut out;
    for (std::size_t k = 0; k < 3; ++k) {
        const Sign here = s[k] * facing;
        const Sign next = s[(k + 1) % 3] * facing;
        if (is_positive(here) && is_negative(next)) in = cut_at_side(t, k, facing);
        if (is_negative(here) && is_positive(next)) out = cut_at_side(t, k, facing);
        if (!is_zero(here)) continue;
        const bool entering = is_negative(next);
        (entering ? in : out) = cut_at_vertex(t.corners[k], entering);
    }
    const std::size_t known = events_.size();
    Hidden covered;
    const bool covers_some = covers(in, out, covered);
    const bool hides_level = level && facings_.backs_hide && is_negative(facing);
    if (before && !hides_level) {
        // Only what it touches in space is an event.
        events_.resize(known);
        if (!is_zero(height_u) && !is_zero(height_w)) return;
        for (std::size_t k = 0; k < 3; ++k) {
            if (s[k] * s[(k + 1) % 3] == Sign::negative && t.edges[k] != no_edge) {
                meet_crossing(t.corners[k], t.corners[(k + 1) % 3], t.edges[k], s[k]);
            }
        }
        return;
    }
    if (!covers_some) {
        // What was touched is an event when it is not behind the edge.
        const bool u_touched = events_.size() > known && events_.back().t.value == 0;
        if (events_.size() > known && is_positive(u_touched ? height_u : height_w)) {
            events_.resize(known);
        }
        return;
    }
    const auto crossing = [&] { return order_.plane(t.corners[0], t.corners[1], t.corners[2]); };
    if (!hides_level && keep_behind(height_u, height_w, crossing, covered) != Depth::behind) {
        events_.resize(known);
        if (!touching) return;
        for (std::size_t k = 0; k < 3; ++k) {
            if (s[k] * s[(k + 1) % 3] == Sign::negative && t.edges[k] != no_edge) {
                meet_crossing(t.corners[k], t.corners[(k + 1) % 3], t.edges[k], s[k]);
            }
        }
        return;
    }
    if (covered.from == Hidden::beyond && covered.to == Hidden::beyond) all_hidden_ = true;
    for (const std::uint32_t i : {covered.from, covered.to}) {
        if (i != Hidden::beyond) events_[i].hides = true;
    }
    hidden_.push_back(covered);
}

// A corner on the edge's great circle, if it is seen on the edge or before it.
void EdgeSight::meet_vertex(std::uint32_t a) {
    if (a == u_ || a == w_ || image_.is_here(a)) return;
    if (is_negative(turn(u_, a)) || is_negative(turn(a, w_))) return;
    if (is_negative(level(u_, w_, a))) return;
    EdgeEvent event = order_.vertex(a);
    event.is_named = true;
    if (is_zero(turn(u_, a))) event.t = {0, 0};
    if (is_zero(turn(a, w_))) event.t = {1, 0};
    add(event);
}

// A side on the edge's great circle.
void EdgeSight::meet_side(const PlacedTriangle& t, std::size_t k) {
    std::uint32_t a = t.corners[k];
    std::uint32_t b = t.corners[(k + 1) % 3];
    const std::uint32_t side = t.edges[k];
    const bool in_plane = is_zero(facings_.face[t.face]);
    if (side == edge_ || (side == no_edge && in_plane)) return;
    if (image_.is_here(a) || image_.is_here(b)) return;
    const Sign sense = turn(a, b);
    if (is_zero(sense)) return;
    if (is_negative(sense)) std::swap(a, b);
    const std::size_t known = events_.size();
    Hidden covered;
    if (!covers(cut_at_vertex(a, true), cut_at_vertex(b, false), covered)) {
        events_.resize(known);
        return;
    }
    const auto crossing = [&] {
        const Rational at_u = exact_level(a, b, u_);
        EdgeEvent event = order_.fraction(at_u / (at_u - exact_level(a, b, w_)));
        event.edge = side;
        event.other = edge_;
        return event;
    };
    const Depth depth = keep_behind(level(a, b, u_), level(a, b, w_), crossing, covered);
    if (depth == Depth::before) {
        events_.resize(known);
        return;
    }
    const bool sealed = side == no_edge || facings_.is_sealed[side] != 0;
    if (sealed && depth == Depth::behind) {
        if (covered.from == Hidden::beyond && covered.to == Hidden::beyond) all_hidden_ = true;
        hidden_.push_back(covered);
        return;
    }
    if (side == no_edge) return;
    over_.push_back({side, covered.from, covered.to});
    const PlacedScene& view = image_.scene();
    if (depth == Depth::behind && (view.has_sheets || view.scene->has_touching_bodies())) {
        in_doubt_ = true;
    }
}

}  // namespace sightline::detail
