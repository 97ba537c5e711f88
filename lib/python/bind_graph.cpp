// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bind.hpp"
#include "convert.hpp"
#include "sightline/planar/visibility_graph.hpp"

namespace sightline::detail {
namespace {

Collinear collinear_from(const std::string& word) {
    if (word == "nearest") return Collinear::nearest_only;
    if (word == "all") return Collinear::every_vertex;
    throw py::value_error("collinear is \"nearest\" or \"all\", not \"" + word + "\"");
}

struct GraphResult {
    VisibilityGraph graph;
    std::vector<VisibilityGraph::Edge> edges;  // made when they are first asked for
    Tally tally;
};

std::shared_ptr<GraphResult> graph_of(const ScenePointer& scene, const std::string& collinear,
                                      bool tangent, bool body_edges, const std::string& arithmetic,
                                      unsigned threads, std::optional<std::size_t> max_edges) {
    auto out = std::make_shared<GraphResult>();
    const VisibilityGraphOptions options{.collinear = collinear_from(collinear),
                                         .body_edges = body_edges,
                                         .tangent_only = tangent,
                                         .arithmetic = arithmetic_from(arithmetic),
                                         .threads = threads,
                                         .tally = &out->tally};
    out->graph = unwrap(interruptible([&](Limits limits) {
        if (max_edges) limits.max_elements = *max_edges;
        return visibility_graph(*scene, options, limits);
    }));
    return out;
}

py::array_t<std::uint32_t> edge_array(const py::object& self) {
    static_assert(sizeof(VisibilityGraph::Edge) == 2 * sizeof(std::uint32_t));
    auto& result = self.cast<GraphResult&>();
    if (result.edges.empty()) result.edges = result.graph.edges();
    return view_of_pairs<std::uint32_t>(result.edges.data(), result.edges.size(), self);
}

py::array_t<std::uint32_t> neighbour_array(const py::object& self, std::uint32_t vertex) {
    static_assert(sizeof(VertexId) == sizeof(std::uint32_t));
    const auto& graph = self.cast<const GraphResult&>().graph;
    if (vertex >= graph.vertex_count()) throw py::index_error("no such vertex");
    const auto neighbours = graph.neighbours(VertexId{vertex});
    py::array_t<std::uint32_t> view(static_cast<py::ssize_t>(neighbours.size()),
                                    reinterpret_cast<const std::uint32_t*>(neighbours.data()),
                                    self);
    view.attr("flags").attr("writeable") = false;
    return view;
}

bool has_edge(const GraphResult& result, std::uint32_t u, std::uint32_t v) {
    const std::size_t n = result.graph.vertex_count();
    return u < n && v < n && result.graph.has_edge(VertexId{u}, VertexId{v});
}

}  // namespace

void bind_graph(py::module_& module) {
    py::class_<GraphResult, std::shared_ptr<GraphResult>>(
        module, "VisibilityGraph", "An undirected graph on the vertices of a scene.")
        .def_property_readonly(
            "edges", &edge_array,
            "(m, 2) uint32, each row u < v, rows ascending; shares memory, read-only.")
        .def("neighbours", &neighbour_array, py::arg("vertex"),
             "The vertices that `vertex` sees, ascending; shares memory, read-only.")
        .def("has_edge", &has_edge, py::arg("u"), py::arg("v"), "Whether u and v are adjacent.")
        .def_property_readonly("vertex_count",
                               [](const GraphResult& r) { return r.graph.vertex_count(); })
        .def_property_readonly("edge_count",
                               [](const GraphResult& r) { return r.graph.edge_count(); })
        .def_property_readonly(
            "tally", [](const GraphResult& r) { return to_dict(r.tally); },
            "Which arithmetic decided: {predicate: {tier: count}}.")
        .def("__len__", [](const GraphResult& r) { return r.graph.edge_count(); })
        .def(
            "__eq__", [](const GraphResult& a, const GraphResult& b) { return a.graph == b.graph; },
            py::is_operator())
        .def("__repr__", [](const GraphResult& r) {
            return "<VisibilityGraph: " + std::to_string(r.graph.vertex_count()) + " vertices, " +
                   std::to_string(r.graph.edge_count()) + " edges>";
        });
    module.def("visibility_graph", &graph_of, py::arg("scene"), py::kw_only(),
               py::arg("collinear") = "nearest", py::arg("tangent") = false,
               py::arg("body_edges") = true, py::arg("arithmetic") = "filtered",
               py::arg("threads") = 1, py::arg("max_edges") = py::none(),
               R"(The visibility graph: which vertices of the scene see each other.

collinear   "nearest": along one line a vertex sees the next vertex only; "all": every one behind it
tangent     only edges that are locally tangent at both ends
body_edges  whether edges along the boundary of a body are edges of the graph
arithmetic  "filtered" and "exact" are always right; "interval" and "double" may be wrong
threads     0: one a core; the result is the same
max_edges   a larger graph raises SightlineError with code "limit_reached"

Ctrl-C ends the work with KeyboardInterrupt.)");
}

}  // namespace sightline::detail
