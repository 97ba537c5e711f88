// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sightline::detail {
namespace {

constexpr double largest_coordinate = 0x1p500;

std::string origin(const SceneInput3& input, std::uint32_t mesh,
                   const std::vector<std::uint32_t>& lines, std::uint32_t local) {
    const MeshInput3& m = input.meshes[mesh];
    std::string text = m.file;
    if (local < lines.size())
        text += fmt::format("{}{}", text.empty() ? "line " : ":", lines[local]);
    if (text.empty() && input.meshes.size() > 1) text = fmt::format("mesh {}", mesh);
    return text.empty() ? text : text + ": ";
}

/// Puts the input together mesh by mesh; stops at the first error.
class Layout3 {
public:
    explicit Layout3(const SceneInput3& input) { mesh_.input = &input; }

    Result<Mesh3> run() {
        const auto& meshes = mesh_.input->meshes;
        for (std::uint32_t m = 0; m < meshes.size(); ++m) {
            mesh_.first_vertex.push_back(static_cast<std::uint32_t>(mesh_.vertices.size()));
            mesh_.first_face.push_back(mesh_.face_count());
            if (const auto ok = add_vertices(meshes[m]); !ok) return tl::unexpected(ok.error());
            for (const auto& face : meshes[m].faces)
                if (const auto ok = add_face(m, face); !ok) return tl::unexpected(ok.error());
        }
        mesh_.first_vertex.push_back(static_cast<std::uint32_t>(mesh_.vertices.size()));
        mesh_.first_face.push_back(mesh_.face_count());
        mesh_.first_half.push_back(static_cast<std::uint32_t>(mesh_.halves.size()));
        if (mesh_.face_count() == 0) {
            const std::string file = meshes.empty() ? "" : meshes.front().file;
            return fail(Errc::empty_scene,
                        (file.empty() ? "" : file + ": ") +
                            "the scene has no faces; give at least one mesh with faces");
        }
        return std::move(mesh_);
    }

private:
    Result<void> add_vertices(const MeshInput3& m) {
        for (const Point3& p : m.vertices) {
            mesh_.vertices.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});  // -0.0 becomes 0.0
            const auto v = static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
            for (const double x : {p.x, p.y, p.z}) {
                if (!std::isfinite(x)) {
                    return fail(Errc::not_finite,
                                mesh_.name_of_vertex(v) +
                                    ": is not finite; give a number for each coordinate");
                }
                if (std::abs(x) > largest_coordinate) {
                    return fail(
                        Errc::coordinate_too_large,
                        mesh_.name_of_vertex(v) +
                            ": is larger than 2^500; scale the scene down by a power of two");
                }
            }
        }
        return {};
    }

    Result<void> add_face(std::uint32_t m, const std::vector<std::uint32_t>& corners) {
        const std::uint32_t face = mesh_.face_count();
        const auto first = static_cast<std::uint32_t>(mesh_.halves.size());
        const auto n = static_cast<std::uint32_t>(corners.size());
        const std::uint32_t base = mesh_.first_vertex[m];
        const auto vertex_count = mesh_.input->meshes[m].vertices.size();
        mesh_.mesh_of_face.push_back(m);
        mesh_.first_half.push_back(first);
        for (const std::uint32_t c : corners) {
            if (c >= vertex_count) {
                return fail(
                    Errc::unknown_vertex,
                    fmt::format(
                        "{}: names vertex {}, but there are {} vertices; correct the number",
                        mesh_.name_of_face(face), c, vertex_count));
            }
        }
        if (n < 3) {
            return fail(Errc::too_few_vertices,
                        fmt::format("{}: has {} vertices; give at least 3, or remove it",
                                    mesh_.name_of_face(face), n));
        }
        const bool turned = mesh_.input->world && m == 0;
        const auto corner = [&](std::uint32_t i) { return base + corners[turned ? n - 1 - i : i]; };
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t next = i + 1 == n ? 0 : i + 1;
            mesh_.halves.push_back({corner(i), corner(next), face, first + next});
        }
        return check_face(face);
    }

    Result<void> check_face(std::uint32_t face) {
        const std::uint32_t first = mesh_.first_half[face];
        const auto end = static_cast<std::uint32_t>(mesh_.halves.size());
        std::uint32_t least = first;  // its source is an extreme point, so its corner is convex
        std::uint32_t before = end - 1;
        for (std::uint32_t h = first; h < end; ++h) {
            const HalfEdge3& half = mesh_.halves[h];
            if (half.source == half.target || at(half.source) == at(half.target)) {
                return fail(
                    Errc::repeated_vertex,
                    fmt::format("{}: repeats {}; remove one of the two", mesh_.name_of_face(face),
                                mesh_.short_name_of_vertex(half.source)));
            }
            if (at(half.source) < at(mesh_.halves[least].source)) {
                least = h;
                before = h == first ? end - 1 : h - 1;
            }
        }
        const Point3& a = at(mesh_.halves[before].source);
        const Point3& b = at(mesh_.halves[least].source);
        const Point3& c = at(mesh_.halves[least].target);
        if (are_collinear(a, b, c)) {
            return fail(
                Errc::degenerate_face,
                fmt::format(
                    "{}: has no area at {} (its vertices are collinear, or it has a spike); "
                    "remove the face or the spike",
                    mesh_.name_of_face(face),
                    mesh_.short_name_of_vertex(mesh_.halves[least].source)));
        }
        mesh_.planes.push_back(Plane3::through(a, b, c));
        if (end - first > 3) return check_planar(face, first, end);
        return {};
    }

    Result<void> check_planar(std::uint32_t face, std::uint32_t first, std::uint32_t end) const {
        const Plane3& plane = mesh_.planes[face];
        for (std::uint32_t h = first; h < end; ++h) {
            const Point3& p = at(mesh_.halves[h].source);
            if (p == plane.points[0] || p == plane.points[1] || p == plane.points[2]) continue;
            if (plane.side(p) != Sign::zero) {
                return fail(
                    Errc::non_planar,
                    fmt::format("{}: is not planar: {} is not in the plane of three others; "
                                "triangulate the face",
                                mesh_.name_of_face(face),
                                mesh_.short_name_of_vertex(mesh_.halves[h].source)));
            }
        }
        return {};
    }

    [[nodiscard]] const Point3& at(std::uint32_t v) const { return mesh_.vertices[v]; }

    Mesh3 mesh_;
};

}  // namespace

std::uint32_t Mesh3::mesh_of_vertex(std::uint32_t v) const {
    const auto after = std::upper_bound(first_vertex.begin(), first_vertex.end(), v);
    // Empty meshes share their first vertex's number with the next; the last of them owns it.
    return static_cast<std::uint32_t>(after - first_vertex.begin()) - 1;
}

std::string Mesh3::short_name_of_face(std::uint32_t face) const {
    return fmt::format("face {}", face - first_face[mesh_of_face[face]]);
}

std::string Mesh3::short_name_of_vertex(std::uint32_t v) const {
    const Point3& p = vertices[v];
    return fmt::format("vertex {} ({}, {}, {})", v - first_vertex[mesh_of_vertex(v)], p.x, p.y,
                       p.z);
}

std::string Mesh3::short_name_of_edge(std::uint32_t half) const {
    const std::uint32_t base = first_vertex[mesh_of_face[halves[half].face]];
    const auto [u, v] = std::minmax(halves[half].source, halves[half].target);
    return fmt::format("edge [{}, {}]", u - base, v - base);
}

std::string Mesh3::name_of_face(std::uint32_t face) const {
    const std::uint32_t m = mesh_of_face[face];
    return origin(*input, m, input->meshes[m].face_lines, face - first_face[m]) +
           short_name_of_face(face);
}

std::string Mesh3::name_of_vertex(std::uint32_t v) const {
    const std::uint32_t m = mesh_of_vertex(v);
    return origin(*input, m, input->meshes[m].vertex_lines, v - first_vertex[m]) +
           short_name_of_vertex(v);
}

Result<Mesh3> lay_out(const SceneInput3& input) { return Layout3(input).run(); }

}  // namespace sightline::detail
