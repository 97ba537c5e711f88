// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <string>

#include "bind.hpp"
#include "convert.hpp"
#include "sightline/scene/info2.hpp"

namespace sightline::detail {
namespace {

py::list contact_rows(const SceneInfo2& info) {
    const auto number = [](BodyId body) -> py::object {
        if (body.is_none()) return py::none();
        return py::int_(body.value);
    };
    py::list out;
    for (const BodyContact2& contact : info.contacts) {
        py::dict row;
        row["bodies"] = py::make_tuple(number(contact.first), number(contact.second));
        row["points"] = contact.points;
        row["edges"] = contact.edges;
        out.append(row);
    }
    return out;
}

void add_degeneracies(py::dict& out, const SceneInfo2& info) {
    py::list coincident;
    for (const auto& place : info.coincident) coincident.append(to_array(place).attr("tolist")());
    py::list on_edges;
    for (const auto& [vertex, edge] : info.vertices_on_edges) {
        on_edges.append(py::make_tuple(vertex.value, edge.value));
    }
    out["contacts"] = contact_rows(info);
    out["coincident"] = coincident;
    out["pinches"] = to_array(info.pinches).attr("tolist")();
    out["straight"] = to_array(info.straight).attr("tolist")();
    out["nearly_straight"] = to_array(info.nearly_straight).attr("tolist")();
    out["vertices_on_edges"] = on_edges;
    out["crossing_walls"] = info.crossing_walls;
    out["overlapping_walls"] = info.overlapping_walls;
    out["all_walls_compared"] = info.all_walls_compared;
    out["is_degenerate"] = info.is_degenerate();
}

py::dict described(const Scene2& scene) {
    const SceneInfo2 info = [&] {
        const py::gil_scoped_release release;
        return describe(scene);
    }();
    py::dict out;
    out["vertices"] = info.vertices;
    out["points"] = info.points;
    out["bodies"] = info.bodies;
    out["holes"] = info.holes;
    out["body_edges"] = info.body_edges;
    out["world_edges"] = info.world_edges;
    out["walls"] = info.walls;
    out["has_world"] = info.has_world;
    out["low"] = py::make_tuple(info.low.x, info.low.y);
    out["high"] = py::make_tuple(info.high.x, info.high.y);
    add_degeneracies(out, info);
    out["approx_shortest_edge"] = info.approx_shortest_edge;
    out["approx_extent"] = info.approx_extent;
    return out;
}

}  // namespace

void bind_info(py::module_& module) {
    module.def("info", &described, py::arg("scene"),
               R"(What a scene holds, and how degenerate it is, as a dict.

Counts (vertices, bodies, …), and lists of vertex numbers: bodies that touch (`contacts`), vertices at one
place (`coincident`), rings that touch themselves (`pinches`), vertices between collinear edges (`straight`,
`nearly_straight`), and pairs (vertex, edge) of `vertices_on_edges`.)");
}

}  // namespace sightline::detail
