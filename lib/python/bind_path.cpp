// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>

#include "bind.hpp"
#include "convert.hpp"
#include "sightline/planar/shortest_path.hpp"

namespace sightline::detail {
namespace {

struct PathResult {
    ShortestPath path;
    Tally tally;
};

std::shared_ptr<PathResult> path_of(const ScenePointer& scene, const py::object& from,
                                    const py::object& to, const std::string& arithmetic,
                                    unsigned threads) {
    auto out = std::make_shared<PathResult>();
    const RationalPoint2 a = to_point(from);
    const RationalPoint2 b = to_point(to);
    const ShortestPathOptions options{
        .arithmetic = arithmetic_from(arithmetic), .threads = threads, .tally = &out->tally};
    auto path = [&] {
        const py::gil_scoped_release release;
        return shortest_path(*scene, a, b, options);
    }();
    out->path = unwrap(std::move(path));
    return out;
}

py::array_t<double> approx_points(const PathResult& result) {
    py::array_t<double> out({static_cast<py::ssize_t>(result.path.points.size()), py::ssize_t{2}});
    double* next = out.mutable_data();
    for (const RationalPoint2& point : result.path.points) {
        const Point2 p = approx_point(point);
        *next++ = p.x;
        *next++ = p.y;
    }
    return out;
}

}  // namespace

void bind_path(py::module_& module) {
    py::class_<PathResult, std::shared_ptr<PathResult>>(module, "ShortestPath",
                                                        "A shortest free path between two points.")
        .def_property_readonly(
            "points",
            [](const PathResult& r) {
                py::list out;
                for (const RationalPoint2& p : r.path.points) out.append(to_pair(p));
                return out;
            },
            "(Fraction, Fraction) of both ends and the vertices between.")
        .def_property_readonly(
            "vertices", [](const PathResult& r) { return to_array(r.path.vertices); },
            "Numbers of the scene vertices between the ends.")
        .def_property_readonly(
            "length",
            [](const PathResult& r) {
                return py::make_tuple(r.path.length.lower, r.path.length.upper);
            },
            "(lower, upper): the true length lies between, both included.")
        .def_property_readonly("approx_length",
                               [](const PathResult& r) { return r.path.length.approx_middle(); })
        .def_property_readonly("approx_points", &approx_points, "(k, 2) float64, for drawing.")
        .def_property_readonly(
            "tally", [](const PathResult& r) { return to_dict(r.tally); },
            "Which arithmetic decided: {predicate: {tier: count}}.")
        .def("__repr__", [](const PathResult& r) {
            return "<ShortestPath: " + std::to_string(r.path.vertices.size()) +
                   " turns, length about " + std::to_string(r.path.length.approx_middle()) + ">";
        });
    module.def(
        "shortest_path", &path_of, py::arg("scene"), py::arg("start"), py::arg("end"),
        py::kw_only(), py::arg("arithmetic") = "filtered", py::arg("threads") = 1,
        R"(A shortest free path between two points, given as exact numbers (see visibility_polygon).

Raises SightlineError with code "inside_body", "outside_of_world" or "unreachable".)");
}

}  // namespace sightline::detail
