// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/planar/visibility_polygon.hpp"

#include <array>

#include "planar/exact_points.hpp"
#include "planar/needles.hpp"
#include "planar/view_scene.hpp"
#include "planar/view_sweep.hpp"

namespace sightline {
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
    const Result<Standpoint> standing = stand_at(scene, view, from, options.tally);
    if (!standing) return tl::unexpected(standing.error());
    ViewSweep sweep(t, view.crossings, options.arithmetic);
    sweep.run(standing->viewpoint, standing->at, out.ring);
    out.needles.clear();
    if (options.needles == Needles::with_needles)
        out.needles =
            find_needles(scene, t, standing->viewpoint, standing->at, out, sweep.followed());
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
    if (auto fits = check_size(q); !fits) return fits;
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
    if (auto fits = check_size(rounded); !fits) return tl::unexpected(fits.error());
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

ExactPoints PointVisibility2::exact_points(const VisibilityPolygon& polygon) const {
    return detail::exact_points(impl_->scene, impl_->view.triangulation, polygon);
}

Result<VisibilityPolygon> visibility_polygon(const Scene2& scene, const RationalPoint2& q,
                                             const VisibilityPolygonOptions& options) {
    return PointVisibility2(scene).from(q, options);
}

}  // namespace sightline
