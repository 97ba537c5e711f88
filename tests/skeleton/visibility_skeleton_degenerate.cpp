// SPDX-License-Identifier: GPL-3.0-or-later
// Every named degenerate scene against the definition by brute force.
#include <gtest/gtest.h>

#include "sightline/skeleton/build.hpp"
#include "support/corpus3.hpp"
#include "support/skeleton_laws.hpp"

namespace sightline {
namespace {

class DegenerateSkeleton : public ::testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] static Scene3 scene() { return testing::degenerate_scene3(GetParam()); }
};

/// Larger ones take brute force minutes.
std::vector<std::string> small_scenes() {
    std::vector<std::string> names;
    for (const auto& [name, text] : testing::degenerate_scenes3()) {
        if (testing::scene3(text).edges().size() <= 36) names.push_back(name);
    }
    return names;
}

TEST_P(DegenerateSkeleton, EqualsTheReference) {
    EXPECT_TRUE(testing::equals_reference(
        scene(), [](const Scene3& scene) { return visibility_skeleton(scene); }));
}

TEST_P(DegenerateSkeleton, IsCanonical) { testing::expect_canonical(visibility_skeleton(scene())); }

INSTANTIATE_TEST_SUITE_P(Corpus, DegenerateSkeleton, ::testing::ValuesIn(small_scenes()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace sightline
