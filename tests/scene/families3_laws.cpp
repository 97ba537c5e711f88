// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every family of 3D scenes: surfaces are closed, planar and turned outwards, a seed fixes the bytes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "scene/families3_support.hpp"
#include "sightline/scene/families3.hpp"

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

TEST_P(EveryFamily3, HasPrintableInfoAndDefaultsInRange) {
    const families::FamilyInfo3& family = GetParam();
    EXPECT_FALSE(family.description.empty());
    EXPECT_EQ(family.description.find('\n'), std::string_view::npos);
    for (const families::FamilyParameter& p : family.parameters) {
        EXPECT_LE(p.least, p.default_value);
        EXPECT_LE(p.default_value, p.greatest);
    }
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
