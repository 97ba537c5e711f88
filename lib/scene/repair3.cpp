// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/repair3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "scene/features3.hpp"
#include "scene/union_find.hpp"
#include "scene/winding3.hpp"

namespace sightline {
namespace {

using detail::Corners3;
using Face = std::vector<std::uint32_t>;

/// Repairs one mesh, change by change.
class MeshRepair {
public:
    MeshRepair(MeshInput3& mesh, std::uint32_t number, std::vector<std::string>& changes)
        : mesh_(mesh),
          name_(mesh.file.empty() ? fmt::format("mesh {}", number) : mesh.file),
          changes_(changes) {}

    void run() {
        for (Point3& p : mesh_.vertices) {
            p = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
            // What is not finite, or too large, remains an error.
            if (!(std::abs(p.x) <= 0x1p500 && std::abs(p.y) <= 0x1p500 && std::abs(p.z) <= 0x1p500))
                return;
        }
        for (const Face& face : mesh_.faces)
            for (const std::uint32_t v : face)
                if (v >= mesh_.vertices.size()) return;  // remains an error
        merge_vertices();
        clean_corners();
        remove_slivers();
        remove_double_faces();
        cut_bent_faces();
        if (mesh_.kind == SurfaceKind::solid) {
            align_neighbours();
            turn_outwards();
        }
        remove_isolated();
    }

private:
    void note(std::size_t count, std::string_view what) {
        if (count > 0) changes_.push_back(fmt::format("{}: {} {}", name_, what, count));
    }
    [[nodiscard]] const Point3& at(std::uint32_t v) const { return mesh_.vertices[v]; }

    void merge_vertices() {
        std::vector<std::uint32_t> order(mesh_.vertices.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return at(a) != at(b) ? at(a) < at(b) : a < b;
        });
        std::vector<std::uint32_t> first(order.size());
        std::size_t merged = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const bool same = i > 0 && at(order[i]) == at(order[i - 1]);
            first[order[i]] = same ? first[order[i - 1]] : order[i];
        }
        std::set<std::uint32_t> gone;
        for (Face& face : mesh_.faces)
            for (std::uint32_t& v : face) {
                if (first[v] != v) gone.insert(v);
                v = first[v];
            }
        merged = gone.size();
        note(merged, "vertices merged with others at their place:");
    }

    /// Repeated corners, and corners at which a face goes back the way it came.
    void clean_corners() {
        std::size_t removed = 0;
        for (Face& face : mesh_.faces) {
            const std::size_t before = face.size();
            for (bool changed = true; changed && face.size() >= 3;) {
                changed = false;
                for (std::size_t i = 0; i < face.size() && !changed; ++i) {
                    const std::size_t next = (i + 1) % face.size();
                    const std::size_t after = (i + 2) % face.size();
                    if (face[i] != face[next] && face[i] != face[after]) continue;
                    face.erase(face.begin() + static_cast<std::ptrdiff_t>(next));
                    changed = true;
                }
            }
            removed += before - face.size();
        }
        note(removed, "repeated corners and spikes of faces removed:");
    }

    [[nodiscard]] bool is_sliver(const Face& face) const {
        if (face.size() < 3) return true;
        for (std::size_t i = 2; i < face.size(); ++i)
            if (!detail::are_collinear(at(face[0]), at(face[1]), at(face[i]))) return false;
        return true;
    }

    /// A triangle without area joins an edge to the two pieces of it; without it, its neighbour gets the middle vertex.
    void remove_slivers() {
        std::size_t removed = 0;
        for (std::size_t f = 0; f < mesh_.faces.size();) {
            if (!is_sliver(mesh_.faces[f])) {
                ++f;
                continue;
            }
            Face sliver = std::move(mesh_.faces[f]);
            remove_face(f);
            ++removed;
            if (sliver.size() != 3) continue;
            while (!detail::is_between(at(sliver[0]), at(sliver[1]), at(sliver[2])))
                std::rotate(sliver.begin(), sliver.begin() + 1, sliver.end());
            insert_in_edge(sliver[0], sliver[1], sliver[2]);
        }
        note(removed, "faces without area removed:");
    }

    // The sliver runs c → a; its neighbour a → c.
    void insert_in_edge(std::uint32_t a, std::uint32_t middle, std::uint32_t c) {
        for (Face& face : mesh_.faces)
            for (std::size_t i = 0; i < face.size(); ++i)
                if (face[i] == a && face[(i + 1) % face.size()] == c) {
                    face.insert(face.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
                    return;
                }
    }

    void remove_face(std::size_t f) {
        const auto at = static_cast<std::ptrdiff_t>(f);
        mesh_.faces.erase(mesh_.faces.begin() + at);
        if (f < mesh_.face_lines.size()) mesh_.face_lines.erase(mesh_.face_lines.begin() + at);
    }

    void remove_double_faces() {
        std::set<Face> known;
        std::size_t removed = 0;
        std::vector<Face> kept;
        std::vector<std::uint32_t> lines;
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
            Face turned = mesh_.faces[f];
            std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()),
                        turned.end());
            if (!known.insert(std::move(turned)).second) {
                ++removed;
                continue;
            }
            kept.push_back(std::move(mesh_.faces[f]));
            if (f < mesh_.face_lines.size()) lines.push_back(mesh_.face_lines[f]);
        }
        mesh_.faces = std::move(kept);
        mesh_.face_lines = std::move(lines);
        note(removed, "faces that came twice removed:");
    }

    [[nodiscard]] std::optional<std::array<std::uint32_t, 3>> convex_corner(
        const Face& face) const {
        std::size_t least = 0;
        for (std::size_t i = 1; i < face.size(); ++i)
            if (at(face[i]) < at(face[least])) least = i;
        const std::uint32_t before = face[(least + face.size() - 1) % face.size()];
        const std::uint32_t after = face[(least + 1) % face.size()];
        if (detail::are_collinear(at(before), at(face[least]), at(after))) return std::nullopt;
        return std::array{before, face[least], after};
    }

    void cut_bent_faces() {
        std::size_t cut = 0;
        std::vector<Face> pieces;
        std::vector<std::uint32_t> lines;
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
            const std::size_t before = pieces.size();
            if (cut_bent_face(mesh_.faces[f], pieces)) {
                ++cut;
            } else {
                pieces.push_back(std::move(mesh_.faces[f]));
            }
            if (f < mesh_.face_lines.size())
                lines.resize(lines.size() + pieces.size() - before, mesh_.face_lines[f]);
        }
        mesh_.faces = std::move(pieces);
        mesh_.face_lines = std::move(lines);
        note(cut, "faces that were not planar cut into triangles:");
    }

    bool cut_bent_face(const Face& face, std::vector<Face>& pieces) const {
        const auto corner = face.size() > 3 ? convex_corner(face) : std::nullopt;
        if (!corner) return false;
        const auto& [a, b, c] = *corner;
        const bool bent = std::any_of(face.begin(), face.end(), [&](std::uint32_t v) {
            return detail::orientation3(at(a), at(b), at(c), at(v)) != Sign::zero;
        });
        if (!bent) return false;
        Face3 outline;
        outline.plane = {VertexId{a}, VertexId{b}, VertexId{c}};
        auto& ring = outline.rings.emplace_back();
        for (const std::uint32_t v : face) ring.push_back(VertexId{v});
        const auto triangles = detail::triangulate(mesh_.vertices, outline);
        for (const auto& t : triangles) pieces.push_back({t[0].value, t[1].value, t[2].value});
        return !triangles.empty();
    }

    struct Side {
        std::uint32_t low, high, face;
        bool forward;
    };
    /// The sides of faces, those of one edge together.
    [[nodiscard]] std::vector<Side> sides() const {
        std::vector<Side> all;
        for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
            const Face& face = mesh_.faces[f];
            for (std::size_t i = 0; i < face.size(); ++i) {
                const std::uint32_t u = face[i];
                const std::uint32_t v = face[(i + 1) % face.size()];
                all.push_back({std::min(u, v), std::max(u, v), f, u < v});
            }
        }
        std::sort(all.begin(), all.end(), [](const Side& a, const Side& b) {
            return std::tie(a.low, a.high, a.face, a.forward) <
                   std::tie(b.low, b.high, b.face, b.forward);
        });
        return all;
    }

    /// Turns faces that run along a common edge in the same direction as a face of lower number. Where more than two
    /// faces meet nothing is told of their neighbours.
    void align_neighbours() {
        const std::vector<Side> all = sides();
        std::vector<std::vector<std::pair<std::uint32_t, bool>>> neighbours(mesh_.faces.size());
        for (std::size_t i = 0; i < all.size();) {
            std::size_t end = i + 1;
            while (end < all.size() && all[end].low == all[i].low && all[end].high == all[i].high)
                ++end;
            if (end - i == 2) {
                const bool differs = all[i].forward == all[i + 1].forward;
                neighbours[all[i].face].emplace_back(all[i + 1].face, differs);
                neighbours[all[i + 1].face].emplace_back(all[i].face, differs);
            }
            i = end;
        }
        std::vector<int> turn(mesh_.faces.size(), -1);
        std::size_t turned = 0;
        for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
            if (turn[f] >= 0) continue;
            turn[f] = 0;
            std::vector<std::uint32_t> group{f};
            for (std::size_t i = 0; i < group.size(); ++i)
                for (const auto& [g, differs] : neighbours[group[i]])
                    if (turn[g] < 0) {
                        turn[g] = turn[group[i]] ^ (differs ? 1 : 0);
                        group.push_back(g);
                    }
            turned += turn_the_fewer(group, turn);
        }
        note(turned, "faces turned that did not agree with their neighbours:");
    }

    std::size_t turn_the_fewer(const std::vector<std::uint32_t>& group,
                               const std::vector<int>& turn) {
        const auto ones = std::count_if(group.begin(), group.end(),
                                        [&](std::uint32_t f) { return turn[f] == 1; });
        const int which = 2 * ones > std::ssize(group) ? 0 : 1;
        std::size_t turned = 0;
        for (const std::uint32_t f : group) {
            if (turn[f] != which) continue;
            std::reverse(mesh_.faces[f].begin() + 1, mesh_.faces[f].end());
            ++turned;
        }
        return turned;
    }

    struct Part {
        std::vector<std::uint32_t> faces;
        std::vector<Corners3> triangles;
        Point3 least;
        Sign volume = Sign::zero;
        std::uint32_t outermost =
            0;  ///< the part that surrounds it and isn't surrounded, or itself
    };

    /// Fans do: what they count twice they count once with the other sign.
    [[nodiscard]] std::vector<Part> parts() const {
        detail::UnionFind joined(mesh_.faces.size());
        const std::vector<Side> all = sides();
        for (std::size_t i = 1; i < all.size(); ++i)
            if (all[i].low == all[i - 1].low && all[i].high == all[i - 1].high)
                joined.join(all[i].face, all[i - 1].face);
        std::map<std::uint32_t, Part> by_root;
        for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
            Part& part = by_root[joined.root(f)];
            const Face& face = mesh_.faces[f];
            if (part.faces.empty()) part.least = at(face[0]);
            part.faces.push_back(f);
            for (const std::uint32_t v : face)
                part.least = std::min(part.least, at(v), [](auto& a, auto& b) { return a < b; });
            for (std::size_t i = 2; i < face.size(); ++i)
                part.triangles.push_back({at(face[0]), at(face[i - 1]), at(face[i])});
        }
        std::vector<Part> result;
        for (auto& [root, part] : by_root) {
            part.volume = detail::sign_of_volume(part.triangles);
            result.push_back(std::move(part));
        }
        return result;
    }

    void find_outermost(std::vector<Part>& all) const {
        std::vector<detail::SceneBox3> boxes;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> triangles;
        for (std::uint32_t p = 0; p < all.size(); ++p)
            for (std::uint32_t t = 0; t < all[p].triangles.size(); ++t) {
                boxes.push_back(detail::box_of(all[p].triangles[t]));
                triangles.emplace_back(p, t);
            }
        const detail::SceneBoxTree3 tree(std::move(boxes));
        for (std::uint32_t p = 0; p < all.size(); ++p) {
            detail::SceneBox3 ray = detail::SceneBox3::of(all[p].least);
            ray.low[0] = -std::numeric_limits<double>::infinity();
            std::map<std::uint32_t, int> winding;
            tree.query(ray, [&](std::uint32_t t) {
                const auto [q, k] = triangles[t];
                if (q != p) winding[q] += detail::winding_step(all[q].triangles[k], all[p].least);
            });
            all[p].outermost = p;
            // Of the parts round a point the outermost begins first.
            for (const auto& [q, times] : winding)
                if (times != 0 && all[q].least < all[all[p].outermost].least) all[p].outermost = q;
        }
    }

    void turn_outwards() {
        std::vector<Part> all = parts();
        find_outermost(all);
        std::size_t turned = 0;
        for (const Part& part : all) {
            if (all[part.outermost].volume != Sign::negative) continue;
            for (const std::uint32_t f : part.faces)
                std::reverse(mesh_.faces[f].begin() + 1, mesh_.faces[f].end());
            ++turned;
        }
        note(turned, "solids and cavities turned because they looked the wrong way:");
    }

    void remove_isolated() {
        std::vector<bool> used(mesh_.vertices.size(), false);
        for (const Face& face : mesh_.faces)
            for (const std::uint32_t v : face) used[v] = true;
        std::vector<std::uint32_t> number(used.size());
        std::vector<Point3> kept;
        std::vector<std::uint32_t> lines;
        for (std::uint32_t v = 0; v < used.size(); ++v) {
            number[v] = static_cast<std::uint32_t>(kept.size());
            if (!used[v]) continue;
            kept.push_back(at(v));
            if (v < mesh_.vertex_lines.size()) lines.push_back(mesh_.vertex_lines[v]);
        }
        note(used.size() - kept.size(), "vertices without faces removed:");
        mesh_.vertices = std::move(kept);
        mesh_.vertex_lines = std::move(lines);
        for (Face& face : mesh_.faces)
            for (std::uint32_t& v : face) v = number[v];
    }

    MeshInput3& mesh_;
    std::string name_;
    std::vector<std::string>& changes_;
};

}  // namespace

Result<RepairedScene3> repair(const SceneInput3& input) {
    if (Result<Scene3> scene = Scene3::make(input))
        return RepairedScene3{std::move(*scene), input, {}};
    SceneInput3 repaired = input;
    std::vector<std::string> changes;
    for (std::uint32_t m = 0; m < repaired.meshes.size(); ++m)
        MeshRepair(repaired.meshes[m], m, changes).run();
    Result<Scene3> scene = Scene3::make(repaired);
    if (!scene) return tl::unexpected(std::move(scene.error()));
    return RepairedScene3{std::move(*scene), std::move(repaired), std::move(changes)};
}

}  // namespace sightline
