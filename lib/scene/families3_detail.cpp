// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/families3_detail.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include "sightline/scene/result.hpp"

namespace sightline::families::detail {

Wide triple(Int3 u, Int3 v, Int3 w) {
    const auto minor = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
        return static_cast<Wide>(a) * d - static_cast<Wide>(b) * c;
    };
    return u.x * minor(v.y, v.z, w.y, w.z) - u.y * minor(v.x, v.z, w.x, w.z) +
           u.z * minor(v.x, v.y, w.x, w.y);
}

int orientation_sign(Int3 a, Int3 b, Int3 c, Int3 d) {
    const Wide volume = triple(b - a, c - a, a - d);
    return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

namespace {

/// The points in the plane of points i, j, k when no point lies on its positive side; else nothing.
std::vector<std::uint32_t> facet_points(std::span<const Int3> points, std::uint32_t i,
                                        std::uint32_t j, std::uint32_t k) {
    std::vector<std::uint32_t> on;
    for (std::uint32_t l = 0; l < points.size(); ++l) {
        const int side = orientation_sign(points[i], points[j], points[k], points[l]);
        if (side < 0) return {};
        if (side == 0) on.push_back(l);
    }
    return on;
}

/// The extreme ones of coplanar points, counter-clockwise seen from the side that `above` is on: gift wrapping.
std::vector<std::uint32_t> wrapped(std::span<const Int3> points,
                                   const std::vector<std::uint32_t>& on, Int3 above) {
    const auto start = *std::min_element(on.begin(), on.end(),
                                         [&](auto a, auto b) { return points[a] < points[b]; });
    std::vector<std::uint32_t> ring;
    std::uint32_t last = start;
    do {
        ring.push_back(last);
        std::uint32_t next = last == on.front() ? on[1] : on.front();
        for (const std::uint32_t candidate : on) {
            if (candidate == last) continue;
            const Int3 to_next = points[next] - points[last];
            const Int3 to_candidate = points[candidate] - points[last];
            const Wide turn = triple(to_next, to_candidate, above);
            const bool farther = squared_length(to_candidate) > squared_length(to_next);
            if (turn < 0 || (turn == 0 && farther)) next = candidate;
        }
        last = next;
    } while (last != start);
    return ring;
}

/// Keeps the vertices that faces mention.
ConvexSolid compressed(std::span<const Int3> points, FaceList faces) {
    constexpr std::uint32_t unused = UINT32_MAX;
    std::vector<std::uint32_t> number(points.size(), unused);
    for (const auto& face : faces) {
        for (const std::uint32_t v : face) number[v] = 0;
    }
    ConvexSolid solid;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (number[v] == unused) continue;
        number[v] = static_cast<std::uint32_t>(solid.vertices.size());
        solid.vertices.push_back(points[v]);
    }
    for (auto& face : faces) {
        for (std::uint32_t& v : face) v = number[v];
        solid.simplicial = solid.simplicial && face.size() == 3;
    }
    solid.faces = std::move(faces);
    return solid;
}

}  // namespace

ConvexSolid convex_hull(std::span<const Int3> points) {
    FaceList faces;
    const auto n = static_cast<std::uint32_t>(points.size());
    const auto try_facet = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        const Int3 normal = cross3(points[j] - points[i], points[k] - points[i]);
        if (normal == Int3{}) return;
        const std::vector<std::uint32_t> on = facet_points(points, i, j, k);
        if (on.empty()) return;
        // Each facet once: from the first triple of its points that are not on a line.
        std::array<std::uint32_t, 3> sorted{i, j, k};
        std::sort(sorted.begin(), sorted.end());
        std::size_t third = 2;
        while (cross3(points[on[1]] - points[on[0]], points[on[third]] - points[on[0]]) == Int3{})
            ++third;
        if (sorted != std::array{on[0], on[1], on[third]}) return;
        faces.push_back(wrapped(points, on, normal));
    };
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = i + 1; j < n; ++j) {
            for (std::uint32_t k = j + 1; k < n; ++k) {
                try_facet(i, j, k);
                try_facet(i, k, j);
            }
        }
    }
    SIGHTLINE_EXPECT(faces.size() >= 4);
    return compressed(points, std::move(faces));
}

Turn turn_of(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    const std::int64_t norm = a * a + b * b + c * c + d * d;
    SIGHTLINE_EXPECT(norm > 0);
    return {{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
            {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
            {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d},
            norm};
}

namespace {

bool is_parallel_to_an_axis(Int3 v) { return (v.x == 0) + (v.y == 0) + (v.z == 0) > 1; }

}  // namespace

Turn random_turn(Rng& rng) {
    while (true) {
        const auto part = [&rng] { return rng.between(-9, 9); };
        const std::int64_t a = part();
        const std::int64_t b = part();
        const std::int64_t c = part();
        const std::int64_t d = part();
        if (a == 0 && b == 0 && c == 0 && d == 0) continue;
        const Turn turn = turn_of(a, b, c, d);
        if (!is_parallel_to_an_axis(turn.x) && !is_parallel_to_an_axis(turn.y) &&
            !is_parallel_to_an_axis(turn.z)) {
            return turn;
        }
    }
}

Turn random_upright_turn(Rng& rng) {
    constexpr std::array<std::array<std::int64_t, 3>, 16> triples{{{3, 4, 5},
                                                                   {5, 12, 13},
                                                                   {8, 15, 17},
                                                                   {7, 24, 25},
                                                                   {20, 21, 29},
                                                                   {12, 35, 37},
                                                                   {9, 40, 41},
                                                                   {28, 45, 53},
                                                                   {11, 60, 61},
                                                                   {16, 63, 65},
                                                                   {33, 56, 65},
                                                                   {48, 55, 73},
                                                                   {13, 84, 85},
                                                                   {36, 77, 85},
                                                                   {39, 80, 89},
                                                                   {65, 72, 97}}};
    auto [a, b, length] = triples[rng.below(triples.size())];
    if (rng.one_in(2)) std::swap(a, b);
    if (rng.one_in(2)) a = -a;
    if (rng.one_in(2)) b = -b;
    return {{a, b, 0}, {-b, a, 0}, {0, 0, length}, length};
}

void MeshBuilder::add(std::span<const Int3> vertices, const FaceList& faces) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (const Int3& v : vertices) mesh_.vertices.push_back(to_point(v));
    for (std::vector<std::uint32_t> face : faces) {
        for (std::uint32_t& v : face) v += first;
        mesh_.faces.push_back(std::move(face));
    }
}

void MeshBuilder::add_parallelepiped(Int3 corner, Int3 u, Int3 v, Int3 w) {
    if (triple(u, v, w) < 0) std::swap(u, v);
    const std::array<Int3, 8> corners{
        corner,     corner + u,     corner + u + v,     corner + v,
        corner + w, corner + u + w, corner + u + v + w, corner + v + w};
    add(corners,
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

void MeshBuilder::add_box(Int3 low, Int3 high) { add_turned_box({}, {}, low, high); }

void MeshBuilder::add_turned_box(const Turn& turn, Int3 shift, Int3 low, Int3 high) {
    add_parallelepiped(shift + turn(low), (high.x - low.x) * turn.x, (high.y - low.y) * turn.y,
                       (high.z - low.z) * turn.z);
}

void MeshBuilder::add_prism(const Ring3& ring, Int3 along) {
    // The area vector of the ring tells its sense.
    Int3 area;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        area = area + cross3(ring[i] - ring[0], ring[i + 1] - ring[0]);
    const auto dot = static_cast<Wide>(area.x) * along.x + static_cast<Wide>(area.y) * along.y +
                     static_cast<Wide>(area.z) * along.z;
    Ring3 vertices = ring;
    if (dot < 0) std::reverse(vertices.begin(), vertices.end());
    const auto n = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t i = 0; i < n; ++i) vertices.push_back(vertices[i] + along);
    FaceList faces(2);
    for (std::uint32_t i = 0; i < n; ++i) {
        faces[0].push_back(n - 1 - i);
        faces[1].push_back(n + i);
        const std::uint32_t next = (i + 1) % n;
        faces.push_back({i, next, n + next, n + i});
    }
    add(vertices, faces);
}

void MeshBuilder::add_tetrahedron(Int3 a, Int3 b, Int3 c, Int3 d) {
    const int side = orientation_sign(a, b, c, d);
    SIGHTLINE_EXPECT(side != 0);
    if (side < 0) std::swap(a, b);
    add(std::array{a, b, c, d}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
}

void MeshBuilder::add_polygon(const Ring3& ring) {
    FaceList faces(1);
    faces[0].resize(ring.size());
    std::iota(faces[0].begin(), faces[0].end(), 0U);
    add(ring, faces);
}

MeshInput3 MeshBuilder::take(SurfaceKind kind) {
    mesh_.kind = kind;
    return std::exchange(mesh_, {});
}

SceneInput3 MeshBuilder::take_scene(SurfaceKind kind) {
    SceneInput3 scene;
    scene.meshes.push_back(take(kind));
    return scene;
}

std::int64_t ceil_cbrt(Wide value) {
    std::int64_t low = 0;
    std::int64_t high = std::int64_t{1} << 30;
    while (low < high) {
        const std::int64_t middle = low + (high - low) / 2;
        if (static_cast<Wide>(middle) * middle * middle >= value)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

std::vector<Int3> random_balls(Rng& rng, std::size_t count, std::int64_t radius,
                               std::uint64_t percent) {
    SIGHTLINE_EXPECT(percent >= 1 && percent <= 30 && radius >= 1);
    // 4/3 π ≈ 4.18879.
    const Wide volume = static_cast<Wide>(count) * radius * radius * radius * 418'879 /
                        (static_cast<Wide>(1000) * static_cast<std::int64_t>(percent));
    std::int64_t side = std::max(ceil_cbrt(volume), 2 * radius + 2);
    std::vector<Int3> centres;
    std::map<Int3, std::vector<Int3>> cells;
    const auto cell_of = [&](Int3 p) {
        return Int3{p.x / (2 * radius), p.y / (2 * radius), p.z / (2 * radius)};
    };
    const auto is_free = [&](Int3 centre) {
        const Int3 cell = cell_of(centre);
        for (std::int64_t i = 0; i < 27; ++i) {
            const auto near = cells.find(cell + Int3{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1});
            if (near == cells.end()) continue;
            for (const Int3& other : near->second) {
                if (squared_length(other - centre) <= 4 * radius * radius) return false;
            }
        }
        return true;
    };
    for (std::size_t failures = 0; centres.size() < count;) {
        const Int3 centre{rng.between(radius, side - radius), rng.between(radius, side - radius),
                          rng.between(radius, side - radius)};
        if (is_free(centre)) {
            centres.push_back(centre);
            cells[cell_of(centre)].push_back(centre);
        } else if (++failures % (200 + 20 * count) == 0) {
            side += radius / 2 + 1;
        }
    }
    return centres;
}

Int3 on_sphere(Rng& rng, std::int64_t radius) {
    while (true) {
        const auto part = [&rng] { return rng.between(-(1 << 20), 1 << 20); };
        const std::int64_t x = part();
        const std::int64_t y = part();
        const std::int64_t z = part();
        const std::int64_t squared = squared_length({x, y, z});
        if (squared > (std::int64_t{1} << 40) || squared < (std::int64_t{1} << 36)) continue;
        // Square root, product and quotient round the same everywhere; truncation stays inside the ball.
        const double factor =
            static_cast<double>(radius - 1) / std::sqrt(static_cast<double>(squared));
        const auto scaled = [&](std::int64_t c) {
            return static_cast<std::int64_t>(static_cast<double>(c) * factor);
        };
        return {scaled(x), scaled(y), scaled(z)};
    }
}

}  // namespace sightline::families::detail
