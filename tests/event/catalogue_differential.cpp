// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue against visibility skeletons: every node lies where its support says, and every arc that leaves
// it in one of the families that the catalogue lists there.
#include <gmock/gmock.h>

#include <algorithm>
#include <optional>

#include "sightline/event/catalogue.hpp"
#include "sightline/skeleton/build.hpp"
#include "support/scenes3.hpp"

namespace sightline {
namespace {

/// The node's line, among those of its support and faces.
std::optional<SurdLine3> line_of(const SkeletonNode& node, const Scene3& scene) {
    const auto lines = lines_of(node.label.support, node.faces, scene);
    const std::size_t index = node.root == Root::second ? 1 : 0;
    if (index < lines.size()) return lines[index];
    return std::nullopt;
}

class EveryScene : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryScene, ArcsLieInFamiliesOfTheirNodes) {
    const Scene3 scene = testing::scene3(GetParam());
    const VisibilitySkeleton skeleton = visibility_skeleton(scene);
    ASSERT_GT(skeleton.nodes().size(), 0u);
    std::size_t unlisted = 0;
    for (std::uint32_t n = 0; n < skeleton.nodes().size(); ++n) {
        const SkeletonNode& node = skeleton[NodeId{n}];
        const auto line = line_of(node, scene);
        ASSERT_TRUE(line) << name_of(node.type) << ' ' << node.label;
        for (const EdgeId e : node.label.support.along) {
            EXPECT_EQ(scaled(to_surd(carrier(e, scene))), *line);
        }
        const auto families = families_at(*line, node.label.support, scene);
        for (const ArcId a : skeleton.arcs_at(NodeId{n})) {
            auto own = families_keeping(skeleton[a].label.support, scene);
            std::erase_if(own, [&](const EventFamily& f) {
                return name_of(f.kind) != name_of(skeleton[a].type);
            });
            ASSERT_FALSE(own.empty()) << name_of(skeleton[a].type) << ' ' << skeleton[a].label;
            const bool is_listed = std::ranges::any_of(families, [&](const EventFamily& f) {
                return std::ranges::find(own, f.swath, &EventFamily::swath) != own.end();
            });
            if (!is_listed) ++unlisted;
        }
    }
    EXPECT_EQ(unlisted, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Catalogue, EveryScene,
    ::testing::Values("hull 0 0 0, 4 0 0, 0 4 0, 0 0 4", "box 0 0 0, 1 1 1",
                      "box 0 0 0, 2 2 2; box 1 -3 4, 3 7 5", "box 0 0 0, 4 4 1; box 1 1 1, 2 3 2",
                      "box 0 0 0, 1 1 1; box 2 0 0, 3 1 1; box 0 2 0, 1 3 1",
                      "hull 0 0 0, 4 1 0, 0 4 1, 1 0 4; hull 20 3 5, 25 2 6, 22 7 4, 21 3 11;"
                      "hull 10 10 20, 13 9 21, 9 14 20, 11 11 26",
                      "family two-boxes-triangle"));

}  // namespace
}  // namespace sightline
