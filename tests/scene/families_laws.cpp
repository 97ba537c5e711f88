// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every family: the scenes are valid, a seed fixes the bytes, sizes are as promised.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "scene/families_support.hpp"
#include "sightline/scene/families.hpp"

namespace sightline {
namespace {

using families_test::fingerprint;
using families_test::points_of;
using testing::ElementsAre;
using testing::HasSubstr;

class EveryFamily : public testing::TestWithParam<families::FamilyInfo> {
protected:
    static SceneInput2 generate(const std::vector<std::uint64_t>& sizes, std::uint64_t seed) {
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
        for (const families::FamilyParameter& p : GetParam().parameters) {
            sizes.push_back(std::min(p.least + more, p.greatest));
        }
        return sizes;
    }
    static void expect_valid(const std::vector<std::uint64_t>& sizes, std::uint64_t seed) {
        const SceneInput2 scene = generate(sizes, seed);
        const Result<Scene2> made = Scene2::make(scene);
        ASSERT_TRUE(made) << GetParam().name << " seed " << seed << ", first size " << sizes.front()
                          << ": " << made.error().message;
        EXPECT_EQ(made->vertex_count(), points_of(scene).size());
    }
};

INSTANTIATE_TEST_SUITE_P(All, EveryFamily,
                         testing::ValuesIn(families::all2().begin(), families::all2().end()),
                         [](const auto& family) {
                             std::string name(family.param.name);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_P(EveryFamily, IsValidAtItsSmallestSizes) {
    for (std::uint64_t more = 0; more < 12; ++more) {
        for (std::uint64_t seed = 0; seed < 25; ++seed) expect_valid(small(more), seed);
    }
}

TEST_P(EveryFamily, IsValidAtItsDefaultSizes) {
    for (std::uint64_t seed = 100; seed < 120; ++seed) expect_valid(defaults(), seed);
}

TEST_P(EveryFamily, IsValidAtAThousandOrSo) {
    std::vector<std::uint64_t> sizes;
    for (const families::FamilyParameter& p : GetParam().parameters) {
        sizes.push_back(
            std::min<std::uint64_t>(GetParam().parameters.size() == 1 ? 1000 : 30, p.greatest));
    }
    for (std::uint64_t seed = 7; seed < 9; ++seed) expect_valid(sizes, seed);
}

TEST_P(EveryFamily, GivesTheSameBytesForTheSameSeed) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        EXPECT_EQ(fingerprint(generate(defaults(), seed)), fingerprint(generate(defaults(), seed)));
    }
}

TEST_P(EveryFamily, HasPrintableInfoAndDefaultsInRange) {
    const families::FamilyInfo& family = GetParam();
    EXPECT_FALSE(family.description.empty());
    EXPECT_EQ(family.description.find('\n'), std::string_view::npos);
    ASSERT_FALSE(family.parameters.empty());
    for (const families::FamilyParameter& p : family.parameters) {
        EXPECT_LE(p.least, p.default_value);
        EXPECT_LE(p.default_value, p.greatest);
    }
}

/// Bytes pinned once: they must be the same on other platforms and in later versions.
const std::map<std::string_view, std::uint64_t>& pinned_fingerprints() {
    static const std::map<std::string_view, std::uint64_t> pinned{
        {"cave", 0xdaf2e65c5e3c722dULL},
        {"chain", 0x657bfde37f0b0445ULL},
        {"chain-corners", 0x6b26e2f7df360245ULL},
        {"chain-edges", 0x74cc680d7e766845ULL},
        {"chain-ring", 0xcef7c3cf3f431665ULL},
        {"checkerboard", 0x6beda04e199e97e1ULL},
        {"city", 0x3ebc3ef522df7e48ULL},
        {"collinear", 0x08b9aa98c1ada2cbULL},
        {"collinear-points", 0x170405e71f298294ULL},
        {"collinear-walls", 0x60b87f6882608d63ULL},
        {"comb", 0xce5d1f5dfad01b45ULL},
        {"comb-room", 0xab083ad117ed2244ULL},
        {"combs", 0x61cd384c36d0a645ULL},
        {"dense", 0xde9356a5ed5b7391ULL},
        {"dense-open", 0xaa80c460fb99942bULL},
        {"denormal", 0xabbc7c7453a40af9ULL},
        {"floor-plan", 0xf2b1a4d54628f8bcULL},
        {"floor-plan-thin", 0x5ae02d1de3acafc8ULL},
        {"grid", 0x8f023e5385234d21ULL},
        {"grid-rotated", 0x906cdfb45ede33beULL},
        {"grid-walls", 0xde871e2c7095fa85ULL},
        {"holes", 0xcc2f30e200e36b2bULL},
        {"huge", 0xd59a3c22c3e7457aULL},
        {"magnitudes", 0x17266ea982553ab0ULL},
        {"near-collinear", 0x450129077d33c805ULL},
        {"needles", 0xf169d98281ca686dULL},
        {"packed", 0x9428ba3ef266bd10ULL},
        {"packed-open", 0x43befc2b1aa290feULL},
        {"pinched", 0xacfcd582eba26790ULL},
        {"pinched-room", 0xa174aceecc9be6e1ULL},
        {"pinwheel", 0x1b4d8837edae8206ULL},
        {"pinwheel-tiles", 0x2c925bacd5b0ad91ULL},
        {"polygons", 0x8167dee18a4ed4bcULL},
        {"simple", 0x95d6e8cafc3eb7d7ULL},
        {"simple-room", 0x5d286d9beb248b4aULL},
        {"slivers", 0xe0c4b8dccef3db6dULL},
        {"sparse", 0x99d2ab580a7fa979ULL},
        {"sparse-open", 0x2c949b70af7447a7ULL},
        {"spiral", 0xefb4969a494ab841ULL},
        {"spiral-room", 0xfe25ba356e61a160ULL},
        {"star", 0xf5953e1778207669ULL},
        {"star-room", 0x85f464a2faee4d18ULL},
        {"star-shaped", 0xa13c5fdb6e27dc77ULL},
        {"star-shaped-room", 0xcef20c50e058ce2aULL},
        {"tiny", 0x9feae7c5afe1bc41ULL},
        {"walls", 0xf8e9c30606f3add1ULL},
        {"walls-crossing", 0xf642f2280dee6087ULL},
    };
    return pinned;
}

TEST_P(EveryFamily, GivesThePinnedBytesForSeed42) {
    const auto pinned = pinned_fingerprints().find(GetParam().name);
    ASSERT_NE(pinned, pinned_fingerprints().end()) << "no fingerprint of " << GetParam().name;
    EXPECT_EQ(fingerprint(generate(defaults(), 42)), pinned->second) << GetParam().name;
}

TEST(FamilyRegistry, IsSortedByName) {
    EXPECT_TRUE(std::is_sorted(families::all2().begin(), families::all2().end(),
                               [](const auto& a, const auto& b) { return a.name < b.name; }));
}

TEST(FamilyRegistry, IsWhatTheDocumentationLists) {
    std::ifstream page(SIGHTLINE_TESTS_DIR "/../docs/structures/families.md");
    std::vector<std::string> rows;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("| `")) {
            rows.push_back(
                line.substr(0, line.find('|', line.find(" | ", line.find(" | ") + 3) + 3)));
        }
    }
    std::vector<std::string> expected;
    for (const families::FamilyInfo& family : families::all2()) {
        std::string row = "| `" + std::string(family.name) + "` |";
        for (const families::FamilyParameter& p : family.parameters)
            row += " " + std::string(p.name);
        expected.push_back(row + " | " + (family.degenerate ? "yes " : "no "));
    }
    rows.resize(std::min(rows.size(), expected.size()));  // the table of transforms follows
    EXPECT_EQ(rows, expected);
}

TEST(FamilyRegistry, GeneratesByNameWithDefaultsOrParameters) {
    const Result<SceneInput2> by_default = families::generate2("dense", {}, 3);
    ASSERT_TRUE(by_default);
    EXPECT_EQ(points_of(*by_default).size(), 1004U);
    const std::vector<std::string> sizes{"77"};
    const Result<SceneInput2> sized = families::generate2("dense", sizes, 3);
    ASSERT_TRUE(sized);
    EXPECT_EQ(fingerprint(*sized), fingerprint(families::random_convex({.vertices = 77}, 3)));
}

TEST(FamilyRegistry, NamesTheNearestFamiliesForAnUnknownName) {
    const Result<SceneInput2> misspelt = families::generate2("dens", {}, 1);
    ASSERT_FALSE(misspelt);
    EXPECT_EQ(misspelt.error().code, Errc::bad_parameter);
    EXPECT_THAT(misspelt.error().message, HasSubstr("'dens'"));
    EXPECT_THAT(misspelt.error().message, HasSubstr("dense, "));
    EXPECT_THAT(families::generate2("gird", {}, 1).error().message, HasSubstr("grid"));
    EXPECT_THAT(families::generate2("rotated", {}, 1).error().message, HasSubstr("grid-rotated"));
    EXPECT_THAT(families::generate2("", {}, 1).error().message, HasSubstr("no family ''"));
}

TEST(FamilyRegistry, RefusesBadParameters) {
    const auto message = [](std::vector<std::string> parameters) {
        const Result<SceneInput2> scene = families::generate2("grid", parameters, 1);
        return scene ? "accepted" : scene.error().message;
    };
    EXPECT_EQ(message({"3", "4"}), "accepted");
    for (const char* bad : {"abc", "", "-1", "0", "1001", "3.5", "99999999999999999999", "3 "}) {
        EXPECT_THAT(message({bad}), HasSubstr("whole number from 1 to 1000")) << bad;
    }
    EXPECT_THAT(message({"1", "2", "3"}), HasSubstr("leave out all after the first 2"));
}

}  // namespace
}  // namespace sightline
