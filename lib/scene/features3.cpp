// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/features3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "scene/union_find.hpp"

namespace sightline::detail {
namespace {

/// A side of an input face that separates two merged faces, or the piece of a feature edge that two such
/// sides make.
struct Piece {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    FaceId left;   ///< of low → high
    FaceId right;  ///< none at a border
    BodyId body;
    bool ordered = true;  ///< whether left and right mean something
};

/// An end of a piece.
struct PieceEnd {
    BodyId body;
    std::uint32_t vertex = 0;
    std::uint32_t other = 0;
    std::uint32_t piece = 0;

    friend auto operator<=>(const PieceEnd&, const PieceEnd&) = default;
};

class FeatureFinder {
public:
    FeatureFinder(const Mesh3& mesh, const std::vector<BodyId>& body_of_component)
        : mesh_(mesh), body_of_component_(body_of_component) {}

    Result<Features3> run() {
        merge_faces();
        collect_pieces();
        find_passed();
        join_pieces();
        if (const auto ok = trace_rings(); !ok) return tl::unexpected(ok.error());
        return std::move(features_);
    }

private:
    void merge_faces() {
        UnionFind merged(mesh_.face_count());
        twin_.assign(mesh_.halves.size(), no_index);
        for (const EdgePair3& pair : mesh_.pairs) {
            if (!pair.flat) continue;
            twin_[pair.left] = pair.right;
            twin_[pair.right] = pair.left;
            merged.join(mesh_.halves[pair.left].face, mesh_.halves[pair.right].face);
        }
        for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
            const std::uint32_t root = merged.root(f);
            if (root == f) {
                features_.face_of_input.push_back(
                    FaceId{static_cast<std::uint32_t>(features_.faces.size())});
                features_.faces.push_back(
                    {body_of_component_[mesh_.component_of_face[f]], {}, {}, {}});
            } else {
                features_.face_of_input.push_back(features_.face_of_input[root]);
            }
            features_.faces[features_.face_of_input[f].index()].input_faces.push_back(f);
        }
    }

    void collect_pieces() {
        for (const EdgePair3& pair : mesh_.pairs) {
            if (pair.flat) continue;
            const HalfEdge3& half = mesh_.halves[pair.left];
            Piece piece;
            std::tie(piece.low, piece.high) = std::minmax(half.source, half.target);
            piece.body = body_of_component_[mesh_.component_of_face[half.face]];
            const FaceId one = features_.face_of_input[half.face];
            if (pair.right == no_index) {
                (half.source == piece.low ? piece.left : piece.right) = one;
            } else {
                piece.left = one;
                piece.right = features_.face_of_input[mesh_.halves[pair.right].face];
                piece.ordered = !pair.same_sense;
                if (!piece.ordered && piece.right < piece.left) std::swap(piece.left, piece.right);
            }
            const auto number = static_cast<std::uint32_t>(pieces_.size());
            ends_.push_back({piece.body, piece.low, piece.high, number});
            ends_.push_back({piece.body, piece.high, piece.low, number});
            pieces_.push_back(piece);
        }
        std::sort(ends_.begin(), ends_.end());
    }

    // The faces on the left and right of the piece when it is walked from `from`.
    [[nodiscard]] std::pair<FaceId, FaceId> sides(std::uint32_t piece, std::uint32_t from) const {
        const Piece& p = pieces_[piece];
        return p.low == from || !p.ordered ? std::pair{p.left, p.right}
                                           : std::pair{p.right, p.left};
    }

    /// Vertices through which a body's feature edges pass straight on, and how pieces continue there.
    void find_passed() {
        continuation_.assign(2 * pieces_.size(), no_index);
        for (std::size_t i = 0; i < ends_.size();) {
            std::size_t end = i + 1;
            while (end < ends_.size() && ends_[end].body == ends_[i].body &&
                   ends_[end].vertex == ends_[i].vertex)
                ++end;
            look_at_vertex(i, end);
            i = end;
        }
    }

    void look_at_vertex(std::size_t begin, std::size_t end) {
        const std::uint32_t v = ends_[begin].vertex;
        std::size_t middle = begin;
        while (middle < end && ends_[middle].other == ends_[begin].other) ++middle;
        if (middle == end || 2 * (middle - begin) != end - begin ||
            ends_[middle].other != ends_[end - 1].other)
            return;
        const std::uint32_t a = ends_[begin].other;
        const std::uint32_t b = ends_[middle].other;
        if (!is_between(mesh_.vertices[a], mesh_.vertices[v], mesh_.vertices[b])) return;
        std::vector<std::pair<std::pair<FaceId, FaceId>, std::uint32_t>> in;
        std::vector<std::pair<std::pair<FaceId, FaceId>, std::uint32_t>> out;
        for (std::size_t i = begin; i < middle; ++i)
            in.emplace_back(sides(ends_[i].piece, a), ends_[i].piece);
        for (std::size_t i = middle; i < end; ++i)
            out.emplace_back(sides(ends_[i].piece, v), ends_[i].piece);
        std::sort(in.begin(), in.end());
        std::sort(out.begin(), out.end());
        for (std::size_t i = 0; i < in.size(); ++i)
            if (in[i].first != out[i].first) return;
        for (std::size_t i = 0; i < in.size(); ++i) {
            continuation_[slot(in[i].second, v)] = out[i].second;
            continuation_[slot(out[i].second, v)] = in[i].second;
        }
    }

    [[nodiscard]] std::size_t slot(std::uint32_t piece, std::uint32_t end) const {
        return 2 * std::size_t{piece} + (pieces_[piece].high == end ? 1 : 0);
    }
    [[nodiscard]] std::uint32_t other_end(std::uint32_t piece, std::uint32_t end) const {
        return pieces_[piece].low == end ? pieces_[piece].high : pieces_[piece].low;
    }

    void join_pieces() {
        for (const PieceEnd& start : ends_) {
            if (continuation_[slot(start.piece, start.vertex)] != no_index) continue;
            std::uint32_t piece = start.piece;
            std::uint32_t at = start.other;
            while (continuation_[slot(piece, at)] != no_index) {
                piece = continuation_[slot(piece, at)];
                at = other_end(piece, at);
            }
            if (at < start.vertex) continue;  // walked from its other end as well
            const auto [left, right] = sides(start.piece, start.vertex);
            features_.edges.push_back(
                {VertexId{start.vertex}, VertexId{at}, start.body, {left, right}});
        }
        std::sort(features_.edges.begin(), features_.edges.end(),
                  [](const Edge3& a, const Edge3& b) {
                      return std::tie(a.source, a.target, a.body, a.faces) <
                             std::tie(b.source, b.target, b.body, b.faces);
                  });
    }

    // Whether a half-edge that bounds a merged face starts at a feature vertex of its body.
    [[nodiscard]] bool starts_at_feature(std::uint32_t h) const {
        const HalfEdge3& half = mesh_.halves[h];
        const BodyId body = body_of_component_[mesh_.component_of_face[half.face]];
        const auto end =
            std::lower_bound(ends_.begin(), ends_.end(), PieceEnd{body, half.source, 0, 0});
        return continuation_[slot(end->piece, half.source)] == no_index;
    }

    // The half-edge that follows h on the boundary of its merged face.
    [[nodiscard]] std::uint32_t next_on_boundary(std::uint32_t h) const {
        h = mesh_.halves[h].next;
        while (twin_[h] != no_index) h = mesh_.halves[twin_[h]].next;
        return h;
    }

    Result<void> trace_rings() {
        std::vector<bool> seen(mesh_.halves.size(), false);
        outer_count_.assign(features_.faces.size(), 0);
        for (std::uint32_t start = 0; start < mesh_.halves.size(); ++start) {
            if (twin_[start] != no_index || seen[start]) continue;
            std::vector<std::uint32_t> ring;
            for (std::uint32_t h = start; !seen[h]; h = next_on_boundary(h)) {
                seen[h] = true;
                ring.push_back(h);
            }
            add_ring(ring);
        }
        for (std::size_t f = 0; f < features_.faces.size(); ++f) {
            if (outer_count_[f] == 1) continue;
            return fail(
                Errc::self_intersection,
                fmt::format("{}: the coplanar faces joined with it overlap or do not bound one "
                            "region; separate or remove them",
                            mesh_.name_of_face(features_.faces[f].input_faces.front())));
        }
        return {};
    }

    [[nodiscard]] const Point3& source_of(std::uint32_t h) const {
        return mesh_.vertices[mesh_.halves[h].source];
    }

    void add_ring(const std::vector<std::uint32_t>& ring) {
        const FaceId id = features_.face_of_input[mesh_.halves[ring.front()].face];
        Face3& face = features_.faces[id.index()];
        const Plane3& plane = mesh_.planes[face.input_faces.front()];
        const bool outer = is_outer(ring, plane);
        std::vector<VertexId> corners;
        for (const std::uint32_t h : ring)
            if (starts_at_feature(h)) corners.push_back(VertexId{mesh_.halves[h].source});
        const auto at = [&](VertexId v) -> const Point3& { return mesh_.vertices[v.index()]; };
        const auto least = std::min_element(corners.begin(), corners.end(),
                                            [&](VertexId a, VertexId b) { return at(a) < at(b); });
        std::rotate(corners.begin(), least, corners.end());
        if (!outer) {
            face.rings.push_back(std::move(corners));
            return;
        }
        ++outer_count_[id.index()];
        face.plane = {corners.back(), corners[0], corners[1]};
        face.rings.insert(face.rings.begin(), std::move(corners));
    }

    // All corners of an outer ring at its least place are convex; a hole has one there that holds the
    // ring's outside, or is the end of a slit.
    [[nodiscard]] bool is_outer(const std::vector<std::uint32_t>& ring, const Plane3& plane) const {
        std::uint32_t least = ring.front();
        for (const std::uint32_t h : ring)
            if (source_of(h) < source_of(least)) least = h;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point3& p = source_of(ring[i]);
            if (p != source_of(least)) continue;
            const Point3& before = source_of(ring[(i + ring.size() - 1) % ring.size()]);
            const Point3& after = source_of(ring[(i + 1) % ring.size()]);
            if (plane.turn(before, p, after) != Sign::positive) return false;
        }
        return true;
    }

    const Mesh3& mesh_;
    const std::vector<BodyId>& body_of_component_;
    Features3 features_;
    std::vector<std::uint32_t> twin_;  ///< a half-edge; where the surface goes on in the same plane
    std::vector<Piece> pieces_;
    std::vector<PieceEnd> ends_;  ///< ascending
    std::vector<std::uint32_t>
        continuation_;  ///< two a piece: the piece that goes straight on, or none
    std::vector<std::uint32_t> outer_count_;
};

/// Which faces to turn so that flat pairs have opposite senses.
std::vector<bool> faces_to_turn(const Mesh3& mesh) {
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> neighbours(mesh.face_count());
    for (const EdgePair3& pair : mesh.pairs) {
        if (!pair.flat) continue;
        const std::uint32_t a = mesh.halves[pair.left].face;
        const std::uint32_t b = mesh.halves[pair.right].face;
        neighbours[a].emplace_back(b, pair.same_sense);
        neighbours[b].emplace_back(a, pair.same_sense);
    }
    std::vector<bool> turn(mesh.face_count(), false);
    std::vector<bool> seen(mesh.face_count(), false);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        if (seen[f]) continue;
        std::vector<std::uint32_t> stack{f};
        seen[f] = true;
        while (!stack.empty()) {
            const std::uint32_t a = stack.back();
            stack.pop_back();
            for (const auto& [b, same_sense] : neighbours[a]) {
                if (seen[b]) continue;
                seen[b] = true;
                turn[b] = turn[a] != same_sense;
                stack.push_back(b);
            }
        }
    }
    return turn;
}

void turn_face(Mesh3& mesh, std::uint32_t face) {
    const std::uint32_t first = mesh.first_half[face];
    const std::uint32_t end = mesh.first_half[face + 1];
    std::vector<std::uint32_t> corners;
    for (std::uint32_t h = end; h-- > first;) corners.push_back(mesh.halves[h].source);
    for (std::uint32_t h = first; h < end; ++h) {
        mesh.halves[h].source = corners[h - first];
        mesh.halves[h].target = corners[h + 1 == end ? 0 : h + 1 - first];
    }
    const auto [a, b, c] = mesh.planes[face].points;
    mesh.planes[face] = Plane3::through(c, b, a);
}

}  // namespace

Result<void> orient_sheets(Mesh3& mesh) {
    const bool needed =
        std::any_of(mesh.pairs.begin(), mesh.pairs.end(),
                    [](const EdgePair3& pair) { return pair.flat && pair.same_sense; });
    if (!needed) return {};
    const std::vector<bool> turn = faces_to_turn(mesh);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        if (turn[f]) turn_face(mesh, f);
    return pair_edges(mesh);
}

Result<Features3> find_features(const Mesh3& mesh, const std::vector<BodyId>& body_of_component) {
    return FeatureFinder(mesh, body_of_component).run();
}

}  // namespace sightline::detail
