// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "skeleton/sweep.hpp"

namespace sightline::detail {

namespace {

/// Places of the run that fix a point: those with a vertex, or with two edges that cross.
std::vector<std::uint32_t> fixed_places(const SceneForms& forms, const LineCut& cut,
                                        const Run& run) {
    std::vector<std::uint32_t> places;
    const auto contacts = cut.contacts();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact& c = contacts[i];
        if (!run.contains(c.place)) continue;
        bool fixes = c.feature == Feature::vertex;
        if (c.feature == Feature::edge) {
            fixes = std::ranges::any_of(cut.collinear_edges(),
                                        [&](EdgeId e) { return cut.runs_along(e, c.place); });
        }
        for (std::size_t j = 0; c.feature == Feature::edge && j < i && !fixes; ++j) {
            fixes = contacts[j].feature == Feature::edge && contacts[j].place == c.place &&
                    !forms.are_parallel(EdgeId{c.id}, EdgeId{contacts[j].id});
        }
        if (fixes && (places.empty() || places.back() != c.place)) places.push_back(c.place);
    }
    return places;
}

/// Faces of which the support has a vertex or two edges.
std::vector<FaceId> touched_faces(const SceneForms& forms, const Support& support) {
    std::vector<std::pair<FaceId, int>> touched;
    const auto touch = [&](FaceId f, int weight) {
        if (f.is_none()) return;
        const auto known = std::ranges::find(touched, f, &std::pair<FaceId, int>::first);
        if (known == touched.end()) {
            touched.emplace_back(f, weight);
        } else {
            known->second += weight;
        }
    };
    for (const VertexId v : support.vertices) {
        for (const FaceId f : forms.faces_at(v)) touch(f, 2);
    }
    for (const auto* edges : {&support.edges, &support.along}) {
        for (const EdgeId e : *edges) {
            for (const FaceId f : forms.scene()[e].faces) touch(f, 1);
        }
    }
    std::vector<FaceId> faces;
    for (const auto& [f, weight] : touched) {
        if (weight >= 2) faces.push_back(f);
    }
    std::ranges::sort(faces);
    return faces;
}

std::size_t count_planes(const SceneForms& forms, const std::vector<FaceId>& faces) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const bool is_new =
            std::none_of(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(i),
                         [&](FaceId g) { return forms.are_coplanar(faces[i], g); });
        if (is_new) ++count;
    }
    return count;
}

}  // namespace

SkeletonNode describe_node(const SceneForms& forms, const LineCut& cut, const Run& run,
                           const Line& line, SegmentLabel&& label) {
    SkeletonNode node;
    const std::size_t fixed = fixed_places(forms, cut, run).size();
    for (const FaceId f : touched_faces(forms, label.support)) {
        const Sign sign = line.sign(Predicate::line_form3, [&]<typename N>(const PluckerOf<N>& l) {
            return dot(forms.plane<N>(f).n, l.d);
        });
        if (sign == Sign::zero) node.faces.push_back(f);
    }
    const bool planar = !node.faces.empty();
    node.type = fixed >= 2   ? NodeType::vv
                : fixed == 1 ? (planar ? NodeType::fve : NodeType::vee)
                : planar     ? (count_planes(forms, node.faces) > 1 ? NodeType::ff : NodeType::fee)
                             : NodeType::eeee;
    node.label = std::move(label);
    return node;
}

void find_near_edges(const SceneForms& forms, const LineCut& cut, const Run& run,
                     std::vector<NearEdge>& near) {
    near.clear();
    const auto collinear = cut.collinear_edges();
    for (const Contact& c : cut.contacts()) {
        if (!run.contains(c.place)) continue;
        if (c.feature == Feature::edge) {
            near.push_back({c.place, EdgeId{c.id}, VertexId::none()});
        } else if (c.feature == Feature::vertex) {
            for (const EdgeId e : forms.scene().edges_at(VertexId{c.id})) {
                if (std::ranges::find(collinear, e) != collinear.end()) continue;
                near.push_back({c.place, e, VertexId{c.id}});
            }
        }
    }
}

ArcType arc_type(const Curve& curve, const LineCut& cut, const Run& run,
                 const SegmentLabel& label) {
    if (curve.kind() == CurveKind::regulus) return ArcType::eee;
    const SceneForms& forms = curve.forms();
    const auto keeps_direction = [&](FaceId f, std::size_t i) {
        const auto of = [&]<typename N>(const N&) {
            return dot(forms.plane<N>(f).n, curve.coefficients<N>()[i].d);
        };
        return curve.policy().sign(Predicate::line_form3, of(Real{}),
                                   [&] { return sign_of_integer(of(Integer{})); }) == Sign::zero;
    };
    const auto faces = touched_faces(forms, label.support);
    const bool planar = std::ranges::any_of(
        faces, [&](FaceId f) { return keeps_direction(f, 0) && keeps_direction(f, 1); });
    if (fixed_places(forms, cut, run).empty()) return planar ? ArcType::fe : ArcType::eee;
    return planar ? ArcType::fv : ArcType::ev;
}

CellParts cell_parts(const SceneForms& forms, const LineCut& cut, const Run& run) {
    CellParts parts;
    if (!forms.scene().has_touching_bodies()) return parts;
    std::uint32_t last = Run::none;
    for (const Contact& c : cut.contacts()) {
        if (!run.contains(c.place) || c.feature == Feature::face) continue;
        if (c.place != last) parts.places.emplace_back();
        last = c.place;
        parts.places.back().emplace_back(c.feature, c.id);
        if (c.feature != Feature::edge) continue;
        for (const EdgeId e : cut.collinear_edges()) {
            if (cut.runs_along(e, c.place)) parts.places.back().emplace_back(c.feature, e.value);
        }
    }
    for (auto& place : parts.places) std::ranges::sort(place);
    std::ranges::sort(parts.places);
    parts.contact = cut.contact_faces(run);
    return parts;
}

}  // namespace sightline::detail
