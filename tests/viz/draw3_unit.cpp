// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/draw3.hpp"

#include <gmock/gmock.h>

#include <set>

#include "support/scenes3.hpp"

namespace sightline::viz {
namespace {

using ::sightline::testing::scene3;
using ::testing::ElementsAre;

std::vector<std::string> names(const DrawList& list) {
    std::vector<std::string> result;
    for (const Layer& layer : list.layers) result.push_back(layer.name);
    return result;
}

TEST(DrawScene3, SolidIsFacesAndEdges) {
    const Scene3 scene = scene3("box 0 0 0, 1 2 3");
    const DrawList list = draw(scene, {.title = "T"});
    EXPECT_EQ(list.title, "T");
    EXPECT_EQ(list.camera, Camera{});
    EXPECT_FALSE(list.scale_bar) << "lengths are foreshortened";
    EXPECT_THAT(names(list), ElementsAre("faces", "edges"));
    const Layer& faces = list.layers[0];
    EXPECT_EQ(faces.count, 6u);
    ASSERT_EQ(faces.polygons.size(), 12u);
    std::set<std::uint32_t> ids;
    for (const Polygon& polygon : faces.polygons) {
        EXPECT_EQ(polygon.outer.size(), 3u);
        ids.insert(polygon.id);
    }
    EXPECT_EQ(ids.size(), 6u);
    EXPECT_EQ(faces.style.fill_opacity, 1);
}

TEST(DrawScene3, SegmentIsTheEdgeOfItsNumber) {
    const Scene3 scene = scene3("box 0 0 0, 1 2 3; box 4 0 0, 5 1 1");
    const DrawList list = draw(scene, {.edge_labels = true});
    const Layer& edges = *list.find("edges");
    ASSERT_EQ(edges.segments.size(), 2 * scene.edges().size());
    for (std::size_t i = 0; i < scene.edges().size(); ++i) {
        const Edge3& edge = scene.edges()[i];
        const Point3& a = scene[edge.source];
        const Point3& b = scene[edge.target];
        EXPECT_EQ(edges.segments[2 * i], (Position{a.x, a.y, a.z}));
        EXPECT_EQ(edges.segments[2 * i + 1], (Position{b.x, b.y, b.z}));
        EXPECT_EQ(edges.labels.at(i).text, "e" + std::to_string(i));
    }
}

TEST(DrawScene3, FaceWithAHoleIsCoveredOnce) {
    const Scene3 scene = scene3(families::solid(families::SolidShape::ring));
    const DrawList list = draw(scene);
    double area = 0;  // of the projections on the xy plane, without signs
    for (const Polygon& p : list.find("faces")->polygons) {
        const auto& [a, b, c] = std::tie(p.outer[0], p.outer[1], p.outer[2]);
        area += std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    }
    double expected = 0;  // outer rings less holes
    for (const Face3& face : scene.faces()) {
        double signed_area = 0;
        for (const auto& ring : face.rings) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point3& a = scene[ring[i]];
                const Point3& b = scene[ring[(i + 1) % ring.size()]];
                signed_area += (a.x * b.y - a.y * b.x) / 2;
            }
        }
        expected += std::abs(signed_area);
    }
    EXPECT_GT(expected, 0);
    EXPECT_DOUBLE_EQ(area, expected);
    EXPECT_TRUE(
        std::ranges::any_of(scene.faces(), [](const Face3& f) { return f.rings.size() > 1; }));
}

TEST(DrawScene3, SheetsAreTranslucentSolidsOnDemand) {
    const Scene3 scene = scene3("box 0 0 0, 1 1 1; sheet 3 0 0, 4 0 0, 4 1 0");
    const DrawList list = draw(scene, {.solid_opacity = 0.5});
    EXPECT_THAT(names(list), ElementsAre("faces", "sheets", "edges"));
    EXPECT_EQ(list.layers[0].style.fill_opacity, 0.5);
    EXPECT_EQ(list.layers[1].count, 1u);
    EXPECT_LT(list.layers[1].style.fill_opacity, 1);
    EXPECT_EQ(list.layers[1].polygons.size(), 1u);
}

TEST(DrawScene3, WorldIsHardlyVisible) {
    const Scene3 scene = scene3("world; box 0 0 0, 9 9 9; box 1 1 1, 2 2 2");
    const DrawList list = draw(scene);
    EXPECT_THAT(names(list), ElementsAre("faces", "world", "edges"));
    EXPECT_LT(list.find("world")->style.fill_opacity, 0.2);
    EXPECT_EQ(list.find("world")->count, 6u);
    EXPECT_EQ(list.find("faces")->count, 6u);
}

TEST(DrawScene3, VerticesAreMarkedAndNamedOnDemand) {
    const Scene3 scene = scene3("box 0 0 0, 1 1 1");
    const DrawList marked = draw(scene, {.vertices = true});
    EXPECT_EQ(marked.find("vertices")->points.size(), 8u);
    EXPECT_TRUE(marked.find("vertices")->labels.empty());
    const DrawList named = draw(scene, {.vertex_labels = true});
    EXPECT_TRUE(named.find("vertices")->points.empty());
    const Point3& v5 = scene[VertexId{5}];
    EXPECT_EQ(named.find("vertices")->labels.at(5), (Label{{v5.x, v5.y, v5.z}, "v5"}));
}

TEST(DrawScene3, VerticesThatAreNoFeaturesAreLeftOut) {
    // The middle of the top is a vertex of four coplanar triangles.
    SceneInput3 input = testing::scene_input3("box 0 0 0, 2 2 2");
    MeshInput3& mesh = input.meshes[0];
    mesh.vertices.push_back({1, 1, 2});
    mesh.faces[1] = {4, 5, 8};
    mesh.faces.insert(mesh.faces.end(), {{5, 6, 8}, {6, 7, 8}, {7, 4, 8}});
    const Result<Scene3> scene = Scene3::make(input);
    ASSERT_TRUE(scene) << scene.error().message;
    const DrawList list = draw(*scene, {.vertices = true});
    EXPECT_EQ(list.find("vertices")->count, 8u);
    EXPECT_EQ(list.find("vertices")->points.size(), 8u);
    EXPECT_EQ(list.find("edges")->count, 12u);
    EXPECT_EQ(list.find("faces")->count, 6u);
}

TEST(DrawScene3, BoxAroundHasTheMarginOnAllSides) {
    const Scene3 scene = scene3("box 0 0 0, 1 2 4");
    EXPECT_EQ(box_around(scene, 0.25), (Box{{-1, -1, -1}, {2, 3, 5}}));
}

}  // namespace
}  // namespace sightline::viz
