// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "sightline/scene/result.hpp"
#include "sightline/spatial/bvh.hpp"

namespace sightline {
namespace {

using testing::ElementsAreArray;

/// Boxes on a coarse grid (many equal coordinates), or with coordinates of all magnitudes.
std::vector<Box3> arbitrary_boxes(std::uint64_t seed, std::size_t n, bool wild) {
    std::mt19937_64 random(seed);
    const auto number = [&] {
        if (wild)
            return std::ldexp(random() % 2 == 0 ? 1.0 : -1.0,
                              static_cast<int>(random() % 2000) - 1000);
        return static_cast<double>(random() % 20);
    };
    std::vector<Box3> boxes;
    for (std::size_t i = 0; i < n; ++i) {
        boxes.push_back(Box3::of({number(), number(), number()}, {number(), number(), number()}));
    }
    return boxes;
}

std::vector<std::uint32_t> found(const Bvh& bvh, const std::vector<Box3>& boxes,
                                 const Box3& query) {
    std::vector<std::uint32_t> hits;
    bvh.traverse([&](const Box3& b) { return b.meets(query); },
                 [&](std::uint32_t i) {
                     if (boxes[i].meets(query)) hits.push_back(i);
                 });
    std::sort(hits.begin(), hits.end());
    return hits;
}

std::vector<std::uint32_t> expected(const std::vector<Box3>& boxes, const Box3& query) {
    std::vector<std::uint32_t> hits;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].meets(query)) hits.push_back(i);
    }
    return hits;
}

// The laws of the tree: returns where the subtree's nodes end.
std::uint32_t check_subtree(const Bvh& bvh, std::uint32_t at, std::uint32_t depth,
                            std::vector<Box3>& leaves) {
    const Bvh::Node& node = bvh.nodes()[at];
    RC_ASSERT(depth < Bvh::max_depth);
    if (node.count > 0) {
        RC_ASSERT(node.count <= Bvh::leaf_size);
        for (std::uint32_t i = node.next; i < node.next + node.count; ++i) {
            leaves[bvh.order()[i]] = node.box;
        }
        return at + 1;
    }
    RC_ASSERT(node.box.contains(bvh.nodes()[at + 1].box));
    RC_ASSERT(node.box.contains(bvh.nodes()[node.next].box));
    RC_ASSERT(check_subtree(bvh, at + 1, depth + 1, leaves) == node.next);
    return check_subtree(bvh, node.next, depth + 1, leaves);
}

std::uint32_t depth_of(const Bvh& bvh, std::uint32_t at = 0) {
    const Bvh::Node& node = bvh.nodes()[at];
    return node.count > 0 ? 1 : 1 + std::max(depth_of(bvh, at + 1), depth_of(bvh, node.next));
}

RC_GTEST_PROP(BvhLaw, NodesContainTheirChildrenAndEachPrimitiveOnce, (bool wild)) {
    const auto n = *rc::gen::inRange<std::size_t>(1, 400);
    const auto boxes = arbitrary_boxes(*rc::gen::arbitrary<std::uint64_t>(), n, wild);
    const Bvh bvh(boxes);
    std::vector<Box3> leaves(n);
    RC_ASSERT(check_subtree(bvh, 0, 0, leaves) == bvh.nodes().size());
    for (std::size_t i = 0; i < n; ++i) {
        RC_ASSERT(!leaves[i].is_empty());
        RC_ASSERT(leaves[i].contains(boxes[i]));
    }
    RC_ASSERT(bvh.order().size() == n);
}

RC_GTEST_PROP(BvhLaw, TraversalFindsWhatASearchThroughAllFinds, (bool wild)) {
    const auto n = *rc::gen::inRange<std::size_t>(0, 400);
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto boxes = arbitrary_boxes(seed, n, wild);
    const Bvh bvh(boxes);
    for (const Box3& query : arbitrary_boxes(seed + 1, 10, wild)) {
        RC_ASSERT(found(bvh, boxes, query) == expected(boxes, query));
    }
}

RC_GTEST_PROP(BvhLaw, OrderedTraversalFindsTheNearestAndAllTies, ()) {
    const auto n = *rc::gen::inRange<std::size_t>(1, 400);
    const auto boxes = arbitrary_boxes(*rc::gen::arbitrary<std::uint64_t>(), n, false);
    const Bvh bvh(boxes);
    const auto height = [](const Box3& box) { return box.low[2]; };
    double best = Box3::infinite;
    std::vector<std::uint32_t> nearest;
    bvh.traverse_ordered(height, [&](std::uint32_t i) {
        if (height(boxes[i]) < best) nearest.clear();
        best = std::min(best, height(boxes[i]));
        if (height(boxes[i]) == best) nearest.push_back(i);
        return best;
    });
    std::sort(nearest.begin(), nearest.end());
    double lowest = Box3::infinite;
    for (const Box3& b : boxes) lowest = std::min(lowest, height(b));
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < n; ++i) {
        if (height(boxes[i]) == lowest) all.push_back(i);
    }
    RC_ASSERT(nearest == all);
}

TEST(Bvh, LooksAtFewPrimitivesOfALongRow) {
    std::vector<Box3> row;
    for (int i = 0; i < 1024; ++i) {
        const double x = i * 2;
        row.push_back(Box3::of({x, 0, 0}, {x + 1, 1, 1}));
    }
    const Bvh bvh(row);
    int visited = 0;
    const Box3 query = Box3::of({1000, 0, 0});
    bvh.traverse([&](const Box3& b) { return b.meets(query); }, [&](std::uint32_t) { ++visited; });
    EXPECT_GE(visited, 1);
    EXPECT_LE(visited, 4);

    int asked = 0;
    bvh.traverse_ordered(
        [&](const Box3& b) {
            ++asked;
            return b.low[0];
        },
        [](std::uint32_t) { return -Box3::infinite; });
    EXPECT_LE(asked, 2 * 12 + 1) << "one path down";
}

TEST(Bvh, ALeafThatReturnsFalseEndsTheTraversal) {
    const auto boxes = arbitrary_boxes(1, 100, false);
    const Bvh bvh(boxes);
    int visited = 0;
    EXPECT_FALSE(bvh.traverse([](const Box3&) { return true; },
                              [&](std::uint32_t) { return ++visited < 5; }));
    EXPECT_EQ(visited, 5);
    EXPECT_TRUE(
        bvh.traverse([](const Box3&) { return true; }, [&](std::uint32_t) { return true; }));
}

TEST(BvhDegenerate, EqualBoxesAreHalved) {
    const std::vector<Box3> boxes(1000, Box3::of({1, 1, 1}));
    const Bvh bvh(boxes);
    EXPECT_EQ(found(bvh, boxes, Box3::of({1, 1, 1})).size(), 1000U);
    EXPECT_TRUE(found(bvh, boxes, Box3::of({1, 1, 2})).empty());
}

TEST(BvhDegenerate, SizesThatDoubleDoNotMakeItDeep) {
    std::vector<Box3> boxes;
    for (int i = -1000; i < 1000; ++i) {
        boxes.push_back(
            Box3::of({0, 0, 0}, {std::ldexp(1, i), std::ldexp(1, i), std::ldexp(1, i)}));
    }
    const Bvh bvh(boxes);
    EXPECT_LE(depth_of(bvh), 45U) << "30 uneven levels, and what halves take for the rest";
    const Box3 query = Box3::of({std::ldexp(1, 990), 1, 1});
    EXPECT_THAT(found(bvh, boxes, query), ElementsAreArray(expected(boxes, query)));
}

TEST(BvhDegenerate, NothingHasNoNodes) {
    const Bvh bvh(std::span<const Box3>{});
    EXPECT_TRUE(bvh.is_empty());
    EXPECT_TRUE(bvh.bounds().is_empty());
    EXPECT_TRUE(
        bvh.traverse([](const Box3&) { return true; }, [](std::uint32_t) { return false; }));
}

TEST(Bvh, RefusesBoxesThatAreEmptyOrInfinite) {
    const std::vector<Box3> empty(1);
    EXPECT_THROW(Bvh{empty}, ContractViolation);
    const std::vector<Box3> endless{{{0, 0, 0}, {1, 1, Box3::infinite}}};
    EXPECT_THROW(Bvh{endless}, ContractViolation);
}

}  // namespace
}  // namespace sightline
