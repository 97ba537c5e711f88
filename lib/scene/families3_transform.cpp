// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "scene/families2_detail.hpp"
#include "sightline/geom/predicates2.hpp"
#include "sightline/scene/transform3.hpp"

namespace sightline::families {

using namespace detail;

namespace {

/// a + b when that is a double, or when it overflows: the error of the rounded sum (Knuth's two-sum) is zero.
std::optional<double> exact_sum(double a, double b) {
    const double sum = a + b;
    if (!std::isfinite(sum)) return sum;
    const double b_part = sum - a;
    const double error = (a - (sum - b_part)) + (b - b_part);
    return error == 0 ? std::optional(sum) : std::nullopt;
}

/// a * b when that is a double, or when it overflows. b is an integer, so no product underflows.
std::optional<double> exact_product(double a, double b) {
    const double product = a * b;
    if (!std::isfinite(product)) return product;
    return std::fma(a, b, -product) == 0 ? std::optional(product) : std::nullopt;
}

std::optional<double> exact_scaled(double x, int exponent) {
    const double scaled = std::ldexp(x, std::clamp(exponent, -5000, 5000));
    if (!std::isfinite(scaled)) return scaled;
    const bool exact = x == 0 || (scaled != 0 && std::ldexp(scaled, -exponent) == x);
    return exact ? std::optional(scaled) : std::nullopt;
}

using Row = std::array<double, 3>;

/// The product of a row and a column when all of its steps are exact.
std::optional<double> exact_dot(const Row& row, const Point3& p) {
    const auto x = exact_product(p.x, row[0]);
    const auto y = exact_product(p.y, row[1]);
    const auto z = exact_product(p.z, row[2]);
    const auto xy = x && y ? exact_sum(*x, *y) : std::nullopt;
    return xy && z ? exact_sum(*xy, *z) : std::nullopt;
}

/// The scene with `move` applied to each coordinate triple; nullopt from `move`: can't be exact.
template <typename Move>
Result<SceneInput3> moved(const SceneInput3& scene, const char* what, Move move) {
    SceneInput3 result = scene;
    for (MeshInput3& mesh : result.meshes) {
        for (Point3& p : mesh.vertices) {
            const std::array<std::optional<double>, 3> q = move(p);
            for (const auto& coordinate : q) {
                if (coordinate && !std::isfinite(*coordinate)) {
                    return fail(Errc::coordinate_too_large,
                                std::string(what) + ": a coordinate overflows; use smaller ones");
                }
            }
            if (!q[0] || !q[1] || !q[2]) {
                return fail(Errc::bad_parameter,
                            std::string(what) +
                                ": a coordinate can't be kept exact; use smaller or simpler "
                                "coordinates");
            }
            p = {*q[0], *q[1], *q[2]};
        }
    }
    return result;
}

/// Turns faces over; the first vertex stays the first.
void turn_over(MeshInput3& mesh) {
    for (auto& face : mesh.faces) {
        if (!face.empty()) std::reverse(face.begin() + 1, face.end());
    }
}

}  // namespace

Result<SceneInput3> translated3(const SceneInput3& scene, double dx, double dy, double dz) {
    if (!std::isfinite(dx) || !std::isfinite(dy) || !std::isfinite(dz)) {
        return fail(Errc::bad_parameter,
                    "translation: not by a finite vector; give finite numbers");
    }
    return moved(scene, "translation", [&](const Point3& p) {
        return std::array{exact_sum(p.x, dx), exact_sum(p.y, dy), exact_sum(p.z, dz)};
    });
}

Result<SceneInput3> scaled3(const SceneInput3& scene, int exponent) {
    return moved(scene, "scaling", [&](const Point3& p) {
        return std::array{exact_scaled(p.x, exponent), exact_scaled(p.y, exponent),
                          exact_scaled(p.z, exponent)};
    });
}

Result<SceneInput3> rotated3(const SceneInput3& scene,
                             const std::array<std::int64_t, 4>& quaternion) {
    constexpr std::int64_t most = std::int64_t{1} << 25;
    for (const std::int64_t part : quaternion) SIGHTLINE_EXPECT(part > -most && part < most);
    SIGHTLINE_EXPECT((quaternion != std::array<std::int64_t, 4>{}));
    const auto [a, b, c, d] = quaternion;
    const auto row = [](std::int64_t x, std::int64_t y, std::int64_t z) {
        return Row{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    };
    const Row x = row(a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c));
    const Row y = row(2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b));
    const Row z = row(2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d);
    return moved(scene, "rotation", [&](const Point3& p) {
        return std::array{exact_dot(x, p), exact_dot(y, p), exact_dot(z, p)};
    });
}

SceneInput3 mirrored3(const SceneInput3& scene) {
    SceneInput3 result = scene;
    for (MeshInput3& mesh : result.meshes) {
        for (Point3& p : mesh.vertices) p.x = 0.0 - p.x;
        turn_over(mesh);
    }
    return result;
}

SceneInput3 with_axes_permuted3(const SceneInput3& scene, const std::array<int, 3>& axes) {
    std::array<int, 3> sorted = axes;
    std::sort(sorted.begin(), sorted.end());
    SIGHTLINE_EXPECT((sorted == std::array{0, 1, 2}));
    const bool odd =
        axes == std::array{1, 0, 2} || axes == std::array{0, 2, 1} || axes == std::array{2, 1, 0};
    SceneInput3 result = scene;
    for (MeshInput3& mesh : result.meshes) {
        for (Point3& p : mesh.vertices) {
            const std::array<double, 3> old{p.x, p.y, p.z};
            p = {old[static_cast<std::size_t>(axes[0])], old[static_cast<std::size_t>(axes[1])],
                 old[static_cast<std::size_t>(axes[2])]};
        }
        if (odd) turn_over(mesh);
    }
    return result;
}

namespace {

/// 0 … count − 1 in random order.
std::vector<std::uint32_t> random_order(Rng& rng, std::size_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    rng.shuffle(order);
    return order;
}

/// The lines of those that come in this order; none when they are unknown.
std::vector<std::uint32_t> reordered(const std::vector<std::uint32_t>& lines,
                                     const std::vector<std::uint32_t>& order) {
    std::vector<std::uint32_t> result;
    if (lines.size() != order.size()) return result;
    for (const std::uint32_t old : order) result.push_back(lines[old]);
    return result;
}

/// Permutes a mesh and appends the old numbers, which begin with these.
MeshInput3 permuted_mesh(Rng& rng, const MeshInput3& mesh, std::uint32_t first_vertex,
                         std::uint32_t first_face, PermutedScene3& result) {
    MeshInput3 permuted = mesh;
    const std::vector<std::uint32_t> order = random_order(rng, mesh.vertices.size());
    std::vector<std::uint32_t> image(order.size());
    for (std::uint32_t v = 0; v < order.size(); ++v) {
        image[order[v]] = v;
        permuted.vertices[v] = mesh.vertices[order[v]];
        result.old_vertex.push_back(first_vertex + order[v]);
    }
    const std::vector<std::uint32_t> face_order = random_order(rng, mesh.faces.size());
    for (std::size_t f = 0; f < face_order.size(); ++f) {
        std::vector<std::uint32_t> face = mesh.faces[face_order[f]];
        for (std::uint32_t& v : face) v = image[v];
        if (!face.empty()) {
            const auto start = static_cast<std::ptrdiff_t>(rng.below(face.size()));
            std::rotate(face.begin(), face.begin() + start, face.end());
        }
        permuted.faces[f] = std::move(face);
        result.old_face.push_back(first_face + face_order[f]);
    }
    permuted.vertex_lines = reordered(mesh.vertex_lines, order);
    permuted.face_lines = reordered(mesh.face_lines, face_order);
    return permuted;
}

}  // namespace

PermutedScene3 permuted3(const SceneInput3& scene, std::uint64_t seed) {
    Rng rng(seed);
    std::vector<std::uint32_t> first_vertex{0};
    std::vector<std::uint32_t> first_face{0};
    for (const MeshInput3& mesh : scene.meshes) {
        first_vertex.push_back(first_vertex.back() +
                               static_cast<std::uint32_t>(mesh.vertices.size()));
        first_face.push_back(first_face.back() + static_cast<std::uint32_t>(mesh.faces.size()));
    }
    std::vector<std::uint32_t> order = random_order(rng, scene.meshes.size());
    if (scene.world) {  // to the front
        std::iter_swap(order.begin(), std::find(order.begin(), order.end(), 0U));
    }
    PermutedScene3 result{{.meshes = {}, .world = scene.world}, {}, {}};
    for (const std::uint32_t m : order) {
        result.scene.meshes.push_back(
            permuted_mesh(rng, scene.meshes[m], first_vertex[m], first_face[m], result));
    }
    return result;
}

namespace {

/// A face in the plane: a coordinate left out so that it keeps an area, and so that it is counter-clockwise.
std::vector<Point2> flattened(const MeshInput3& mesh, const std::vector<std::uint32_t>& face) {
    for (int left_out = 0; left_out < 3; ++left_out) {
        std::vector<Point2> flat;
        for (const std::uint32_t v : face) {
            const Point3& p = mesh.vertices[v];
            flat.push_back(left_out == 0   ? Point2{p.y, p.z}
                           : left_out == 1 ? Point2{p.z, p.x}
                                           : Point2{p.x, p.y});
        }
        // The lexicographically least vertex is convex; collinear neighbours are skipped.
        const std::size_t n = flat.size();
        const auto least =
            static_cast<std::size_t>(std::min_element(flat.begin(), flat.end()) - flat.begin());
        std::size_t next = (least + 1) % n;
        const std::size_t last = (least + n - 1) % n;
        while (next != last && orientation(flat[last], flat[least], flat[next]) == Sign::zero)
            next = (next + 1) % n;
        const Sign side = orientation(flat[last], flat[least], flat[next]);
        if (side == Sign::zero) continue;
        if (side == Sign::negative) {
            for (Point2& p : flat) std::swap(p.x, p.y);
        }
        return flat;
    }
    SIGHTLINE_EXPECT(!"face without area");
    return {};
}

/// Whether the corner before, at, after of the ring `left` can be cut off.
bool is_ear(const std::vector<Point2>& flat, const std::vector<std::uint32_t>& left,
            std::size_t at) {
    const std::size_t n = left.size();
    const Point2& a = flat[left[(at + n - 1) % n]];
    const Point2& b = flat[left[at]];
    const Point2& c = flat[left[(at + 1) % n]];
    if (orientation(a, b, c) != Sign::positive) return false;
    return std::none_of(left.begin(), left.end(), [&](std::uint32_t v) {
        const Point2& p = flat[v];
        return p != a && p != b && p != c && orientation(a, b, p) != Sign::negative &&
               orientation(b, c, p) != Sign::negative && orientation(c, a, p) != Sign::negative;
    });
}

/// Ear clipping.
void add_triangles(const MeshInput3& mesh, const std::vector<std::uint32_t>& face,
                   std::vector<std::vector<std::uint32_t>>& triangles) {
    const std::vector<Point2> flat = flattened(mesh, face);
    std::vector<std::uint32_t> left(face.size());
    std::iota(left.begin(), left.end(), 0U);
    while (left.size() > 3) {
        std::size_t at = 0;
        while (!is_ear(flat, left, at)) {
            ++at;
            SIGHTLINE_EXPECT(at < left.size());
        }
        const std::size_t n = left.size();
        triangles.push_back(
            {face[left[(at + n - 1) % n]], face[left[at]], face[left[(at + 1) % n]]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    }
    triangles.push_back({face[left[0]], face[left[1]], face[left[2]]});
}

}  // namespace

SceneInput3 triangulated3(const SceneInput3& scene) {
    SceneInput3 result = scene;
    for (MeshInput3& mesh : result.meshes) {
        std::vector<std::vector<std::uint32_t>> triangles;
        std::vector<std::uint32_t> lines;
        for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
            add_triangles(mesh, mesh.faces[f], triangles);
            if (f < mesh.face_lines.size()) lines.resize(triangles.size(), mesh.face_lines[f]);
        }
        mesh.faces = std::move(triangles);
        mesh.face_lines = std::move(lines);
    }
    return result;
}

SceneInput3 approx_nudged3(const SceneInput3& scene, std::uint64_t seed, unsigned per_mille) {
    Rng rng(seed);
    const auto nudge = [&](double& x) {
        if (rng.below(1000) >= per_mille || x == 0) return;
        const double infinity = std::numeric_limits<double>::infinity();
        x = std::nextafter(x, rng.one_in(2) ? infinity : -infinity);
    };
    SceneInput3 result = scene;
    for (MeshInput3& mesh : result.meshes) {
        for (Point3& p : mesh.vertices) {
            nudge(p.x);
            nudge(p.y);
            nudge(p.z);
        }
    }
    return result;
}

}  // namespace sightline::families
