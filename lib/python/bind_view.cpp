// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bind.hpp"
#include "convert.hpp"
#include "sightline/planar/visibility_polygon.hpp"

namespace sightline::detail {
namespace {

struct PolygonResult {
    ScenePointer scene;
    VisibilityPolygon polygon;
    std::vector<ViewPoint> ring;
    Tally tally;
};

py::object to_python(const ViewPoint& point) {
    if (!point.at_infinity) return to_pair(point.coordinates);
    const py::object direction = py::module_::import("sightline._types").attr("Direction");
    return direction(to_fraction(point.coordinates.x), to_fraction(point.coordinates.y));
}

py::list ring_of(const PolygonResult& result) {
    py::list out;
    for (const ViewPoint& point : result.ring) out.append(to_python(point));
    return out;
}

py::list needles_of(const PolygonResult& result) {
    py::list out;
    for (const Needle& needle : result.polygon.needles) {
        const auto end = [&](const ViewVertex& v) {
            return to_python(exact_point(*result.scene, result.polygon.from, v));
        };
        out.append(py::make_tuple(end(needle.near), end(needle.far)));
    }
    return out;
}

py::array_t<double> approx_ring(const PolygonResult& result) {
    py::array_t<double> out({static_cast<py::ssize_t>(result.ring.size()), py::ssize_t{2}});
    double* next = out.mutable_data();
    for (const ViewPoint& point : result.ring) {
        const Point2 p = approx_point(point.coordinates);
        *next++ = p.x;
        *next++ = p.y;
    }
    return out;
}

py::array_t<bool> at_infinity(const PolygonResult& result) {
    py::array_t<bool> out(static_cast<py::ssize_t>(result.ring.size()));
    bool* next = out.mutable_data();
    for (const ViewPoint& point : result.ring) *next++ = point.at_infinity;
    return out;
}

VisibilityPolygonOptions view_options(bool needles, const std::string& arithmetic, Tally* tally) {
    return {.needles = needles ? Needles::with_needles : Needles::regularised,
            .arithmetic = arithmetic_from(arithmetic),
            .tally = tally};
}

// Fills the result by `compute(options)`, without the GIL.
template <typename Compute>
std::shared_ptr<PolygonResult> view(const ScenePointer& scene, bool needles,
                                    const std::string& arithmetic, Compute compute) {
    auto out = std::make_shared<PolygonResult>();
    out->scene = scene;
    const auto options = view_options(needles, arithmetic, &out->tally);
    auto polygon = [&] {
        const py::gil_scoped_release release;
        return compute(options);
    }();
    out->polygon = unwrap(std::move(polygon));
    const py::gil_scoped_release release;
    out->ring = exact_ring(*scene, out->polygon);
    return out;
}

std::shared_ptr<PolygonResult> view_of(const ScenePointer& scene, const py::object& from,
                                       bool needles, const std::string& arithmetic) {
    const RationalPoint2 q = to_point(from);
    return view(scene, needles, arithmetic,
                [&](const auto& options) { return visibility_polygon(*scene, q, options); });
}

// A prepared scene, and the scene that it was prepared from.
struct Views {
    ScenePointer scene;
    PointVisibility2 prepared;
};

std::shared_ptr<PolygonResult> view_from(const Views& views, const py::object& from, bool needles,
                                         const std::string& arithmetic) {
    const RationalPoint2 q = to_point(from);
    return view(views.scene, needles, arithmetic,
                [&](const auto& options) { return views.prepared.from(q, options); });
}

}  // namespace

void bind_view(py::module_& module) {
    py::class_<PolygonResult, std::shared_ptr<PolygonResult>>(
        module, "VisibilityPolygon", "What a point sees: counter-clockwise, weakly simple, exact.")
        .def_property_readonly(
            "from_point", [](const PolygonResult& r) { return to_pair(r.polygon.from); },
            "The viewpoint, as a pair of Fractions.")
        .def_property_readonly(
            "ring", &ring_of,
            "Vertices as (Fraction, Fraction), or Direction(x, y) for one at infinity, "
            "from the lexicographically least finite one on.")
        .def_property_readonly(
            "needles", &needles_of,
            "Visible segments without visible surroundings: pairs (near, far) of vertices.")
        .def_property_readonly("approx_ring", &approx_ring,
                               "(k, 2) float64, for drawing: the nearest doubles to `ring`.")
        .def_property_readonly("at_infinity", &at_infinity,
                               "(k,) bool: which rows of `approx_ring` are directions.")
        .def_property_readonly(
            "is_bounded",
            [](const PolygonResult& r) {
                return std::none_of(r.ring.begin(), r.ring.end(),
                                    [](const ViewPoint& p) { return p.at_infinity; });
            },
            "Whether no vertex is at infinity.")
        .def_property_readonly(
            "tally", [](const PolygonResult& r) { return to_dict(r.tally); },
            "Which arithmetic decided: {predicate: {tier: count}}.")
        .def("__len__", [](const PolygonResult& r) { return r.ring.size(); })
        .def(
            "__eq__",
            [](const PolygonResult& a, const PolygonResult& b) {
                return a.polygon.from == b.polygon.from && a.ring == b.ring;
            },
            py::is_operator())
        .def("__repr__", [](const PolygonResult& r) {
            return "<VisibilityPolygon: " + std::to_string(r.ring.size()) + " vertices>";
        });
    module.def("visibility_polygon", &view_of, py::arg("scene"), py::arg("point"), py::kw_only(),
               py::arg("needles") = false, py::arg("arithmetic") = "filtered",
               R"(What `point` sees, exactly.

point    a pair of numbers, taken exactly: float, int, Fraction, Decimal, or text ("0.1", "1/3")
needles  whether to keep visible segments without visible surroundings

Raises SightlineError with code "inside_body" or "outside_of_world".
For many points prepare the scene once: PointVisibility2.)");
    py::class_<Views, std::shared_ptr<Views>>(module, "PointVisibility2",
                                              "A scene prepared for many visibility polygons.")
        .def(py::init([](ScenePointer scene) {
                 const py::gil_scoped_release release;
                 PointVisibility2 prepared(*scene);
                 return std::make_shared<Views>(Views{std::move(scene), std::move(prepared)});
             }),
             py::arg("scene"))
        .def("from_point", &view_from, py::arg("point"), py::kw_only(), py::arg("needles") = false,
             py::arg("arithmetic") = "filtered", "What `point` sees; as visibility_polygon().")
        .def_property_readonly("scene", [](const Views& views) { return views.scene; });
}

}  // namespace sightline::detail
