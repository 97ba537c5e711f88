// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bind.hpp"
#include "convert.hpp"
#include "sightline/scene/families3.hpp"
#include "sightline/scene/mesh_io.hpp"
#include "sightline/skeleton/build.hpp"
#include "sightline/skeleton/check.hpp"
#include "sightline/skeleton/geometry.hpp"

namespace sightline::detail {
namespace {

using Scene3Pointer = std::shared_ptr<Scene3>;

// --- scenes --------------------------------------------------------------------------------------

Scene3Pointer scene_from(const SceneInput3& input) {
    auto scene = [&] {
        const py::gil_scoped_release release;
        return Scene3::make(input);
    }();
    return std::make_shared<Scene3>(unwrap(std::move(scene)));
}

MeshInput3 mesh_from(const py::handle& pair, SurfaceKind kind) {
    using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
    const auto mesh = py::cast<py::sequence>(pair);
    if (mesh.size() != 2) throw py::value_error("a mesh is a pair (vertices, faces)");
    const auto points = Array::ensure(mesh[0]);
    if (!points || points.ndim() != 2 || points.shape(1) != 3) {
        PyErr_Clear();
        throw py::value_error("vertices of a mesh have to be an (n, 3) array of numbers");
    }
    MeshInput3 out;
    out.kind = kind;
    const auto rows = points.unchecked<2>();
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
        out.vertices.push_back({rows(i, 0), rows(i, 1), rows(i, 2)});
    }
    out.faces = py::cast<std::vector<std::vector<std::uint32_t>>>(mesh[1]);
    return out;
}

Scene3Pointer scene_of_meshes(const py::iterable& meshes, const py::iterable& sheets, bool world) {
    SceneInput3 input;
    input.world = world;
    for (const auto& mesh : meshes) input.meshes.push_back(mesh_from(mesh, SurfaceKind::solid));
    for (const auto& mesh : sheets) input.meshes.push_back(mesh_from(mesh, SurfaceKind::sheet));
    return scene_from(input);
}

Scene3Pointer read_scene(const py::args& paths, bool world, bool sheets) {
    SceneInput3 input;
    input.world = world;
    for (const auto& path : paths) {
        const auto name = py::cast<std::string>(py::module_::import("os").attr("fspath")(path));
        const bool is_world = world && input.meshes.empty();
        const auto kind = sheets && !is_world ? SurfaceKind::sheet : SurfaceKind::solid;
        input.meshes.push_back(unwrap(read_mesh(name, MeshReadOptions{.kind = kind})));
    }
    return scene_from(input);
}

Scene3Pointer generated(const std::string& name, const std::vector<std::string>& parameters,
                        std::uint64_t seed) {
    return scene_from(unwrap(families::generate3(name, parameters, seed)));
}

py::array_t<double> vertices_of(const Scene3& scene) {
    py::array_t<double> out({static_cast<py::ssize_t>(scene.vertices().size()), py::ssize_t{3}});
    double* next = out.mutable_data();
    for (const Point3& p : scene.vertices()) {
        for (const double x : {p.x, p.y, p.z}) *next++ = x;
    }
    return out;
}

py::array_t<std::uint32_t> edges_of(const Scene3& scene) {
    py::array_t<std::uint32_t> out(
        {static_cast<py::ssize_t>(scene.edges().size()), py::ssize_t{2}});
    std::uint32_t* next = out.mutable_data();
    for (const Edge3& e : scene.edges()) {
        *next++ = e.source.value;
        *next++ = e.target.value;
    }
    return out;
}

py::array_t<std::uint32_t> triangles_of(const Scene3& scene) {
    py::array_t<std::uint32_t> out(
        {static_cast<py::ssize_t>(scene.triangles().size()), py::ssize_t{3}});
    std::uint32_t* next = out.mutable_data();
    for (const Triangle3& t : scene.triangles()) {
        for (const VertexId v : t.corners) *next++ = v.value;
    }
    return out;
}

// --- skeletons -----------------------------------------------------------------------------------

struct SkeletonResult {
    Scene3Pointer scene;
    VisibilitySkeleton skeleton;
    Tally tally;
};

py::list numbers(const std::vector<VertexId>& ids) {
    py::list out;
    for (const VertexId v : ids) out.append(v.value);
    return out;
}

py::list pairs(const Scene3& scene, const std::vector<EdgeId>& edges) {
    py::list out;
    for (const EdgeId e : edges) {
        out.append(py::make_tuple(scene[e].source.value, scene[e].target.value));
    }
    return out;
}

// Faces by their first input face, and whether the back is meant; None at infinity.
py::tuple ends_of(const Scene3& scene, const SegmentLabel& label) {
    py::tuple out(2);
    for (std::size_t i = 0; i < 2; ++i) {
        if (label.ends[i].empty()) {
            out[i] = py::none();
            continue;
        }
        py::list faces;
        for (const FaceSide& side : label.ends[i]) {
            faces.append(py::make_tuple(scene[side.face].input_faces.front(), side.back));
        }
        out[i] = std::move(faces);
    }
    return out;
}

py::list nodes_of(const SkeletonResult& result) {
    const py::object type = py::module_::import("sightline._types").attr("SkeletonNode");
    const Scene3& scene = *result.scene;
    py::list out;
    for (const SkeletonNode& node : result.skeleton.nodes()) {
        const Support& support = node.label.support;
        py::list faces;
        for (const FaceId f : node.faces) faces.append(scene[f].input_faces.front());
        py::object root = py::none();
        if (node.root != Root::only) root = py::int_(node.root == Root::first ? 0 : 1);
        out.append(type(std::string(name_of(node.type)), numbers(support.vertices),
                        pairs(scene, support.edges), pairs(scene, support.along),
                        ends_of(scene, node.label), faces, root));
    }
    return out;
}

py::list arcs_of(const SkeletonResult& result) {
    const py::object type = py::module_::import("sightline._types").attr("SkeletonArc");
    py::list out;
    for (const SkeletonArc& arc : result.skeleton.arcs()) {
        const Support& support = arc.label.support;
        out.append(type(std::string(name_of(arc.type)), numbers(support.vertices),
                        pairs(*result.scene, support.edges), ends_of(*result.scene, arc.label),
                        py::make_tuple(arc.nodes[0].value, arc.nodes[1].value)));
    }
    return out;
}

py::object number_of(const Surd& x) {
    if (x.is_rational()) return to_fraction(x.rational_part());
    const py::object type = py::module_::import("sightline._types").attr("Surd");
    return type(to_fraction(x.rational_part()), x.root_sign() == Sign::negative ? -1 : 1,
                to_fraction(x.radicand()));
}

NodeId node_id(const SkeletonResult& result, std::size_t node) {
    if (node >= result.skeleton.nodes().size()) throw py::index_error("no such node");
    return NodeId{static_cast<std::uint32_t>(node)};
}

py::object plucker_of(const SkeletonResult& result, std::size_t node) {
    const auto line = SkeletonGeometry(*result.scene).line(result.skeleton[node_id(result, node)]);
    if (!line) return py::none();
    py::list out;
    for (const Surd& x : line->coordinates()) out.append(number_of(x));
    return py::tuple(out);
}

// Rows of two ends, whether each is a direction, and a point of each segment.
py::tuple to_arrays(const std::vector<ApproxSegment>& segments) {
    const auto n = static_cast<py::ssize_t>(segments.size());
    py::array_t<double> ends({n, py::ssize_t{2}, py::ssize_t{3}});
    py::array_t<bool> at_infinity({n, py::ssize_t{2}});
    py::array_t<double> through({n, py::ssize_t{3}});
    double* p = through.mutable_data();
    double* x = ends.mutable_data();
    bool* infinite = at_infinity.mutable_data();
    for (const ApproxSegment& s : segments) {
        for (const double c : {s.through.x, s.through.y, s.through.z}) *p++ = c;
        for (std::size_t i = 0; i < 2; ++i) {
            for (const double c : {s.ends[i].x, s.ends[i].y, s.ends[i].z}) *x++ = c;
            *infinite++ = s.is_infinite[i];
        }
    }
    return py::make_tuple(ends, at_infinity, through);
}

py::tuple approx_node(const SkeletonResult& result, std::size_t node) {
    const auto segment =
        SkeletonGeometry(*result.scene).segment(result.skeleton[node_id(result, node)]);
    std::vector<ApproxSegment> segments;
    if (segment) segments.push_back(approx_end_points(*segment));
    return to_arrays(segments);
}

py::tuple approx_arc(const SkeletonResult& result, std::size_t arc, std::size_t count) {
    if (arc >= result.skeleton.arcs().size()) throw py::index_error("no such arc");
    return to_arrays(
        SkeletonGeometry(*result.scene)
            .approx_segments(result.skeleton, ArcId{static_cast<std::uint32_t>(arc)}, count));
}

FaceId face_with(const Scene3& scene, std::uint32_t number) {
    for (std::uint32_t f = 0; f < scene.faces().size(); ++f) {
        const auto& inputs = scene[FaceId{f}].input_faces;
        if (std::ranges::binary_search(inputs, number)) return FaceId{f};
    }
    throw py::value_error("there is no face " + std::to_string(number));
}

std::shared_ptr<SkeletonResult> skeleton_of(const Scene3Pointer& scene,
                                            const std::optional<std::array<std::uint32_t, 2>>& pair,
                                            unsigned threads, const std::string& arithmetic) {
    auto out = std::make_shared<SkeletonResult>();
    out->scene = scene;
    SkeletonOptions options;
    options.arithmetic = arithmetic_from(arithmetic);
    options.threads = threads;
    options.tally = &out->tally;
    if (pair) options.part.between = {face_with(*scene, (*pair)[0]), face_with(*scene, (*pair)[1])};
    out->skeleton = unwrap(interruptible(
        [&](const Limits& limits) { return visibility_skeleton(*scene, options, limits); }));
    return out;
}

py::dict check_of(const SkeletonResult& result, std::size_t paths, std::uint64_t seed) {
    SkeletonCheckOptions options;
    options.families = paths;
    options.seed = seed;
    const SkeletonCheck check = unwrap(interruptible([&](const Limits& limits) {
        return check_skeleton(*result.scene, result.skeleton, options, limits);
    }));
    py::dict out;
    out["paths"] = check.families;
    out["shots"] = check.shots;
    out["crossings"] = check.crossings;
    out["missing"] = check.missing;
    out["false"] = check.false_arcs;
    out["mismatches"] = check.mismatches;
    return out;
}

}  // namespace

void bind_space(py::module_& module) {
    py::class_<Scene3, Scene3Pointer>(module, "Scene3",
                                      "A valid scene of space: solids and sheets. Immutable.")
        .def(
            py::init(&scene_of_meshes), py::arg("meshes") = py::tuple(), py::kw_only(),
            py::arg("sheets") = py::tuple(), py::arg("world") = false,
            R"(Meshes are pairs (vertices, faces): an (n, 3) array, and lists of indices, counter-clockwise
seen from outside. With `world` the first mesh bounds the free world. Raises SightlineError.)")
        .def_property_readonly("vertices", &vertices_of, "(n, 3) float64.")
        .def_property_readonly("edges", &edges_of, "(m, 2) uint32: feature edges, u < v.")
        .def_property_readonly("triangles", &triangles_of,
                               "(k, 3) uint32: the faces in triangles, for drawing.")
        .def_property_readonly("face_count", [](const Scene3& s) { return s.faces().size(); })
        .def_property_readonly("body_count", [](const Scene3& s) { return s.bodies().size(); })
        .def("__repr__", [](const Scene3& s) {
            return "<Scene3: " + std::to_string(s.bodies().size()) + " bodies, " +
                   std::to_string(s.edges().size()) + " edges>";
        });
    module.def("read_scene3", &read_scene, py::kw_only(), py::arg("world") = false,
               py::arg("sheets") = false,
               "The scene in OFF, OBJ, PLY and STL files, a mesh each; raises SightlineError.");
    module.def("_generate3", &generated, py::arg("name"), py::arg("parameters"), py::arg("seed"));

    py::class_<SkeletonResult, std::shared_ptr<SkeletonResult>>(
        module, "VisibilitySkeleton",
        "Lines of sight that cannot move (nodes), and sweeps with one way to move (arcs).")
        .def_property_readonly("nodes", &nodes_of, "A list of SkeletonNode.")
        .def_property_readonly("arcs", &arcs_of, "A list of SkeletonArc.")
        .def_property_readonly("node_count",
                               [](const SkeletonResult& r) { return r.skeleton.nodes().size(); })
        .def_property_readonly("arc_count",
                               [](const SkeletonResult& r) { return r.skeleton.arcs().size(); })
        .def_property_readonly("scene", [](const SkeletonResult& r) { return r.scene; })
        .def("plucker", &plucker_of, py::arg("node"),
             "The exact line of a node: six numbers, Fraction or Surd; the direction, then the "
             "moment.")
        .def("approx_segment", &approx_node, py::arg("node"),
             "For drawing: ends, (1, 2, 3) float64; which of them are directions, (1, 2) bool; a "
             "point of "
             "the segment, (1, 3).")
        .def("approx_segments", &approx_arc, py::arg("arc"), py::arg("count") = 15,
             "For drawing: segments of an arc from node to node, as approx_segment() gives them.")
        .def("check", &check_of, py::arg("paths") = 200, py::kw_only(), py::arg("seed") = 1,
             "Compares the arcs with exact shots along random paths of lines.")
        .def_property_readonly(
            "tally", [](const SkeletonResult& r) { return to_dict(r.tally); },
            "Which arithmetic decided: {predicate: {tier: count}}.")
        .def(
            "__eq__",
            [](const SkeletonResult& a, const SkeletonResult& b) {
                return a.skeleton == b.skeleton;
            },
            py::is_operator())
        .def("__repr__", [](const SkeletonResult& r) {
            return "<VisibilitySkeleton: " + std::to_string(r.skeleton.nodes().size()) +
                   " nodes, " + std::to_string(r.skeleton.arcs().size()) + " arcs>";
        });
    module.def("skeleton", &skeleton_of, py::arg("scene"), py::kw_only(),
               py::arg("pair") = py::none(), py::arg("threads") = 0,
               py::arg("arithmetic") = "filtered",
               R"(The visibility skeleton of a scene of space.

pair        only arcs that end at both of these faces, by their input numbers
threads     how many to use; 0 takes what the machine has
arithmetic  "filtered", "exact"; "interval" and "double" may be wrong)");
}

}  // namespace sightline::detail
