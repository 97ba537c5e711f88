// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/skeleton/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "sightline/skeleton/build.hpp"
#include "support/corpus3.hpp"

namespace sightline {
namespace {

SkeletonCheck checked(const Scene3& scene, const VisibilitySkeleton& skeleton,
                      std::size_t families) {
    const auto check = check_skeleton(scene, skeleton, {.families = families});
    EXPECT_TRUE(check.has_value());
    return check.value();
}

/// The skeleton with other arcs.
VisibilitySkeleton with_arcs(const VisibilitySkeleton& skeleton, std::vector<SkeletonArc> arcs) {
    return VisibilitySkeleton({skeleton.nodes().begin(), skeleton.nodes().end()}, std::move(arcs));
}

std::vector<SkeletonArc> arcs_of(const VisibilitySkeleton& skeleton) {
    return {skeleton.arcs().begin(), skeleton.arcs().end()};
}

class SkeletonsOfEveryKind : public ::testing::TestWithParam<const char*> {};

TEST_P(SkeletonsOfEveryKind, PassWithArcsCrossedOnPurpose) {
    const Scene3 scene = testing::scene3(GetParam());
    const auto skeleton = visibility_skeleton(scene);
    const std::size_t crossed = std::min<std::size_t>(skeleton.arcs().size(), 150);
    const SkeletonCheck check = checked(scene, skeleton, 2 * crossed);
    EXPECT_TRUE(check.passes()) << check << "\n"
                                << (check.mismatches.empty() ? "" : check.mismatches.front());
    EXPECT_GE(check.crossings, crossed) << check;
    EXPECT_EQ(check.mismatches.size(), 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Families, SkeletonsOfEveryKind,
    ::testing::Values("family tetrahedron", "family cube", "family notched-cube", "family ring",
                      "family l-shape", "family tetrahedra 3", "family boxes 3",
                      "family boxes-turned 2", "family triangles 4", "family polytopes 2 12",
                      "family needles3 3", "family touching-box-on-table", "family touching-edge",
                      "family touching-face", "family touching-partial-face",
                      "family cubes-round-vertex 5", "family touching-vertex-on-edge",
                      "family touching-edge-crossing",
                      "sheet 0 0 0, 4 0 0, 0 4 0; sheet 0 0 3, 4 0 3, 0 4 3",
                      "box 0 0 0, 1 1 1; box 2 0 0, 3 1 1; box 4 0 0, 5 1 1",
                      "world; box 0 0 0, 8 8 8; box 2 3 0, 5 5 4"));

TEST(SkeletonCheck, NoticesAnyMissingArc) {
    const Scene3 scene = testing::scene3("family tetrahedra 2");
    const auto skeleton = visibility_skeleton(scene);
    for (std::size_t missing = 0; missing < skeleton.arcs().size(); missing += 41) {
        auto arcs = arcs_of(skeleton);
        arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(missing));
        // Nothing aims at an arc that is not there: only paths by chance cross it.
        const SkeletonCheck check = checked(scene, with_arcs(skeleton, std::move(arcs)), 4000);
        EXPECT_GT(check.missing, 0u) << skeleton.arcs()[missing].label;
        EXPECT_EQ(check.false_arcs, 0u);
        EXPECT_FALSE(check.passes());
        EXPECT_EQ(check.mismatches.front().substr(0, 8), "missing:");
    }
}

TEST(SkeletonCheck, NoticesAFalseArcWithAnotherLabel) {
    const Scene3 scene = testing::scene3("family tetrahedra 2");
    const auto skeleton = visibility_skeleton(scene);
    for (std::size_t i = 0; i < skeleton.arcs().size(); i += 41) {
        auto arcs = arcs_of(skeleton);
        // The same lines, said to end at a face where they are free.
        SkeletonArc copy = arcs[i];
        copy.label.ends[1] = {{FaceId{0}, false}};
        if (copy.label == arcs[i].label) continue;
        std::ranges::sort(copy.label.ends);
        arcs.push_back(copy);
        const SkeletonCheck check = checked(scene, with_arcs(skeleton, arcs), 2 * arcs.size());
        EXPECT_GT(check.false_arcs, 0u) << copy.label;
        EXPECT_EQ(check.missing, 0u);
    }
}

TEST(SkeletonCheck, NoticesAnArcThatGoesOnTooFar) {
    // Two arcs of one pencil with a node between: joined, they claim to pass it.
    const Scene3 scene = testing::scene3("family tetrahedra 2");
    const auto skeleton = visibility_skeleton(scene);
    std::size_t tried = 0;
    for (std::uint32_t n = 0; n < skeleton.nodes().size() && tried < 3; ++n) {
        for (const ArcId a : skeleton.arcs_at(NodeId{n})) {
            for (const ArcId b : skeleton.arcs_at(NodeId{n})) {
                const SkeletonArc& x = skeleton[a];
                const SkeletonArc& y = skeleton[b];
                const auto& v = x.label.support.vertices;
                if (b <= a || v.empty() || v != y.label.support.vertices) continue;
                if (x.label.support.edges != y.label.support.edges) continue;
                if (x.label == y.label) continue;  // the pencil goes on through such nodes
                auto arcs = arcs_of(skeleton);
                const auto far = [&](const SkeletonArc& arc) {
                    return arc.nodes[0] == NodeId{n} ? arc.nodes[1] : arc.nodes[0];
                };
                std::erase(arcs, x);
                arcs.push_back({x.type, x.label, {far(x), far(y)}});
                const auto check = checked(scene, with_arcs(skeleton, arcs), 2 * arcs.size());
                EXPECT_GT(check.false_arcs, 0u) << x.label;
                ++tried;
            }
        }
    }
    EXPECT_GT(tried, 0u);
}

TEST(SkeletonCheck, StopsWhenAskedTo) {
    const Scene3 scene = testing::scene3("family cube");
    Limits limits;
    limits.stop = [] { return true; };
    const auto check = check_skeleton(scene, visibility_skeleton(scene), {}, limits);
    ASSERT_FALSE(check.has_value());
    EXPECT_EQ(check.error().code, Errc::cancelled);
}

TEST(SkeletonCheck, IsAFunctionOfTheSeed) {
    const Scene3 scene = testing::scene3("family tetrahedra 2");
    const auto skeleton = visibility_skeleton(scene);
    const auto text = [&](std::uint64_t seed) {
        std::ostringstream out;
        const auto check = check_skeleton(scene, skeleton, {.seed = seed, .families = 40});
        out << check.value() << ' ' << check->shots;
        return out.str();
    };
    EXPECT_EQ(text(1), text(1));
    EXPECT_NE(text(1), text(2));
}

}  // namespace
}  // namespace sightline
