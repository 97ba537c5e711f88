// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every family of 3D scenes: surfaces are closed, planar and turned outwards, a seed fixes the bytes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "scene/families3_support.hpp"
#include "sightline/scene/families3.hpp"
#include "sightline/scene/mesh_io.hpp"
#include "sightline/scene/off.hpp"

namespace sightline {
namespace {

using families_test::determinant;
using families_test::fingerprint;
using testing::HasSubstr;

class EveryFamily3 : public testing::TestWithParam<families::FamilyInfo3> {
protected:
    static SceneInput3 generate(const std::vector<std::uint64_t>& sizes, std::uint64_t seed) {
        return GetParam().generate(sizes, seed);
    }
    static std::vector<std::uint64_t> defaults() {
        std::vector<std::uint64_t> sizes;
        for (const families::FamilyParameter& p : GetParam().parameters)
            sizes.push_back(p.default_value);
        return sizes;
    }
    /// Each parameter at its least value plus `more`, within its range.
    static std::vector<std::uint64_t> small(std::uint64_t more) {
        std::vector<std::uint64_t> sizes;
        for (const families::FamilyParameter& p : GetParam().parameters)
            sizes.push_back(std::min(p.least + more, p.greatest));
        return sizes;
    }
};

/// Whether each side of a face of a solid is a side of one other face, run through in the other sense; in a sheet, of
/// one other at most.
bool is_oriented_surface(const MeshInput3& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const auto& face : mesh.faces) {
        for (std::size_t i = 0; i < face.size(); ++i)
            ++sides[{face[i], face[(i + 1) % face.size()]}];
    }
    return std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
        const auto twin = sides.find({side.first.second, side.first.first});
        const int twins = twin == sides.end() ? 0 : twin->second;
        return side.second == 1 && (twins == 1 || mesh.kind == SurfaceKind::sheet);
    });
}

bool is_planar(const MeshInput3& mesh, const std::vector<std::uint32_t>& face) {
    for (std::size_t i = 3; i < face.size(); ++i) {
        for (std::size_t j = 2; j < i; ++j) {
            const auto at = [&](std::size_t k) { return mesh.vertices[face[k]]; };
            if (determinant(at(0), at(1), at(j), at(i)).sign() != Sign::zero) return false;
        }
    }
    return true;
}

void expect_valid(const SceneInput3& scene, const std::string& what) {
    const Result<Scene3> made = Scene3::make(scene);
    ASSERT_TRUE(made) << what << ": " << made.error().message;
    std::size_t vertices = 0;
    for (const MeshInput3& mesh : scene.meshes) vertices += mesh.vertices.size();
    EXPECT_EQ(made->vertices().size(), vertices) << what;
}

void expect_sound(const SceneInput3& scene, const std::string& what) {
    ASSERT_FALSE(scene.meshes.empty()) << what;
    for (const MeshInput3& mesh : scene.meshes) {
        EXPECT_EQ(mesh.kind, scene.meshes.front().kind) << what;
        std::set<std::uint32_t> used;
        for (const auto& face : mesh.faces) {
            ASSERT_GE(face.size(), 3U) << what;
            EXPECT_EQ(std::set(face.begin(), face.end()).size(), face.size()) << what;
            EXPECT_TRUE(is_planar(mesh, face)) << what;
            used.insert(face.begin(), face.end());
        }
        EXPECT_EQ(used.size(), mesh.vertices.size()) << what << ": isolated vertices";
        EXPECT_TRUE(is_oriented_surface(mesh)) << what;
        if (mesh.kind == SurfaceKind::solid) {
            EXPECT_EQ(families_test::six_volumes(mesh).sign(), Sign::positive) << what;
        }
    }
    expect_valid(scene, what);
}

INSTANTIATE_TEST_SUITE_P(All, EveryFamily3,
                         testing::ValuesIn(families::all3().begin(), families::all3().end()),
                         [](const auto& family) {
                             std::string name(family.param.name);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_P(EveryFamily3, IsSoundAtItsSmallestSizes) {
    for (std::uint64_t more = 0; more < 5; ++more) {
        for (std::uint64_t seed = 0; seed < 4; ++seed)
            expect_sound(generate(small(more), seed), "seed " + std::to_string(seed));
    }
}

TEST_P(EveryFamily3, IsSoundAtItsDefaultSizes) {
    for (std::uint64_t seed = 100; seed < 103; ++seed)
        expect_sound(generate(defaults(), seed), "seed " + std::to_string(seed));
}

TEST_P(EveryFamily3, GivesTheSameBytesForTheSameSeed) {
    for (std::uint64_t seed = 0; seed < 3; ++seed)
        EXPECT_EQ(fingerprint(generate(defaults(), seed)), fingerprint(generate(defaults(), seed)));
}

TEST_P(EveryFamily3, ComesBackFromOff) {
    const SceneInput3 scene = generate(defaults(), 7);
    for (const MeshInput3& mesh : scene.meshes) {
        std::ostringstream out;
        write_off(out, {{mesh}, false});
        const Result<MeshInput3> read = read_off(out.str(), {.kind = mesh.kind});
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(fingerprint({{*read}, false}), fingerprint({{mesh}, false}));
    }
}

TEST_P(EveryFamily3, IsValidAtAHundredOrSo) {
    std::vector<std::uint64_t> sizes;
    for (const families::FamilyParameter& p : GetParam().parameters) {
        const std::uint64_t size = GetParam().parameters.size() == 1 ? 100 : 8;
        sizes.push_back(
            std::clamp<std::uint64_t>(p.name == "LEVELS" ? 4 : size, p.least, p.greatest));
    }
    expect_valid(generate(sizes, 5), "size " + std::to_string(sizes.empty() ? 0 : sizes.front()));
}

TEST(WriteOff, NumbersAllMeshesThroughAndTellsAWorld) {
    const SceneInput3 room = families::room_with_furniture({.polygons = 12}, 1);
    std::ostringstream out;
    write_off(out, room);
    const Result<MeshInput3> read = read_off(out.str());
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->faces.size(), 12U);
    EXPECT_EQ(read->vertices[8], room.meshes[1].vertices[0]);
    EXPECT_EQ(read->faces[6][0], room.meshes[1].faces[0][0] + 8);
    EXPECT_THAT(out.str(), HasSubstr("OFF\n# world: the first 6 faces bound the free world\n"));
}

TEST(WriteOff, KeepsEveryDouble) {
    MeshInput3 mesh;
    mesh.vertices = {{0.1, 1e300, -5e-324}, {1.0 / 3, 0x1.fffffffffffffp1023, 1}, {-0.0, 2, 1e22}};
    mesh.faces = {{0, 1, 2}};
    std::ostringstream out;
    write_off(out, {{mesh}, false});
    const Result<MeshInput3> read = read_off(out.str());
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(fingerprint({{*read}, false}), fingerprint({{mesh}, false}));
}

TEST_P(EveryFamily3, HasPrintableInfoAndDefaultsInRange) {
    const families::FamilyInfo3& family = GetParam();
    EXPECT_FALSE(family.description.empty());
    EXPECT_EQ(family.description.find('\n'), std::string_view::npos);
    for (const families::FamilyParameter& p : family.parameters) {
        EXPECT_LE(p.least, p.default_value);
        EXPECT_LE(p.default_value, p.greatest);
    }
}

/// Families whose coordinates are no whole numbers below 2^27.
bool is_fractional(std::string_view name) {
    return name.starts_with("near-") || name.starts_with("double-root-") || name == "grid3-near" ||
           name == "denormal3" || name == "tiny3" || name == "huge3";
}

TEST_P(EveryFamily3, HasWholeCoordinatesUnlessItSaysOtherwise) {
    const SceneInput3 scene = generate(defaults(), 11);
    bool whole = true;
    for (const MeshInput3& mesh : scene.meshes) {
        for (const Point3& p : mesh.vertices) {
            for (const double c : {p.x, p.y, p.z})
                whole = whole && std::floor(c) == c && std::abs(c) < 0x1p27;
        }
    }
    EXPECT_EQ(whole, !is_fractional(GetParam().name));
}

/// Bytes pinned once: they must be the same on other platforms and in later versions.
const std::map<std::string_view, std::uint64_t>& pinned_fingerprints() {
    static const std::map<std::string_view, std::uint64_t> pinned{
        {"boxes", 0x6eef45c8eeb22af9ULL},
        {"boxes-turned", 0x797cd01e4eb52a34ULL},
        {"building", 0x8bc801f5df57239cULL},
        {"building-walls", 0x0570432fcee0eafaULL},
        {"chain3", 0xa476eef37026ab1dULL},
        {"checkerboard3", 0x60ac6c82fa8152f5ULL},
        {"city3", 0x203b16b86adc5a92ULL},
        {"collinear3", 0x7d6d14712659b5e1ULL},
        {"comb3", 0xed04a46f923874e5ULL},
        {"concurrent", 0x9592f99484ae781fULL},
        {"coplanar", 0x067bbf928455f5c8ULL},
        {"cube", 0x59bd4f842194e64dULL},
        {"cubes-round-vertex", 0x0a79ecd52b89cec5ULL},
        {"cylinder", 0x98f86e7db4587cb9ULL},
        {"denormal3", 0x6d5c04d050f88ae3ULL},
        {"dodecahedron", 0x48bb93603c8300b1ULL},
        {"double-root", 0xd1699e62815f388fULL},
        {"double-root-missed", 0x57504c55dcd3278eULL},
        {"double-root-split", 0x4873622fd917ae1aULL},
        {"far3", 0x311a0816bfac5655ULL},
        {"furniture", 0x0a64d84bf2f75a20ULL},
        {"grid3", 0xe42cb9aafcd74d1dULL},
        {"grid3-near", 0x07193602cd3f7b69ULL},
        {"grid3-packed", 0x2bae27e469782c9dULL},
        {"grid3-perturbed", 0xb8f47da392ee4e82ULL},
        {"grid3-rotated", 0xac920f7e645fbc41ULL},
        {"grid3-turned", 0x9370dc2b08b39e64ULL},
        {"huge3", 0x6fe244e6919aba5dULL},
        {"icosahedron", 0xefbb3004a3340429ULL},
        {"icosphere", 0x6c78864c14b4e593ULL},
        {"l-shape", 0x3f6528278fb3aec9ULL},
        {"l-shapes", 0xa34fb1e3f497512fULL},
        {"near-collinear3", 0xffc77d103b9c5ff1ULL},
        {"near-concurrent", 0x07d82808deab721dULL},
        {"near-coplanar", 0x82b21a009c9bdcddULL},
        {"near-regulus", 0xe4af9ccc71c9a91dULL},
        {"near-vertices-in-plane", 0x70b79854f2540a60ULL},
        {"needles3", 0x03c934295e25a068ULL},
        {"notched-cube", 0x2d6a637d6f2c9becULL},
        {"octahedron", 0x3b83f7727fd3d723ULL},
        {"polytopes", 0x2b2c034fcacb768fULL},
        {"prism", 0x913d366e92f83109ULL},
        {"pyramid", 0xb9164b40fb2147e2ULL},
        {"regulus", 0xde50f9ff17504b45ULL},
        {"ring", 0xae171ed9e053c8b5ULL},
        {"room", 0x22d1ad848fe19db1ULL},
        {"stack", 0xdf92d151db6d7fbdULL},
        {"terrain", 0x0d6c3c4032db2910ULL},
        {"terrain-solid", 0xdc3807893cbda191ULL},
        {"tetrahedra", 0x9e743c563ce61c7dULL},
        {"tetrahedron", 0x863b4a5c2e87a141ULL},
        {"tiny3", 0x1eb0a78423a791a3ULL},
        {"torus", 0x976ee7ab9ebf84b5ULL},
        {"touching-box-on-table", 0xe9502927a1fdaf35ULL},
        {"touching-edge", 0xc28ea9fb6f284f95ULL},
        {"touching-edge-crossing", 0xcb13ce7db901a50cULL},
        {"touching-edge-on-face", 0x45a564db8fafecb7ULL},
        {"touching-face", 0x207b432ca4204315ULL},
        {"touching-partial-edge", 0x7f2017209df50d55ULL},
        {"touching-partial-face", 0x78a7cf6a29484665ULL},
        {"touching-vertex", 0x48c16e648ade1015ULL},
        {"touching-vertex-on-edge", 0x15555e7862683cd4ULL},
        {"touching-vertex-on-face", 0x9b12e88e1d6e7eccULL},
        {"triangles", 0x12a092383be7a664ULL},
        {"two-boxes-triangle", 0xd0ae0c3e15a2db55ULL},
        {"u-shape", 0xa582d7c4ca41a685ULL},
        {"vertices-in-plane", 0x4324a60198897a17ULL},
    };
    return pinned;
}

TEST_P(EveryFamily3, GivesThePinnedBytesForSeed42) {
    const auto pinned = pinned_fingerprints().find(GetParam().name);
    ASSERT_NE(pinned, pinned_fingerprints().end()) << "no fingerprint of " << GetParam().name;
    EXPECT_EQ(fingerprint(generate(defaults(), 42)), pinned->second) << GetParam().name;
}

TEST(Family3Registry, IsWhatTheDocumentationLists) {
    std::ifstream page(SIGHTLINE_TESTS_DIR "/../docs/structures/families.md");
    std::vector<std::string> rows;
    bool in_section = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("##")) in_section = line == "## Families of 3D scenes";
        if (!in_section || !line.starts_with("| `")) continue;
        std::size_t end = 0;  // of the third column
        for (int column = 0; column < 3; ++column) end = line.find('|', end + 1);
        rows.push_back(line.substr(0, end));
    }
    std::vector<std::string> expected;
    for (const families::FamilyInfo3& family : families::all3()) {
        std::string row = "| `" + std::string(family.name) + "` |";
        for (const families::FamilyParameter& p : family.parameters)
            row += " " + std::string(p.name);
        expected.push_back(row + " | " + (family.degenerate ? "yes " : "no "));
    }
    EXPECT_EQ(rows, expected);
}

TEST(Family3Registry, IsSortedAndItsNamesAreNotThoseOf2D) {
    EXPECT_TRUE(std::is_sorted(families::all3().begin(), families::all3().end(),
                               [](const auto& a, const auto& b) { return a.name < b.name; }));
    for (const auto& solid : families::all3()) {
        for (const auto& flat : families::all2()) EXPECT_NE(solid.name, flat.name);
    }
}

TEST(Family3Registry, GeneratesByNameWithDefaultsOrParameters) {
    const Result<SceneInput3> by_default = families::generate3("tetrahedra", {}, 3);
    ASSERT_TRUE(by_default);
    EXPECT_EQ(fingerprint(*by_default), fingerprint(families::random_tetrahedra({}, 3)));
    EXPECT_EQ(by_default->meshes.front().file, "tetrahedra");
    const std::vector<std::string> sizes{"2", "3", "4"};
    const Result<SceneInput3> sized = families::generate3("grid3", sizes, 3);
    ASSERT_TRUE(sized);
    EXPECT_EQ(families_test::counts_of(*sized).faces, 2U * 3U * 4U * 6U);
}

TEST(Family3Registry, RefusesUnknownNamesAndBadParameters) {
    const auto message = [](const char* name, std::vector<std::string> parameters) {
        const Result<SceneInput3> scene = families::generate3(name, parameters, 1);
        return scene ? "accepted" : scene.error().message;
    };
    EXPECT_THAT(message("tetraedra", {}), HasSubstr("no family 'tetraedra'; the nearest are"));
    EXPECT_THAT(message("tetraedra", {}), HasSubstr("tetrahedra"));
    EXPECT_EQ(message("grid3", {"0"}),
              "generate grid3: COLUMNS is '0'; give a whole number from 1 to 100");
    EXPECT_THAT(message("cube", {"1"}), HasSubstr("leave out all after the first 0"));
}

}  // namespace
}  // namespace sightline
