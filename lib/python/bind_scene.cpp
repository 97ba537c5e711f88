// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bind.hpp"
#include "convert.hpp"
#include "sightline/scene/doom.hpp"
#include "sightline/scene/geojson.hpp"
#include "sightline/scene/scene2.hpp"
#include "sightline/scene/scene_io.hpp"
#include "sightline/scene/text_format.hpp"
#include "sightline/scene/wkt.hpp"

namespace sightline::detail {

namespace {

// --- scenes from arrays
// ---------------------------------------------------------------------------

// Anything that numpy reads as an (n, 2) array of doubles.
std::vector<Point2> points_from(const py::handle& object, const char* what) {
    using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
    const auto array = Array::ensure(object);
    if (!array) {
        PyErr_Clear();
        throw py::type_error(std::string(what) + " has to be an (n, 2) array of numbers");
    }
    if (array.size() == 0) return {};
    if (array.ndim() != 2 || array.shape(1) != 2) {
        throw py::value_error(std::string(what) + " has to be an (n, 2) array of numbers");
    }
    const auto rows = array.unchecked<2>();
    std::vector<Point2> out(static_cast<std::size_t>(rows.shape(0)));
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) out[i] = {rows(i, 0), rows(i, 1)};
    return out;
}

// As in files, a ring may repeat its first vertex at its end.
Ring2 ring_from(const py::handle& object) {
    Ring2 ring = points_from(object, "a ring");
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

Polygon2 polygon_from(const py::handle& outer, const py::iterable& holes) {
    Polygon2 polygon{ring_from(outer), {}};
    for (const py::handle hole : holes) polygon.holes.push_back(ring_from(hole));
    return polygon;
}

ScenePointer scene_from(const py::iterable& polygons, const py::iterable& walls,
                        const py::object& points, bool world, bool mend) {
    SceneInput2 input;
    input.world = world;
    for (const py::handle polygon : polygons) {
        input.elements.emplace_back(py::isinstance<Polygon2>(polygon)
                                        ? polygon.cast<Polygon2>()
                                        : Polygon2{ring_from(polygon), {}});
    }
    for (const py::handle wall : walls) {
        input.elements.emplace_back(Polyline2{points_from(wall, "a wall")});
    }
    for (const Point2& point : points_from(points, "points")) input.elements.emplace_back(point);
    return scene_made_from(input, mend);
}

ScenePointer with_points(const Scene2& scene, const py::object& points) {
    return std::make_shared<Scene2>(unwrap(scene.with_points(points_from(points, "points"))));
}

// --- scenes from text and files
// -------------------------------------------------------------------

Result<SceneInput2> input_from(std::string_view text, SceneFormat2 format,
                               const ReadOptions& options) {
    switch (format) {
        case SceneFormat2::wkt:
            return read_wkt(text, options);
        case SceneFormat2::geojson:
            return read_geojson(text, options);
        case SceneFormat2::text:
            break;
    }
    return read_text(text, options);
}

template <SceneFormat2 format>
ScenePointer from_string(const std::string& text, bool world, bool mend) {
    auto input = [&] {
        const py::gil_scoped_release release;
        return input_from(text, format, {.world = world});
    }();
    return scene_made_from(unwrap(std::move(input)), mend);
}

template <SceneFormat2 format>
std::string text_of(const Scene2& scene) {
    std::ostringstream out;
    write_input(out, to_input(scene), format);
    return std::move(out).str();
}

ScenePointer scene_at(const py::object& path, bool world, bool mend) {
    const auto name = py::cast<std::string>(py::module_::import("os").attr("fspath")(path));
    auto input = [&] {
        const py::gil_scoped_release release;
        return read_input(name, {.world = world});
    }();
    return scene_made_from(unwrap(std::move(input)), mend);
}

ScenePointer doom_map_at(const py::object& path, const std::string& map, bool all_lines) {
    const auto name = py::cast<std::string>(py::module_::import("os").attr("fspath")(path));
    return scene_made_from(unwrap(read_doom(name, map, {.all_lines = all_lines})));
}

// --- what a scene consists of
// ---------------------------------------------------------------------

template <typename Keep>
py::array_t<std::uint32_t> edge_array(const Scene2& scene, Keep keep) {
    const auto count = std::count_if(scene.edges().begin(), scene.edges().end(), keep);
    py::array_t<std::uint32_t> out({static_cast<py::ssize_t>(count), py::ssize_t{2}});
    std::uint32_t* next = out.mutable_data();
    for (const Edge2& edge : scene.edges()) {
        if (!keep(edge)) continue;
        *next++ = edge.source.value;
        *next++ = edge.target.value;
    }
    return out;
}

py::list rings_of(const Scene2& scene) {
    const py::object ring_type = py::module_::import("sightline._types").attr("Ring");
    py::list out;
    for (const RingRange2& ring : scene.rings()) {
        std::vector<VertexId> vertices;
        for (const Edge2& edge : scene.edges().subspan(ring.first.index(), ring.count)) {
            vertices.push_back(edge.source);
        }
        const py::object body =
            ring.body.is_none() ? py::none() : py::object(py::int_(ring.body.value));
        out.append(ring_type(to_array(vertices), body, ring.is_hole));
    }
    return out;
}

std::string described(const Scene2& scene) {
    return "<Scene2: " + std::to_string(scene.vertex_count()) + " vertices, " +
           std::to_string(scene.body_count()) + " bodies" +
           (scene.has_world() ? ", a world>" : ">");
}

void bind_readers(py::class_<Scene2, ScenePointer>& scene) {
    scene
        .def_static("read", &scene_at, py::arg("path"), py::kw_only(), py::arg("world") = false,
                    py::arg("repair") = false,
                    "The scene in a file: WKT, GeoJSON or our own text, as its name or its first "
                    "characters tell.")
        .def_static("from_wkt", &from_string<SceneFormat2::wkt>, py::arg("text"), py::kw_only(),
                    py::arg("world") = false, py::arg("repair") = false,
                    "The scene that well-known text describes.")
        .def_static("from_geojson", &from_string<SceneFormat2::geojson>, py::arg("text"),
                    py::kw_only(), py::arg("world") = false, py::arg("repair") = false,
                    "The scene that GeoJSON describes.")
        .def_static("from_text", &from_string<SceneFormat2::text>, py::arg("text"), py::kw_only(),
                    py::arg("world") = false, py::arg("repair") = false,
                    "The scene that our own text describes.")
        .def_static("read_doom", &doom_map_at, py::arg("path"), py::arg("map"), py::kw_only(),
                    py::arg("all_lines") = false,
                    "The walls of a map in a WAD file; with all_lines also those with a floor on "
                    "both sides.")
        .def("to_wkt", &text_of<SceneFormat2::wkt>,
             "Well-known text; a reader has to be told whether there is a world.")
        .def("to_geojson", &text_of<SceneFormat2::geojson>, "GeoJSON.")
        .def("to_text", &text_of<SceneFormat2::text>, "Our own text, one ring or wall a line.")
        // Our own text says whether there is a world, so it is a complete account of a scene.
        .def(py::pickle(&text_of<SceneFormat2::text>, [](const std::string& text) {
            return from_string<SceneFormat2::text>(text, false, false);
        }));
}

void bind_parts(py::class_<Scene2, ScenePointer>& scene) {
    scene
        .def_property_readonly(
            "vertices",
            [](const py::object& self) {
                static_assert(sizeof(Point2) == 2 * sizeof(double));
                const auto vertices = self.cast<const Scene2&>().vertices();
                return view_of_pairs<double>(vertices.data(), vertices.size(), self);
            },
            "(n, 2) float64; shares memory, read-only.")
        .def_property_readonly(
            "edges",
            [](const Scene2& s) { return edge_array(s, [](const Edge2&) { return true; }); },
            "(k, 2) uint32: source and target; the interior of bodies is on the left.")
        .def_property_readonly(
            "walls",
            [](const Scene2& s) {
                return edge_array(s, [](const Edge2& e) { return e.kind == EdgeKind2::wall; });
            },
            "(k, 2) uint32: the edges that are walls.")
        .def_property_readonly("rings", &rings_of,
                               "Ring(vertices, body, is_hole) of every closed chain.")
        .def_property_readonly(
            "points",
            [](const Scene2& s) {
                return to_array(std::vector(s.points().begin(), s.points().end()));
            },
            "Numbers of the vertices that are points.")
        .def_property_readonly("vertex_count", &Scene2::vertex_count)
        .def_property_readonly("edge_count", &Scene2::edge_count)
        .def_property_readonly("body_count", &Scene2::body_count)
        .def_property_readonly("has_world", &Scene2::has_world);
}

}  // namespace

void bind_scene(py::module_& module) {
    py::class_<Polygon2>(module, "Polygon2", "An outer ring and the rings of its holes.")
        .def(py::init(&polygon_from), py::arg("outer"), py::arg("holes") = py::tuple(),
             "Rings are (n, 2) arrays, in any orientation; a repeated closing vertex is dropped.");
    py::class_<Scene2, ScenePointer> scene(
        module, "Scene2", "A valid plane scene: bodies, walls, points, maybe a world. Immutable.");
    scene
        .def(py::init(&scene_from), py::arg("polygons") = py::tuple(),
             py::arg("walls") = py::tuple(), py::arg("points") = py::tuple(), py::kw_only(),
             py::arg("world") = false, py::arg("repair") = false,
             R"(A scene of polygons, then walls, then points, numbered in this order.

polygons  each a Polygon2, or an (n, 2) array-like for one without holes
walls     each an (n, 2) array-like: consecutive points are joined
points    an (n, 2) array-like
world     whether the first polygon is the free world, and its holes bodies
repair    merge overlapping bodies and remove repeats; each change is a RepairWarning

Coordinates become the nearest doubles. Raises SightlineError when the scene is invalid.)")
        .def("with_points", &with_points, py::arg("points"), "The scene with more points in it.")
        .def(
            "__eq__", [](const Scene2& a, const Scene2& b) { return a == b; }, py::is_operator())
        .def("__repr__", &described);
    bind_readers(scene);
    bind_parts(scene);
}

}  // namespace sightline::detail
