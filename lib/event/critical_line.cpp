// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/event/critical_line.hpp"

#include <algorithm>
#include <ostream>

namespace sightline {
namespace {

RationalPoint3 place(VertexId v, const Scene3& scene) { return to_rational(scene[v]); }

struct Writer {
    std::ostream& out;

    template <typename... Ids>
    void write(Ids... ids) const {
        ((out << ' ' << to_string(ids)), ...);
    }
    void operator()(const VV& l) const { write(l.first, l.second); }
    void operator()(const FvE& l) const { write(l.face, l.vertex, l.edge); }
    void operator()(const VEE& l) const { write(l.vertex, l.edges[0], l.edges[1]); }
    void operator()(const FF& l) const { write(l.faces[0], l.faces[1]); }
    void operator()(const FEE& l) const { write(l.face, l.edges[0], l.edges[1]); }
    void operator()(const EEEE& l) const { write(l.edges[0], l.edges[1], l.edges[2], l.edges[3]); }
};

/// The line in a plane through two points of it, of which the second may be at infinity.
std::vector<SurdLine3> joined(const ProjectivePoint3& p, const ProjectivePoint3& q) {
    const RationalLine3 line{p.w * q.p - q.w * p.p, cross(p.p, q.p)};
    if (!line.is_line()) return {};
    return {scaled(to_surd(line))};
}

struct Solver {
    const Scene3& scene;

    [[nodiscard]] std::vector<SurdLine3> meeting(const std::vector<RationalPoint3>& points,
                                                 const std::vector<RationalLine3>& lines) const {
        LineFamilies all = families_meeting(points, lines);
        if (all.has_larger || !all.swaths.empty()) return {};
        return std::move(all.isolated);
    }
    /// Where the edge's line crosses the plane; w is zero when it does not.
    [[nodiscard]] ProjectivePoint3 crossing(EdgeId edge, FaceId face) const {
        return meeting_point(carrier(edge, scene), plane_of(face, scene));
    }

    std::vector<SurdLine3> operator()(const VV& l) const {
        return meeting({place(l.first, scene), place(l.second, scene)}, {});
    }
    std::vector<SurdLine3> operator()(const FvE& l) const {
        const RationalPoint3 v = place(l.vertex, scene);
        const ProjectivePoint3 p = crossing(l.edge, l.face);
        const bool in_plane = plane_of(l.face, scene).height(v).sign() == Sign::zero;
        if (!in_plane || !p.is_finite()) return {};
        return joined({vector_to(v), 1}, p);
    }
    std::vector<SurdLine3> operator()(const VEE& l) const {
        return meeting({place(l.vertex, scene)},
                       {carrier(l.edges[0], scene), carrier(l.edges[1], scene)});
    }
    std::vector<SurdLine3> operator()(const FF& l) const {
        const RationalLine3 line =
            line_of(plane_of(l.faces[0], scene), plane_of(l.faces[1], scene));
        if (!line.is_line()) return {};
        return {scaled(to_surd(line))};
    }
    std::vector<SurdLine3> operator()(const FEE& l) const {
        const ProjectivePoint3 p = crossing(l.edges[0], l.face);
        const ProjectivePoint3 q = crossing(l.edges[1], l.face);
        if (!p.is_finite() || !q.is_finite()) return {};
        return joined(p, q);
    }
    std::vector<SurdLine3> operator()(const EEEE& l) const {
        std::vector<RationalLine3> lines;
        for (const EdgeId e : l.edges) lines.push_back(carrier(e, scene));
        return meeting({}, lines);
    }
};

}  // namespace

std::string_view name_of(const CriticalLine& line) noexcept {
    constexpr std::array names{"VV", "FvE", "VEE", "FF", "FEE", "EEEE"};
    return names[line.index()];
}

std::ostream& operator<<(std::ostream& out, const CriticalLine& line) {
    out << name_of(line);
    std::visit(Writer{out}, line);
    return out;
}

std::vector<SurdLine3> lines_of(const CriticalLine& line, const Scene3& scene) {
    return std::visit(Solver{scene}, line);
}

RationalLine3 carrier(EdgeId edge, const Scene3& scene) {
    return line_through(place(scene[edge].source, scene), place(scene[edge].target, scene));
}

Plane3 plane_of(FaceId face, const Scene3& scene) {
    const auto& [a, b, c] = scene[face].plane;
    return plane_through(place(a, scene), place(b, scene), place(c, scene));
}

bool meets_inside(const SurdLine3& line, EdgeId edge, const Scene3& scene) {
    if (side(line, to_surd(carrier(edge, scene))).sign() != Sign::zero) return false;
    // Both are normal to the common plane; opposite when the ends are on different sides.
    const auto across = [&](VertexId v) {
        return cross(to_surd(vector_to(place(v, scene))), line.d) - line.m;
    };
    return dot(across(scene[edge].source), across(scene[edge].target)).sign() == Sign::negative;
}

LineFamilies families_of(const Support& support, const Scene3& scene) {
    std::vector<RationalPoint3> points;
    std::vector<RationalLine3> lines;
    for (const VertexId v : support.vertices) points.push_back(place(v, scene));
    for (const EdgeId e : support.edges) lines.push_back(carrier(e, scene));
    return families_meeting(points, lines);
}

std::vector<SurdLine3> lines_of(const Support& support, const Scene3& scene) {
    return lines_of(support, {}, scene);
}

std::vector<SurdLine3> lines_of(const Support& support, std::span<const FaceId> faces,
                                const Scene3& scene) {
    const LineFamilies all = families_of(support, scene);
    std::vector<SurdLine3> lines = all.isolated;
    std::vector<Plane3> planes;
    for (const FaceId f : faces) planes.push_back(plane_of(f, scene));
    for (const Swath& swath : all.swaths) {
        if (planes.empty() || swath.is_regulus()) continue;
        const RationalLine3 line = line_of(swath.plane(), planes[0]);
        if (swath.contains(line)) lines.push_back(scaled(to_surd(line)));
    }
    std::erase_if(lines, [&](const SurdLine3& line) {
        const auto lies_in = [&](const Plane3& plane) {
            const auto meeting = meeting_point(line, to_surd(plane.normal), Surd(plane.offset));
            return !meeting.is_finite() && meeting.p.is_zero();
        };
        return !std::ranges::all_of(planes, lies_in) ||
               !std::ranges::all_of(support.edges,
                                    [&](EdgeId e) { return meets_inside(line, e, scene); });
    });
    std::ranges::sort(lines);
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return lines;
}

}  // namespace sightline
