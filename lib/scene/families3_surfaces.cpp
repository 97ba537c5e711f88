// SPDX-License-Identifier: GPL-3.0-or-later
// Land and curved surfaces.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "scene/families3_detail.hpp"
#include "sightline/scene/families3.hpp"

namespace sightline::families {

using namespace detail;

namespace {

/// Heights on a lattice of (side + 1)² points; side is a power of two.
class Heights {
public:
    explicit Heights(std::int64_t side)
        : side_(side), z_(static_cast<std::size_t>((side + 1) * (side + 1))) {}

    [[nodiscard]] std::int64_t side() const { return side_; }
    [[nodiscard]] std::int64_t& at(std::int64_t x, std::int64_t y) {
        return z_[static_cast<std::size_t>(y * (side_ + 1) + x)];
    }
    /// The mean of the neighbours on the lattice at these offsets.
    [[nodiscard]] std::int64_t mean(std::int64_t x, std::int64_t y,
                                    const std::array<IntPoint, 4>& offsets) {
        std::int64_t sum = 0;
        std::int64_t count = 0;
        for (const IntPoint& offset : offsets) {
            const std::int64_t nx = x + offset.x;
            const std::int64_t ny = y + offset.y;
            if (nx < 0 || ny < 0 || nx > side_ || ny > side_) continue;
            sum += at(nx, ny);
            ++count;
        }
        return sum / count;
    }

private:
    std::int64_t side_;
    std::vector<std::int64_t> z_;
};

constexpr std::int64_t spacing = 1 << 8;

/// Diamond-square: each step halves the squares and the roughness.
Heights fractal(Rng& rng, std::int64_t side) {
    Heights heights(side);
    std::int64_t rough = spacing * side / 4;
    for (const std::int64_t x : {std::int64_t{0}, side}) {
        for (const std::int64_t y : {std::int64_t{0}, side})
            heights.at(x, y) = rng.between(0, rough);
    }
    for (std::int64_t step = side; step > 1; step /= 2, rough = rough / 2 + 1) {
        const std::int64_t h = step / 2;
        for (std::int64_t y = h; y < side; y += step) {
            for (std::int64_t x = h; x < side; x += step) {
                heights.at(x, y) = heights.mean(x, y, {{{-h, -h}, {h, -h}, {-h, h}, {h, h}}}) +
                                   rng.between(-rough, rough);
            }
        }
        for (std::int64_t y = 0; y <= side; y += h) {
            for (std::int64_t x = y / h % 2 == 0 ? h : 0; x <= side; x += step) {
                heights.at(x, y) = heights.mean(x, y, {{{-h, 0}, {h, 0}, {0, -h}, {0, h}}}) +
                                   rng.between(-rough, rough);
            }
        }
    }
    return heights;
}

/// Walls down from the border, and a bottom.
void add_base(const Heights& heights, Ring3& vertices, FaceList& faces) {
    const auto side = static_cast<std::uint32_t>(heights.side());
    const auto top = [side](std::uint32_t x, std::uint32_t y) { return y * (side + 1) + x; };
    std::vector<std::uint32_t> border;  // counter-clockwise seen from above
    for (std::uint32_t i = 0; i < side; ++i) border.push_back(top(i, 0));
    for (std::uint32_t i = 0; i < side; ++i) border.push_back(top(side, i));
    for (std::uint32_t i = side; i > 0; --i) border.push_back(top(i, side));
    for (std::uint32_t i = side; i > 0; --i) border.push_back(top(0, i));
    const std::int64_t floor =
        std::min_element(vertices.begin(), vertices.end(), [](Int3 a, Int3 b) { return a.z < b.z; })
            ->z -
        spacing;
    const auto first = static_cast<std::uint32_t>(vertices.size());
    const auto n = static_cast<std::uint32_t>(border.size());
    for (const std::uint32_t v : border) vertices.push_back({vertices[v].x, vertices[v].y, floor});
    std::vector<std::uint32_t> bottom;
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        faces.push_back({border[j], border[i], first + i, first + j});
        bottom.push_back(first + n - 1 - i);
    }
    faces.push_back(std::move(bottom));
}

}  // namespace

SceneInput3 terrain(const Terrain& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.levels <= 10);
    Rng rng(seed);
    const std::int64_t side = std::int64_t{1} << parameters.levels;
    Heights heights = fractal(rng, side);
    Ring3 vertices;
    for (std::int64_t y = 0; y <= side; ++y) {
        for (std::int64_t x = 0; x <= side; ++x)
            vertices.push_back({spacing * x, spacing * y, heights.at(x, y)});
    }
    FaceList faces;
    const auto row = static_cast<std::uint32_t>(side + 1);
    for (std::uint32_t y = 0; y + 1 < row; ++y) {
        for (std::uint32_t x = 0; x + 1 < row; ++x) {
            const std::uint32_t v = y * row + x;
            if ((x + y) % 2 == 0) {
                faces.push_back({v, v + 1, v + row + 1});
                faces.push_back({v, v + row + 1, v + row});
            } else {
                faces.push_back({v, v + 1, v + row});
                faces.push_back({v + 1, v + row + 1, v + row});
            }
        }
    }
    if (parameters.solid) add_base(heights, vertices, faces);
    MeshBuilder mesh;
    mesh.add(vertices, faces);
    return mesh.take_scene(parameters.solid ? SurfaceKind::solid : SurfaceKind::sheet);
}

namespace {

/// p moved along its ray to the lattice point next to the sphere of radius 2^20; p below 2^22.
Int3 onto_sphere(Int3 p) {
    const double factor = 0x1p20 / std::sqrt(static_cast<double>(squared_length(p)));
    const auto scaled = [factor](std::int64_t c) {
        return static_cast<std::int64_t>(std::floor(static_cast<double>(c) * factor + 0.5));
    };
    return {scaled(p.x), scaled(p.y), scaled(p.z)};
}

}  // namespace

SceneInput3 icosphere(const Icosphere& parameters) {
    SIGHTLINE_EXPECT(parameters.levels <= 7);
    const MeshInput3 coarse = solid(SolidShape::icosahedron).meshes.front();
    Ring3 vertices;
    for (const Point3& p : coarse.vertices) {
        vertices.push_back(
            onto_sphere({static_cast<std::int64_t>(p.x) << 16, static_cast<std::int64_t>(p.y) << 16,
                         static_cast<std::int64_t>(p.z) << 16}));
    }
    FaceList faces = coarse.faces;
    for (std::size_t level = 0; level < parameters.levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [entry, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(vertices.size()));
            if (is_new) vertices.push_back(onto_sphere(vertices[a] + vertices[b]));
            return entry->second;
        };
        FaceList finer;
        for (const auto& face : faces) {
            const std::uint32_t a = middle(face[0], face[1]);
            const std::uint32_t b = middle(face[1], face[2]);
            const std::uint32_t c = middle(face[2], face[0]);
            finer.insert(finer.end(),
                         {{face[0], a, c}, {a, face[1], b}, {c, b, face[2]}, {a, b, c}});
        }
        faces = std::move(finer);
    }
    MeshBuilder mesh;
    mesh.add(vertices, faces);
    return mesh.take_scene();
}

SceneInput3 torus(const Torus& parameters) {
    SIGHTLINE_EXPECT(parameters.around >= 3 && parameters.around <= 1000);
    SIGHTLINE_EXPECT(parameters.across >= 3 && parameters.across <= 1000);
    constexpr std::int64_t one = 1 << 20;
    const auto m = static_cast<std::uint32_t>(parameters.around);
    const auto n = static_cast<std::uint32_t>(parameters.across);
    Ring3 vertices;
    for (std::uint32_t i = 0; i < m; ++i) {
        const IntPoint direction = on_circle(i, m, one);
        for (std::uint32_t j = 0; j < n; ++j) {
            const IntPoint tube = on_circle(j, n, one);
            const std::int64_t distance = 3 * one + tube.x;  // from the axis
            vertices.push_back(
                {distance * direction.x / one, distance * direction.y / one, tube.y});
        }
    }
    FaceList faces;
    for (std::uint32_t i = 0; i < m; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t next_i = (i + 1) % m;
            const std::uint32_t next_j = (j + 1) % n;
            const std::uint32_t a = i * n + j;
            const std::uint32_t b = next_i * n + j;
            const std::uint32_t c = next_i * n + next_j;
            const std::uint32_t d = i * n + next_j;
            faces.push_back({a, b, c});
            faces.push_back({a, c, d});
        }
    }
    MeshBuilder mesh;
    mesh.add(vertices, faces);
    return mesh.take_scene();
}

SceneInput3 cylinder(const Cylinder& parameters) {
    SIGHTLINE_EXPECT(parameters.sides >= 3 && parameters.sides <= 1000);
    SIGHTLINE_EXPECT(parameters.stacks >= 1 && parameters.stacks <= 1000);
    const auto n = static_cast<std::uint32_t>(parameters.sides);
    const auto stacks = static_cast<std::uint32_t>(parameters.stacks);
    Ring3 vertices;
    for (std::uint32_t k = 0; k <= stacks; ++k) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const IntPoint p = on_circle(i, n, 1 << 20);
            vertices.push_back({p.x, p.y, (std::int64_t{1} << 16) * k});
        }
    }
    FaceList faces(2);
    for (std::uint32_t i = 0; i < n; ++i) {
        faces[0].push_back(n - 1 - i);
        faces[1].push_back(stacks * n + i);
        const std::uint32_t next = (i + 1) % n;
        for (std::uint32_t k = 0; k < stacks; ++k)
            faces.push_back({k * n + i, k * n + next, (k + 1) * n + next, (k + 1) * n + i});
    }
    MeshBuilder mesh;
    mesh.add(vertices, faces);
    return mesh.take_scene();
}

}  // namespace sightline::families
