// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>

#include "scene/mesh3.hpp"
#include "scene/union_find.hpp"

namespace sightline::detail {
namespace {

/// A half-edge seen along its edge: the face lies in the direction `side`·(point - edge).
struct Wing {
    std::uint32_t half = 0;
    Point3 point;  ///< of the face's plane, not on the edge's line
    Sign side = Sign::positive;
};

/// The half-edges of one edge in counter-clockwise order round it, seen against its direction low → high.
class Fan {
public:
    Fan(const Mesh3& mesh, std::span<const std::uint32_t> halves) : mesh_(mesh) {
        const HalfEdge3& first = mesh.halves[halves.front()];
        low_ = std::min(first.source, first.target);
        high_ = std::max(first.source, first.target);
        for (const std::uint32_t h : halves) wings_.push_back(wing(h));
        reference_ = wings_.front();
        std::sort(wings_.begin(), wings_.end(),
                  [&](const Wing& a, const Wing& b) { return is_before(a, b); });
    }

    [[nodiscard]] std::span<const Wing> wings() const { return wings_; }
    [[nodiscard]] bool is_forward(const Wing& w) const {
        return mesh_.halves[w.half].source == low_;
    }
    /// Whether two faces leave the edge in one direction, so that they lie on each other.
    [[nodiscard]] bool coincide(const Wing& a, const Wing& b) const {
        return turn(a, b) == Sign::zero && !are_opposite(a, b);
    }

private:
    [[nodiscard]] const Point3& low() const { return mesh_.vertices[low_]; }
    [[nodiscard]] const Point3& high() const { return mesh_.vertices[high_]; }

    [[nodiscard]] Wing wing(std::uint32_t h) const {
        const Plane3& plane = mesh_.planes[mesh_.halves[h].face];
        for (const Point3& p : plane.points) {
            const Sign turn = plane.turn(low(), high(), p);
            if (turn == Sign::zero) continue;
            return {h, p, mesh_.halves[h].source == low_ ? turn : -turn};
        }
        return {h, plane.points[0], Sign::positive};  // no plane has three points on a line
    }

    // Positive when b is less than half a turn after a.
    [[nodiscard]] Sign turn(const Wing& a, const Wing& b) const {
        return orientation3(low(), high(), a.point, b.point) * a.side * b.side;
    }
    // For wings in one plane.
    [[nodiscard]] bool are_opposite(const Wing& a, const Wing& b) const {
        const Plane3& plane = mesh_.planes[mesh_.halves[a.half].face];
        const Sign to_a = plane.turn(low(), high(), a.point) * a.side;
        const Sign to_b = plane.turn(low(), high(), b.point) * b.side;
        return to_a != to_b;
    }
    // 0: like the reference, 1: in the half turn after it, 2: opposite, 3: in the second half turn.
    [[nodiscard]] int quarter(const Wing& w) const {
        const Sign sign = turn(reference_, w);
        if (sign == Sign::zero) return are_opposite(reference_, w) ? 2 : 0;
        return sign == Sign::positive ? 1 : 3;
    }
    [[nodiscard]] bool is_before(const Wing& a, const Wing& b) const {
        const int qa = quarter(a);
        const int qb = quarter(b);
        if (qa != qb) return qa < qb;
        if (qa % 2 == 1) {
            const Sign sign = turn(a, b);
            if (sign != Sign::zero) return sign == Sign::positive;
        }
        // Of faces that touch, the one whose outside comes next is first, so that the solids stay apart.
        if (is_forward(a) != is_forward(b)) return is_forward(a);
        return a.half < b.half;
    }

    const Mesh3& mesh_;
    std::uint32_t low_ = 0;
    std::uint32_t high_ = 0;
    std::vector<Wing> wings_;
    Wing reference_;
};

class Pairing {
public:
    explicit Pairing(Mesh3& mesh) : mesh_(mesh), components_(mesh.face_count()) {}

    Result<void> run() {
        std::vector<std::uint32_t> order(mesh_.halves.size());
        std::iota(order.begin(), order.end(), 0u);
        const auto key = [&](std::uint32_t h) {
            const HalfEdge3& half = mesh_.halves[h];
            return std::minmax(half.source, half.target);
        };
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            const auto ka = key(a);
            const auto kb = key(b);
            return ka != kb ? ka < kb : a < b;
        });
        for (std::size_t i = 0; i < order.size();) {
            std::size_t end = i + 1;
            while (end < order.size() && key(order[end]) == key(order[i])) ++end;
            const std::span<const std::uint32_t> group(order.data() + i, end - i);
            const Result<void> ok = mesh_.is_sheet(mesh_.halves[group.front()].face)
                                        ? add_sheet(group)
                                        : add_solid(group);
            if (!ok) return ok;
            i = end;
        }
        number_components();
        return {};
    }

private:
    [[nodiscard]] std::string place(std::uint32_t half) const {
        return fmt::format("{}, {}", mesh_.name_of_face(mesh_.halves[half].face),
                           mesh_.short_name_of_edge(half));
    }

    Result<void> add_solid(std::span<const std::uint32_t> group) {
        if (group.size() == 1) {
            return fail(Errc::open_surface,
                        place(group[0]) +
                            ": no other face has this edge, so the solid is open; "
                            "close it, or read the file as sheets");
        }
        const std::uint32_t low =
            std::min(mesh_.halves[group[0]].source, mesh_.halves[group[0]].target);
        const auto forward = static_cast<std::size_t>(
            std::count_if(group.begin(), group.end(),
                          [&](std::uint32_t h) { return mesh_.halves[h].source == low; }));
        if (group.size() == 2 && forward != 1) {
            return fail(
                Errc::wrong_orientation,
                fmt::format("{}: {} runs along this edge in the same direction; turn one of the "
                            "two faces (repair does)",
                            place(group[1]),
                            mesh_.short_name_of_face(mesh_.halves[group[0]].face)));
        }
        if (2 * forward != group.size()) {
            return fail(
                Errc::non_manifold,
                fmt::format(
                    "{}: {} faces meet in this edge, {} of them in one direction; a solid "
                    "needs as many in each: remove or turn a face, or read the file as sheets",
                    place(group[0]), group.size(), forward));
        }
        const Fan fan(mesh_, group);
        const std::span<const Wing> wings = fan.wings();
        for (std::size_t i = 0; i < wings.size(); ++i) {
            if (fan.is_forward(wings[i])) continue;
            const Wing& next = wings[(i + 1) % wings.size()];
            if (!fan.is_forward(next) || fan.coincide(wings[i], next)) {
                return fail(
                    Errc::self_intersection,
                    fmt::format("{}: {} and {} fold onto each other or cross there; separate them",
                                place(wings[i].half),
                                mesh_.short_name_of_face(mesh_.halves[wings[i].half].face),
                                mesh_.short_name_of_face(mesh_.halves[next.half].face)));
            }
            add_pair(next.half, wings[i].half);
        }
        return {};
    }

    Result<void> add_sheet(std::span<const std::uint32_t> group) {
        for (const std::uint32_t h : group)
            components_.join(mesh_.halves[h].face, mesh_.halves[group[0]].face);
        if (group.size() == 1) {
            mesh_.pairs.push_back({group[0], no_index});
        } else if (group.size() == 2) {
            const HalfEdge3& first = mesh_.halves[group[0]];
            const bool first_is_left = first.source < first.target;
            add_pair(group[first_is_left ? 0 : 1], group[first_is_left ? 1 : 0]);
        } else {
            const Fan fan(mesh_, group);
            const std::span<const Wing> wings = fan.wings();
            for (std::size_t i = 0; i < wings.size(); ++i)
                mesh_.pairs.push_back({wings[(i + 1) % wings.size()].half, wings[i].half});
        }
        return {};
    }

    void add_pair(std::uint32_t left, std::uint32_t right) {
        const HalfEdge3& l = mesh_.halves[left];
        const HalfEdge3& r = mesh_.halves[right];
        components_.join(l.face, r.face);
        const bool same_sense = l.source == r.source;
        const Plane3& plane = mesh_.planes[l.face];
        const Plane3& other = mesh_.planes[r.face];
        // On opposite sides of the edge when equal directions go with opposite fronts.
        const bool flat = l.face == r.face
                              ? !same_sense  // a bridge to a hole
                              : plane.contains(other) && plane.faces_like(other) != same_sense;
        mesh_.pairs.push_back({left, right, flat, same_sense});
    }

    void number_components() {
        mesh_.component_of_face.assign(mesh_.face_count(), no_index);
        std::vector<std::uint32_t> number(mesh_.face_count(), no_index);
        for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
            std::uint32_t& n = number[components_.root(f)];
            if (n == no_index) n = mesh_.component_count++;
            mesh_.component_of_face[f] = n;
        }
    }

    Mesh3& mesh_;
    UnionFind components_;
};

}  // namespace

Result<void> pair_edges(Mesh3& mesh) {
    mesh.pairs.clear();
    mesh.component_count = 0;
    return Pairing(mesh).run();
}

Result<void> check_places(const Mesh3& mesh) {
    struct Use {
        std::uint32_t component, vertex;
    };
    std::vector<Use> uses;
    for (const HalfEdge3& half : mesh.halves)
        uses.push_back({mesh.component_of_face[half.face], half.source});
    const auto at = [&](const Use& u) -> const Point3& { return mesh.vertices[u.vertex]; };
    std::sort(uses.begin(), uses.end(), [&](const Use& a, const Use& b) {
        if (a.component != b.component) return a.component < b.component;
        if (at(a) != at(b)) return at(a) < at(b);
        return a.vertex < b.vertex;
    });
    for (std::size_t i = 0; i + 1 < uses.size(); ++i) {
        const Use& a = uses[i];
        const Use& b = uses[i + 1];
        if (a.component != b.component || a.vertex == b.vertex || at(a) != at(b)) continue;
        return fail(
            Errc::duplicate_vertex,
            fmt::format("{}: lies where {} of the same component lies; merge the two (repair does)",
                        mesh.name_of_vertex(b.vertex), mesh.short_name_of_vertex(a.vertex)));
    }
    return {};
}

}  // namespace sightline::detail
