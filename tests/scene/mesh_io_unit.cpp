// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/mesh_io.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cstring>
#include <sstream>

#include "sightline/scene/off.hpp"
#include "support/meshes.hpp"

namespace sightline {
namespace {

using ::testing::ElementsAre;

const char* const tetrahedron_off =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

void expect_tetrahedron(const Result<MeshInput3>& mesh) {
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->vertices.size(), 4u);
    const Result<Scene3> scene = test::make_scene3({*mesh});
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->edges().size(), 6u);
}

TEST(ReadOff, KeepsVerticesFacesAndTheirLines) {
    const Result<MeshInput3> mesh = read_off(tetrahedron_off);
    expect_tetrahedron(mesh);
    EXPECT_EQ(mesh->vertices[2], (Point3{0, 1, 0}));
    EXPECT_THAT(mesh->faces[3], ElementsAre(0, 3, 2));
    EXPECT_THAT(mesh->vertex_lines, ElementsAre(3, 4, 5, 6));
    EXPECT_THAT(mesh->face_lines, ElementsAre(7, 8, 9, 10));
}

TEST(ReadOff, AcceptsTheWaysInWhichOffIsWritten) {
    const std::string body = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
    for (const char* const head :
         {"OFF\n4 4 6\n", "OFF 4 4 6\n", "OFF\n4 4\n", "OFF\n# made by hand\n\n4 4 6 # counts\n",
          "4 4 0\n", "\xef\xbb\xbfOFF\r\n4 4 6\r\n"})
        expect_tetrahedron(read_off(std::string(head) + body));
    expect_tetrahedron(
        read_off("COFF\n4 4 6\n0 0 0 255 0 0 255\n1 0 0 0 0 0 0\n0 1 0 1 1 1 1\n"
                 "0 0 1 0.5 0.5 0.5 1\n3 0 2 1 255 0 0\n3 0 1 3\n3 1 2 3\n3 0 3 2 0.1 0.2 0.3\n"));
    expect_tetrahedron(
        read_off("NOFF\n4 4 6\n0 0 0 -1 -1 -1\n1 0 0 1 0 0\n0 1 0 0 1 0\n"
                 "0 0 1 0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2"));
}

TEST(ReadOff, TakesTheNearestDoubles) {
    const Result<MeshInput3> mesh =
        read_off("OFF 3 1 0\n0.1 1e-320 -1e300\n1 2 3\n4 5 6\n3 0 1 2\n");
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->vertices[0], (Point3{0.1, 1e-320, -1e300}));
}

TEST(ReadOff, WhatIsWrittenIsReadBack) {
    SceneInput3 scene;
    scene.meshes = {test::box_mesh({0.1, -0.3, 1e-310}, {1e300, 0.7, 5})};
    std::ostringstream out;
    write_off(out, scene);
    const Result<MeshInput3> again = read_off(out.str());
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->vertices, scene.meshes[0].vertices);
    EXPECT_EQ(again->faces, scene.meshes[0].faces);
}

struct Bad {
    const char* name;
    const char* text;
    Errc code;
    const char* message;
};
class ReadOffRefuses : public ::testing::TestWithParam<Bad> {};
TEST_P(ReadOffRefuses, AndSaysWhere) {
    const Result<MeshInput3> mesh = read_off(GetParam().text, {.file = "a.off"});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().code, GetParam().code);
    EXPECT_THAT(mesh.error().message, ::testing::StartsWith(GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(
    Texts, ReadOffRefuses,
    ::testing::Values(
        Bad{"Nothing", "", Errc::syntax, "a.off:1:1: expected the word OFF"},
        Bad{"OtherText", "hello", Errc::syntax, "a.off:1:1: expected the word OFF"},
        Bad{"Binary", "OFF BINARY\n", Errc::unsupported, "a.off:1:5: binary OFF"},
        Bad{"FourDimensions", "4OFF\n1 0 0\n", Errc::unsupported, "a.off:1:1: vertices of other"},
        Bad{"NoCounts", "OFF\n", Errc::syntax, "a.off:2:1: expected a whole number"},
        Bad{"NegativeCount", "OFF\n-3 1 0\n", Errc::syntax, "a.off:2:1: -3 vertices"},
        Bad{"HugeCount", "OFF\n99999999999 1 0\n", Errc::syntax,
            "a.off:2:1: 99999999999 vertices"},
        Bad{"CountBeyondTheText", "OFF\n4000000000 1 0\n0 0 0\n", Errc::syntax,
            "a.off:4:1: the text ends after 1 of 4000000000 vertices"},
        Bad{"TwoCoordinates", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", Errc::syntax,
            "a.off:4:4: the line ends"},
        Bad{"FourCoordinates", "OFF\n3 1 0\n0 0 0 1\n", Errc::syntax,
            "a.off:3:7: expected the end of the line"},
        Bad{"NoNumber", "OFF\n3 1 0\n0 x 0\n", Errc::syntax,
            "a.off:3:3: expected a number, found 'x'"},
        Bad{"BeyondDoubles", "OFF\n3 1 0\n0 1e400 0\n", Errc::coordinate_too_large, "a.off:3:3: "},
        Bad{"UnknownVertex", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", Errc::unknown_vertex,
            "a.off:6:7: face 0 names vertex 3, but there are 3"},
        Bad{"NegativeVertex", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", Errc::unknown_vertex,
            "a.off:6:7: face 0 names vertex -1"},
        Bad{"FaceEnds", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", Errc::syntax,
            "a.off:7:1: expected a whole number, but the text ends"},
        Bad{"TooFewFaces", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", Errc::syntax,
            "a.off:7:1: the text ends after 1 of 2 faces"},
        Bad{"MoreFaces", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n", Errc::syntax,
            "a.off:7:1: expected the end after 1 faces"}),
    [](const auto& test) { return test.param.name; });

TEST(ReadOff, HonoursTheLimit) {
    const Result<MeshInput3> mesh = read_off(tetrahedron_off, {.max_elements = 10});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().code, Errc::limit_reached);
    EXPECT_TRUE(read_off(tetrahedron_off, {.max_elements = 20}))
        << "4 vertices, 4 faces, 12 corners";
}

TEST(ReadObj, KeepsPositionsAndIgnoresTheRest) {
    const Result<MeshInput3> mesh = read_obj(
        "# made by hand\nmtllib x.mtl\no thing\nv 0 0 0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nv 0 0 1\nvt "
        "0 0\n"
        "vn 0 0 1\ns off\nusemtl red\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\nf 2/1 3/1 \\\n  4/1\n"
        "g end\nf -4 -1 -2 # comment\n");
    expect_tetrahedron(mesh);
    EXPECT_THAT(mesh->faces, ElementsAre(ElementsAre(0, 2, 1), ElementsAre(0, 1, 3),
                                         ElementsAre(1, 2, 3), ElementsAre(0, 3, 2)));
    EXPECT_THAT(mesh->face_lines, ElementsAre(12, 13, 14, 17));
}

TEST(ReadObj, NegativeNumbersCountFromTheLastVertexSoFar) {
    const Result<MeshInput3> mesh =
        read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -1 1 2\n");
    ASSERT_TRUE(mesh);
    EXPECT_THAT(mesh->faces, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(3, 0, 1)));
}

class ReadObjRefuses : public ::testing::TestWithParam<Bad> {};
TEST_P(ReadObjRefuses, AndSaysWhere) {
    const Result<MeshInput3> mesh = read_obj(GetParam().text, {.file = "a.obj"});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().code, GetParam().code);
    EXPECT_THAT(mesh.error().message, ::testing::StartsWith(GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(
    Texts, ReadObjRefuses,
    ::testing::Values(
        Bad{"OtherText", "hello\n", Errc::syntax, "a.obj:2:1: there is no line 'f"},
        Bad{"Zero", "v 0 0 0\nf 0 1 1\n", Errc::unknown_vertex, "a.obj:2:3: vertex 0 of 1 so far"},
        Bad{"BeforeTheFirst", "v 0 0 0\nf 1 1 -2\n", Errc::unknown_vertex,
            "a.obj:2:7: vertex -2 of 1"},
        Bad{"AfterTheLast", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", Errc::unknown_vertex,
            "a.obj:4:1: the face in line 3 names vertex 3, but there are 2"},
        Bad{"NoCorner", "v 0 0 0\nf 1 x 1\n", Errc::syntax, "a.obj:2:5: expected a whole number"},
        Bad{"FourParts", "v 0 0 0\nf 1/1/1/1 1 1\n", Errc::syntax, "a.obj:2:8: expected a corner"},
        Bad{"TwoCoordinates", "v 0 0\n", Errc::syntax, "a.obj:1:6: the line ends"}),
    [](const auto& test) { return test.param.name; });

TEST(ReadPly, ReadsText) {
    expect_tetrahedron(read_ply(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
        "property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"));
}

TEST(ReadPly, RefusesWhatIsNone) {
    const Result<MeshInput3> mesh =
        read_ply("ply\nformat ascii 1.0\nelement vertex 4\n", {.file = "a.ply"});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().code, Errc::syntax);
    EXPECT_THAT(mesh.error().message, ::testing::StartsWith("a.ply: cannot be read as PLY"));
}

const std::array<std::array<Point3, 3>, 4> facets{{{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}},
                                                   {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}},
                                                   {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                                   {{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}}}};

TEST(ReadStl, MergesCornersOfText) {
    std::ostringstream out;
    out << "solid tetrahedron\n";
    for (const auto& facet : facets) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (const Point3& p : facet) out << "vertex " << p.x << ' ' << p.y << ' ' << p.z << '\n';
        out << "endloop\nendfacet\n";
    }
    out << "endsolid tetrahedron\n";
    expect_tetrahedron(read_stl(out.str()));
}

TEST(ReadStl, MergesCornersOfBinaryFiles) {
    std::string bytes(80, ' ');
    const auto put = [&](const auto& value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    };
    put(std::uint32_t{4});
    for (const auto& facet : facets) {
        for (int i = 0; i < 3; ++i) put(0.0F);
        for (const Point3& p : facet)
            for (const double x : {p.x, p.y, p.z}) put(static_cast<float>(x));
        put(std::uint16_t{0});
    }
    expect_tetrahedron(read_stl(bytes));
}

TEST(ReadMesh, TheNameTellsTheFormat) {
    EXPECT_EQ(mesh_format("a/b.OFF"), MeshFormat::off);
    EXPECT_EQ(mesh_format("x.obj"), MeshFormat::obj);
    EXPECT_EQ(mesh_format("x.ply"), MeshFormat::ply);
    EXPECT_EQ(mesh_format("x.stl"), MeshFormat::stl);
    EXPECT_EQ(mesh_format("x.wkt"), std::nullopt);
    EXPECT_EQ(mesh_format("off"), std::nullopt);
    const Result<MeshInput3> missing = read_mesh(std::string("no/such.off"));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, Errc::cannot_open);
}

}  // namespace
}  // namespace sightline
