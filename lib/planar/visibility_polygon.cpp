// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/planar/visibility_polygon.hpp"

#include <array>
#include <optional>
#include <string>

#include "planar/needles.hpp"
#include "planar/view_sweep.hpp"

namespace sightline {
namespace detail {

// A triangulation ready for views: what PointVisibility2 keeps.
struct ViewScene {
    ViewScene(const Scene2& scene, std::span<const Point2> within)
        : triangulation(scene, within), crossings(triangulation), locator(triangulation) {}

    Triangulation triangulation;
    Crossings crossings;
    PointLocator locator;
};

namespace {

std::string text_of(const Viewpoint& v) {
    const RationalPoint2 p = v.exact != nullptr ? *v.exact : to_rational(v.position);
    return "(" + p.x.to_string() + ", " + p.y.to_string() + ")";
}

bool is_seeing(const Triangulation& t, const Location& at) {
    const HalfEdge h = at.half_edge;
    if (at.kind == Location::Kind::triangle) return t.is_free(h);
    if (at.kind == Location::Kind::edge) return t.is_free(h) || t.is_free(t.twin(h));
    HalfEdge k = h;
    do {
        if (t.is_free(k)) return true;
        k = t.rotate_ccw(k);
    } while (k != h);
    return false;
}

// The body around a solid triangle: the first body edge met by spreading from there.
BodyId body_around(const Scene2& scene, const Triangulation& t, HalfEdge start) {
    std::vector<std::uint8_t> seen(t.triangle_count(), 0);
    std::vector<HalfEdge> pending{start & ~3U};
    seen[start >> 2U] = 1;
    while (!pending.empty()) {
        const HalfEdge base = pending.back();
        pending.pop_back();
        for (HalfEdge h = base; h < base + 3; ++h) {
            const HalfEdge g = t.twin(h);
            if (g == no_index) return BodyId::none();
            if (t.is_constrained(h)) {
                const EdgeId e = t.scene_edge(g);
                if (!e.is_none() && scene[e].kind != EdgeKind2::wall) return scene[e].body;
            } else if (seen[g >> 2U] == 0) {
                seen[g >> 2U] = 1;
                pending.push_back(g & ~3U);
            }
        }
    }
    return BodyId::none();
}

tl::unexpected<Error> not_seeing(const Scene2& scene, const Triangulation& t, const Viewpoint& from,
                                 HalfEdge h) {
    const BodyId body = body_around(scene, t, h);
    if (body.is_none())
        return fail(Errc::outside_of_world,
                    "point " + text_of(from) +
                        " lies outside the world; choose a point inside its boundary");
    return fail(Errc::inside_body, "point " + text_of(from) + " lies inside body " +
                                       to_string(body) + "; choose a point outside the bodies");
}

}  // namespace
}  // namespace detail

using namespace detail;

struct PointVisibility2::Impl {
    explicit Impl(const Scene2& s) : scene(s), view(s, {}) {}

    Scene2 scene;
    ViewScene view;
};

namespace {

Result<void> look(const Scene2& scene, const ViewScene& view, const Viewpoint& from,
                  const VisibilityPolygonOptions& options, VisibilityPolygon& out) {
    const Triangulation& t = view.triangulation;
    const Location at = view.locator.locate(from, options.tally);
    if (!is_seeing(t, at)) return not_seeing(scene, t, from, at.half_edge);
    Viewpoint standing = from;
    if (at.kind == Location::Kind::place)
        standing = {t.position(t.origin(at.half_edge)), t.origin(at.half_edge)};
    ViewSweep sweep(t, view.crossings, options.arithmetic);
    sweep.run(standing, at, out.ring);
    out.needles.clear();
    if (options.needles == Needles::with_needles)
        out.needles = find_needles(scene, t, standing, at, out, sweep.followed());
    if (options.tally != nullptr) sweep.add_to(*options.tally);
    return {};
}

}  // namespace

PointVisibility2::PointVisibility2(const Scene2& scene)
    : impl_(std::make_unique<const Impl>(scene)) {}
PointVisibility2::~PointVisibility2() = default;
PointVisibility2::PointVisibility2(PointVisibility2&&) noexcept = default;
PointVisibility2& PointVisibility2::operator=(PointVisibility2&&) noexcept = default;

Result<void> PointVisibility2::from(const Point2& q, const VisibilityPolygonOptions& options,
                                    VisibilityPolygon& out) const {
    out.from = to_rational(q);
    if (impl_->view.triangulation.is_in_frame(q))
        return look(impl_->scene, impl_->view, {q}, options, out);
    const std::array<Point2, 1> within{q};
    return look(impl_->scene, ViewScene(impl_->scene, within), {q}, options, out);
}

Result<VisibilityPolygon> PointVisibility2::from(const Point2& q,
                                                 const VisibilityPolygonOptions& options) const {
    VisibilityPolygon out;
    if (Result<void> done = from(q, options, out); !done) return tl::unexpected(done.error());
    return out;
}

Result<VisibilityPolygon> PointVisibility2::from(const RationalPoint2& q,
                                                 const VisibilityPolygonOptions& options) const {
    const Point2 rounded = approx_point(q);
    if (to_rational(rounded) == q) return from(rounded, options);
    VisibilityPolygon out;
    out.from = q;
    const Viewpoint viewpoint{rounded, no_index, &q};
    Result<void> done;
    if (impl_->view.triangulation.is_in_frame(rounded)) {
        done = look(impl_->scene, impl_->view, viewpoint, options, out);
    } else {
        const std::array<Point2, 1> within{rounded};
        done = look(impl_->scene, ViewScene(impl_->scene, within), viewpoint, options, out);
    }
    if (!done) return tl::unexpected(done.error());
    return out;
}

Result<VisibilityPolygon> visibility_polygon(const Scene2& scene, const RationalPoint2& q,
                                             const VisibilityPolygonOptions& options) {
    return PointVisibility2(scene).from(q, options);
}

}  // namespace sightline
