// SPDX-License-Identifier: GPL-3.0-or-later
// What any visibility skeleton must satisfy, whatever computed it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "sightline/reference/visibility_skeleton.hpp"
#include "sightline/scene/transform3.hpp"
#include "support/scenes3.hpp"

namespace sightline::testing {

using SkeletonFunction = std::function<VisibilitySkeleton(const Scene3& scene)>;

/// "VEE v1 e2 e7 | inf | f3", with "#1" or "#2" for one of two roots.
inline std::string to_string(const SkeletonNode& node) {
    std::ostringstream out;
    out << name_of(node.type) << ' ' << node.label;
    if (node.root != Root::only) out << (node.root == Root::first ? " #1" : " #2");
    for (const FaceId f : node.faces) out << " in " << to_string(f);
    return out.str();
}

/// The arc and, in brackets, its nodes.
inline std::string to_string(const VisibilitySkeleton& skeleton, const SkeletonArc& arc) {
    std::ostringstream out;
    out << name_of(arc.type) << ' ' << arc.label << " [" << to_string(skeleton[arc.nodes[0]])
        << "] [" << to_string(skeleton[arc.nodes[1]]) << ']';
    return out.str();
}

/// One line a node, then one line an arc; sorted.
inline std::vector<std::string> lines_of(const VisibilitySkeleton& skeleton) {
    std::vector<std::string> lines;
    for (const SkeletonNode& n : skeleton.nodes()) lines.push_back("node " + to_string(n));
    const auto node_count = static_cast<std::ptrdiff_t>(lines.size());
    for (const SkeletonArc& a : skeleton.arcs()) lines.push_back("arc " + to_string(skeleton, a));
    std::sort(lines.begin(), lines.begin() + node_count);
    std::sort(lines.begin() + node_count, lines.end());
    return lines;
}

/// The first nodes, or else arcs, that one skeleton has and the other not; empty when there are none.
inline std::string difference(const VisibilitySkeleton& actual, const VisibilitySkeleton& expected,
                              std::size_t at_most = 4) {
    if (actual == expected) return "";
    const auto in_actual = lines_of(actual);
    const auto in_expected = lines_of(expected);
    std::ostringstream out;
    const auto report = [&](const char* what, const auto& some, const auto& others,
                            const char* kind) {
        std::multiset<std::string> left(others.begin(), others.end());
        std::size_t count = 0;
        for (const std::string& line : some) {
            if (!line.starts_with(kind)) continue;
            const auto known = left.find(line);
            if (known != left.end()) {
                left.erase(known);
            } else if (++count <= at_most) {
                out << what << line << '\n';
            }
        }
        if (count > at_most) out << "  … " << count - at_most << " more\n";
        return count;
    };
    for (const char* kind : {"node", "arc"}) {
        const std::size_t missed = report("missed: ", in_expected, in_actual, kind);
        if (missed + report("false:  ", in_actual, in_expected, kind) > 0) return out.str();
    }
    return "equal as text, but not as values";
}

inline ::testing::AssertionResult same_skeleton(const VisibilitySkeleton& actual,
                                                const VisibilitySkeleton& expected) {
    const std::string text = difference(actual, expected);
    if (text.empty()) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << text;
}

/// (1) It equals the reference: the definition, by brute force.
inline ::testing::AssertionResult equals_reference(const Scene3& scene,
                                                   const SkeletonFunction& build) {
    return same_skeleton(build(scene), reference::visibility_skeleton(scene));
}

/// (2) Nodes and arcs are sorted and distinct; arcs end at nodes, and nodes know their arcs.
inline void expect_canonical(const VisibilitySkeleton& skeleton) {
    const auto nodes = skeleton.nodes();
    const auto arcs = skeleton.arcs();
    EXPECT_EQ(std::ranges::adjacent_find(nodes, std::greater_equal<>{}), nodes.end());
    EXPECT_EQ(std::ranges::adjacent_find(arcs, std::greater_equal<>{}), arcs.end());
    for (std::uint32_t a = 0; a < arcs.size(); ++a) {
        for (const NodeId n : arcs[a].nodes) {
            ASSERT_LT(n.index(), nodes.size());
            EXPECT_TRUE(std::ranges::binary_search(skeleton.arcs_at(n), ArcId{a}));
        }
    }
}

// ---- names ----------------------------------------------------------------------------------------

/// For each feature of one scene, the same of another.
struct Renaming {
    std::vector<VertexId> vertices;
    std::vector<EdgeId> edges;
    std::vector<FaceId> faces;
};

namespace names_detail {

inline std::vector<VertexId> vertices_of(const Face3& face,
                                         const std::vector<VertexId>* renamed = nullptr) {
    std::vector<VertexId> result;
    for (const auto& ring : face.rings) {
        for (const VertexId v : ring)
            result.push_back(renamed == nullptr ? v : (*renamed)[v.index()]);
    }
    std::ranges::sort(result);
    return result;
}

using EdgeKey = std::vector<std::vector<VertexId>>;

inline EdgeKey key_of(const Scene3& scene, const Edge3& edge,
                      const std::vector<VertexId>* renamed = nullptr) {
    std::vector<VertexId> ends;
    for (const VertexId v : {edge.source, edge.target})
        ends.push_back(renamed == nullptr ? v : (*renamed)[v.index()]);
    std::ranges::sort(ends);
    EdgeKey key;
    for (const FaceId f : edge.faces) {
        key.push_back(f.is_none() ? std::vector<VertexId>{} : vertices_of(scene[f], renamed));
    }
    std::ranges::sort(key);
    key.push_back(std::move(ends));
    return key;
}

}  // namespace names_detail

/// What the features of `from` are in `to`, when vertex v of `from` is vertex vertices[v] of `to`. Faces are
/// known by their vertices, edges by their vertices and faces. Throws std::out_of_range when one is missing.
inline Renaming renaming(const Scene3& from, const Scene3& to, std::vector<VertexId> vertices) {
    Renaming result{std::move(vertices), {}, {}};
    std::map<std::vector<VertexId>, FaceId> faces;
    for (std::uint32_t f = 0; f < to.faces().size(); ++f)
        faces[names_detail::vertices_of(to.faces()[f])] = FaceId{f};
    for (const Face3& f : from.faces())
        result.faces.push_back(faces.at(names_detail::vertices_of(f, &result.vertices)));
    std::map<names_detail::EdgeKey, EdgeId> edges;
    for (std::uint32_t e = 0; e < to.edges().size(); ++e)
        edges[names_detail::key_of(to, to.edges()[e])] = EdgeId{e};
    for (const Edge3& e : from.edges())
        result.edges.push_back(edges.at(names_detail::key_of(from, e, &result.vertices)));
    return result;
}

inline SegmentLabel renamed(SegmentLabel label, const Renaming& names) {
    for (VertexId& v : label.support.vertices) v = names.vertices[v.index()];
    for (auto* edges : {&label.support.edges, &label.support.along}) {
        for (EdgeId& e : *edges) e = names.edges[e.index()];
        std::ranges::sort(*edges);
    }
    std::ranges::sort(label.support.vertices);
    for (SegmentEnd& end : label.ends) {
        for (FaceSide& side : end) side.face = names.faces[side.face.index()];
        std::ranges::sort(end);
    }
    std::ranges::sort(label.ends);
    return label;
}

inline VisibilitySkeleton renamed(const VisibilitySkeleton& skeleton, const Renaming& names) {
    std::vector<SkeletonNode> nodes(skeleton.nodes().begin(), skeleton.nodes().end());
    std::vector<SkeletonArc> arcs(skeleton.arcs().begin(), skeleton.arcs().end());
    for (SkeletonNode& n : nodes) {
        n.label = renamed(std::move(n.label), names);
        for (FaceId& f : n.faces) f = names.faces[f.index()];
        std::ranges::sort(n.faces);
    }
    for (SkeletonArc& a : arcs) a.label = renamed(std::move(a.label), names);
    return {std::move(nodes), std::move(arcs)};
}

/// For comparisons across maps that do not keep the order of directions: two lines with one support become one.
inline VisibilitySkeleton without_roots(const VisibilitySkeleton& skeleton) {
    std::vector<SkeletonNode> nodes(skeleton.nodes().begin(), skeleton.nodes().end());
    for (SkeletonNode& n : nodes) n.root = Root::only;
    return {std::move(nodes), {skeleton.arcs().begin(), skeleton.arcs().end()}};
}

// ---- metamorphic laws -----------------------------------------------------------------------------

inline std::vector<VertexId> same_vertices(const Scene3& scene) {
    std::vector<VertexId> result;
    for (std::uint32_t v = 0; v < scene.vertices().size(); ++v) result.push_back(VertexId{v});
    return result;
}

/// (3) Translations, scalings by powers of two, mirror images, rotations and exchanges of axes change nothing but the
/// order of roots; nor does cutting faces into triangles.
inline void expect_motions_change_nothing(const SceneInput3& input, const SkeletonFunction& build) {
    const Scene3 scene = scene3(input);
    const VisibilitySkeleton skeleton = without_roots(build(scene));
    const auto expect_same = [&](const char* what, const SceneInput3& moved_input) {
        const Scene3 moved = scene3(moved_input);
        const auto names = renaming(moved, scene, same_vertices(moved));
        EXPECT_TRUE(same_skeleton(without_roots(renamed(build(moved), names)), skeleton)) << what;
    };
    if (const auto moved = families::translated3(input, 16, -8, 0.5)) {
        expect_same("translated", *moved);
    }
    if (const auto moved = families::scaled3(input, -5)) expect_same("scaled", *moved);
    if (const auto moved = families::rotated3(input, {2, -1, 3, 1})) expect_same("rotated", *moved);
    expect_same("mirrored", families::mirrored3(input));
    expect_same("axes exchanged", families::with_axes_permuted3(input, {1, 2, 0}));
    expect_same("triangulated", families::triangulated3(input));
}

/// (4) The order of meshes, vertices and faces changes names only.
inline void expect_order_changes_names_only(const SceneInput3& input, std::uint64_t seed,
                                            const SkeletonFunction& build) {
    const Scene3 scene = scene3(input);
    const families::PermutedScene3 permuted = families::permuted3(input, seed);
    const Scene3 other = scene3(permuted.scene);
    std::vector<VertexId> vertices;
    for (const std::uint32_t v : permuted.old_vertex) vertices.push_back(VertexId{v});
    const auto names = renaming(other, scene, std::move(vertices));
    EXPECT_TRUE(same_skeleton(renamed(build(other), names), build(scene)));
}

}  // namespace sightline::testing
