// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of every kind of arc and node, each from the visibility skeleton of a small scene.

#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "scenes.hpp"
#include "sightline/scene/families3.hpp"
#include "sightline/skeleton/build.hpp"
#include "sightline/viz/draw.hpp"
#include "sightline/viz/draw_skeleton.hpp"
#include "sightline/viz/render.hpp"

namespace sightline::experiments {
namespace {

using Names = std::vector<std::pair<std::uint32_t, std::string>>;

struct Figure {
    std::string file;
    std::string title;
    std::vector<MeshInput3> scene;
    bool is_node = false;
    std::string label;  ///< of the arc or node
    viz::Position look_from;
    Names vertices;  ///< generators, with the names that the page gives them
    Names edges;
    Names faces;
    double margin = 0.15;
};

viz::Position position(const Point3& p) { return {p.x, p.y, p.z}; }

template <typename T>
std::string text_of(const T& value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

/// The generators, drawn bold and named.
viz::Layer generators_of(const Figure& figure, const Scene3& scene) {
    viz::Layer layer{.name = "generators",
                     .legend = "generators",
                     .order = viz::PaintOrder::marks,
                     .style = {.colour = viz::Palette::black,
                               .width = 4,
                               .marker = viz::Marker::disc,
                               .marker_size = 13}};
    for (const auto& [id, name] : figure.vertices) {
        const viz::Position p = position(scene[VertexId{id}]);
        layer.points.push_back(p);
        layer.labels.push_back({p, name});
    }
    for (const auto& [id, name] : figure.edges) {
        const Edge3& edge = scene[EdgeId{id}];
        const viz::Position a = position(scene[edge.source]);
        const viz::Position b = position(scene[edge.target]);
        layer.polylines.push_back({{a, b}, id});
        const auto at = [](double from, double to) { return from * 0.8 + to * 0.2; };
        layer.labels.push_back({{at(a.x, b.x), at(a.y, b.y), at(a.z, b.z)}, name});
    }
    for (const auto& [id, name] : figure.faces) {
        viz::Position centre;
        const auto& ring = scene[FaceId{id}].rings[0];
        for (const VertexId v : ring) {
            const double share = 1 / static_cast<double>(ring.size());
            centre = {centre.x + scene[v].x * share, centre.y + scene[v].y * share,
                      centre.z + scene[v].z * share};
        }
        layer.labels.push_back({centre, name});
    }
    return layer;
}

/// The arc with that label, or the node with that label and its arcs.
viz::SkeletonDrawOptions selection_of(const Figure& figure, const VisibilitySkeleton& skeleton) {
    viz::SkeletonDrawOptions options;
    options.margin = figure.margin;
    for (std::uint32_t n = 0; figure.is_node && n < skeleton.nodes().size(); ++n) {
        if (text_of(skeleton[NodeId{n}].label) != figure.label) continue;
        const auto arcs = skeleton.arcs_at(NodeId{n});
        options.arcs = std::vector<ArcId>(arcs.begin(), arcs.end());
        options.nodes = std::vector<NodeId>{NodeId{n}};
        return options;
    }
    for (std::uint32_t a = 0; !figure.is_node && a < skeleton.arcs().size(); ++a) {
        if (text_of(skeleton[ArcId{a}].label) != figure.label) continue;
        options.arcs = std::vector<ArcId>{ArcId{a}};
        return options;
    }
    throw std::runtime_error(figure.file + ": the skeleton has no '" + figure.label + "'");
}

void draw(const Figure& figure, const std::string& folder) {
    const auto scene = Scene3::make({.meshes = figure.scene, .world = false});
    if (!scene) throw std::runtime_error(scene.error().message);
    const VisibilitySkeleton skeleton = visibility_skeleton(*scene);
    viz::SkeletonDrawOptions options = selection_of(figure, skeleton);
    options.scene.title = figure.title;
    options.scene.camera.from = figure.look_from;
    viz::DrawList list = viz::draw(*scene, skeleton, options);
    for (viz::Layer& layer : list.layers) {
        if (layer.name.starts_with("nodes")) layer.style.width = 4.5;
        if (layer.name == "faces" || layer.name == "sheets" || layer.name == "edges") {
            layer.legend.clear();
        }
    }
    list.add(generators_of(figure, *scene));
    const auto drawn =
        viz::render_png(list, folder + "/" + figure.file, {.width = 900, .supersampling = 2});
    if (!drawn) throw std::runtime_error(drawn.error().message);
    std::cout << figure.file << ": " << options.arcs->size() << " arcs\n";
}

std::vector<Figure> arcs() {
    const std::vector<MeshInput3> two_boxes{box({0, 0, 0}, {2, 2, 2}), box({5, -1, 1}, {6, 4, 5})};
    const std::vector<MeshInput3> slab_and_post{box({0, 0, 0}, {6, 4, 1}),
                                                box({9, 1, -2}, {10, 2, 4})};
    return {
        {.file = "event-ev.png",
         .title = "EV: the lines through a vertex v that meet an edge e",
         .scene = two_boxes,
         .label = "v6 e14 | inf | inf",
         .look_from = {-0.4, -1, 0.7},
         .vertices = {{6, "v"}},
         .edges = {{14, "e"}},
         .faces = {}},
        {.file = "event-eee.png",
         .title = "EEE: the lines that meet three edges e, f, g",
         .scene = sheets(3),
         .label = "e3 e6 e8 | inf | inf",
         .look_from = {0.45, -1, 0.5},
         .vertices = {},
         .edges = {{3, "e"}, {6, "f"}, {8, "g"}},
         .faces = {}},
        {.file = "event-fv.png",
         .title = "Fv: the lines in the plane of a face F through its vertex v",
         .scene = {tetrahedron({0, 0, 0}, {6, 0, 0}, {2, 5, 0}, {3, 2, 4})},
         .label = "v3 e0 | inf | inf",
         .look_from = {0.5, -1, 0.45},
         .vertices = {{3, "v"}},
         .edges = {{0, "opposite edge"}},
         .faces = {{1, "F"}}},
        {.file = "event-fe.png",
         .title = "FE: the lines in the plane of a face F through a point of an edge e",
         .scene = slab_and_post,
         .label = "e8 e10 e14 | inf | f8 f11",
         .look_from = {-0.35, -1, 0.8},
         .vertices = {},
         .edges = {{14, "e"}},
         .faces = {{1, "F"}}},
    };
}

std::vector<Figure> nodes() {
    const std::vector<MeshInput3> posts{box({0, 0, 0}, {6, 4, 1}), box({9, 1, -2}, {10, 2, 4}),
                                        box({-4, 2, -2}, {-3, 3, 4})};
    const std::vector<MeshInput3> slab_and_post{posts[0], posts[1]};
    return {
        {.file = "event-vv.png",
         .title = "VV: two vertices v, w, and the arcs that leave their line",
         .scene = {tetrahedron({0, 0, 0}, {6, 0, 0}, {2, 5, 0}, {3, 2, 4}),
                   tetrahedron({9, 4, 1}, {14, 5, 0}, {10, 9, 1}, {12, 6, 5})},
         .is_node = true,
         .label = "v3 v7 | inf | inf",
         .look_from = {0.6, -1, 0.45},
         .vertices = {{3, "v"}, {7, "w"}},
         .edges = {},
         .faces = {}},
        {.file = "event-vee.png",
         .title = "VEE: a vertex v and two edges e, f",
         .scene = {tetrahedron({-1, 0, 0}, {3, -1, 0}, {1, 3, 0}, {1, 1, 3}),
                   box({5, -1, -3}, {6, 3, 6}), box({9, -6, 3}, {10, 12, 4})},
         .is_node = true,
         .label = "v3 e8 e27 | inf | inf",
         .look_from = {-0.3, -1, 0.6},
         .vertices = {{3, "v"}},
         .edges = {{8, "e"}, {27, "f"}},
         .faces = {}},
        {.file = "event-eeee.png",
         .title = "EEEE: four edges e, f, g, h",
         .scene = sheets(4),
         .is_node = true,
         .label = "e0 e6 e8 e11 | inf | inf",
         .look_from = {0.45, -1, 0.5},
         .vertices = {},
         .edges = {{0, "e"}, {6, "f"}, {8, "g"}, {11, "h"}},
         .faces = {}},
        {.file = "event-fve.png",
         .title = "FvE: a vertex v of a face F, and an edge e that meets F's plane",
         .scene = slab_and_post,
         .is_node = true,
         .label = "v7 e10 e14 | inf | inf",
         .look_from = {-0.35, -1, 0.8},
         .vertices = {{7, "v"}},
         .edges = {{14, "e"}},
         .faces = {{1, "F"}}},
        {.file = "event-fee.png",
         .title = "FEE: a face F, and two edges e, f that meet its plane",
         .scene = posts,
         .is_node = true,
         .label = "e9 e10 e14 e30 | inf | inf",
         .look_from = {-0.35, -1, 0.8},
         .vertices = {},
         .edges = {{14, "e"}, {30, "f"}},
         .faces = {{1, "F"}}},
        {.file = "event-ff.png",
         .title = "FF: two faces F, G whose planes meet",
         .scene = {box({0, 0, 0}, {6, 4, 1}), box({2, 8, -1}, {3, 12, 3})},
         .is_node = true,
         .label = "e8 e11 e14 e19 | inf | inf",
         .look_from = {-0.9, -1, 0.7},
         .vertices = {},
         .edges = {},
         .faces = {{1, "F"}, {8, "G"}}},
    };
}

/// The picture of the page on the skeleton.
Figure two_boxes_triangle() {
    return {.file = "skeleton-two-boxes-triangle.png",
            .title = "One EEE swath: two edges of boxes and one of a triangle",
            .scene = families::two_boxes_triangle().meshes,
            .label = "e10 e19 e27 | f1 f3 | f10 f11",
            .look_from = {0.6, 1, 0.8},
            .vertices = {},
            .edges = {{10, "e"}, {27, "f"}, {19, "g"}},
            .faces = {}};
}

}  // namespace
}  // namespace sightline::experiments

int main(int argc, char** argv) {
    using namespace sightline::experiments;
    std::string folder;
    std::string only;
    CLI::App app("Draws the pictures of the catalogue of visual events.");
    app.add_option("FOLDER", folder, "where they go")->required();
    app.add_option("--only", only, "those whose file name contains this");
    CLI11_PARSE(app, argc, argv);
    try {
        std::vector<Figure> figures = arcs();
        for (Figure& figure : nodes()) figures.push_back(std::move(figure));
        figures.push_back(two_boxes_triangle());
        for (const Figure& figure : figures) {
            if (figure.file.find(only) != std::string::npos) draw(figure, folder);
        }
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
