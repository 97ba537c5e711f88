// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "skeleton/sweep.hpp"

namespace sightline::detail {

namespace {

bool are_parallel(const SceneForms& forms, EdgeId a, EdgeId b) {
    const Vec3<Integer> n =
        cross(forms.line<Integer>(a.index()).d, forms.line<Integer>(b.index()).d);
    return sgn(n[0]) == 0 && sgn(n[1]) == 0 && sgn(n[2]) == 0;
}

/// Places of the run that fix a point: those with a vertex, or with two edges that cross.
std::vector<std::uint32_t> fixed_places(const SceneForms& forms, const LineCut& cut,
                                        const Run& run) {
    std::vector<std::uint32_t> places;
    const auto contacts = cut.contacts();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact& c = contacts[i];
        if (!run.contains(c.place)) continue;
        bool fixes = c.feature == Feature::vertex;
        for (std::size_t j = 0; c.feature == Feature::edge && j < i && !fixes; ++j) {
            fixes = contacts[j].feature == Feature::edge && contacts[j].place == c.place &&
                    !are_parallel(forms, EdgeId{c.id}, EdgeId{contacts[j].id});
        }
        if (fixes && (places.empty() || places.back() != c.place)) places.push_back(c.place);
    }
    return places;
}

bool is_coplanar(const SceneForms& forms, FaceId a, FaceId b) {
    const PlaneOf<Integer>& p = forms.plane<Integer>(a);
    const PlaneOf<Integer>& q = forms.plane<Integer>(b);
    const PluckerOf<Integer> meet = line_of(p, q);
    const auto zero = [](const Vec3<Integer>& x) {
        return sgn(x[0]) == 0 && sgn(x[1]) == 0 && sgn(x[2]) == 0;
    };
    return zero(meet.d) && zero(meet.m);
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
                         [&](FaceId g) { return is_coplanar(forms, faces[i], g); });
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
    const bool planar = std::ranges::any_of(touched_faces(forms, label.support), [&](FaceId f) {
        return keeps_direction(f, 0) && keeps_direction(f, 1);
    });
    if (fixed_places(forms, cut, run).empty()) return planar ? ArcType::fe : ArcType::eee;
    return planar ? ArcType::fv : ArcType::ev;
}

namespace {

/// Whether two edges of one plane cross inside both: each has its ends on both sides of the other.
bool cross_inside(const SceneForms& forms, EdgeId a, EdgeId b) {
    if (sgn(side(forms.line<Integer>(a.index()), forms.line<Integer>(b.index()))) != 0)
        return false;
    const auto separates = [&](EdgeId by, EdgeId ends) {
        const Edge3& edge = forms.scene()[ends];
        const Vec3<Integer> s =
            normal_from(forms.line<Integer>(by.index()), forms.point<Integer>(edge.source));
        const Vec3<Integer> t =
            normal_from(forms.line<Integer>(by.index()), forms.point<Integer>(edge.target));
        return sgn(dot(s, t)) < 0;
    };
    return separates(a, b) && separates(b, a);
}

}  // namespace

std::vector<std::pair<EdgeId, EdgeId>> edge_crossings(const SceneForms& forms) {
    std::vector<std::pair<EdgeId, EdgeId>> crossings;
    const auto& points = forms.scene().vertices();
    for (std::uint32_t e = 0; e < forms.edge_count(); ++e) {
        const Edge3& edge = forms.scene().edges()[e];
        const Box3 box = Box3::of(points[edge.source.index()], points[edge.target.index()]);
        forms.edges().traverse([&](const Box3& other) { return box.meets(other); },
                               [&](std::uint32_t other) {
                                   if (other >= e) return;
                                   if (forms.scene().edges()[other].body == edge.body) return;
                                   if (!cross_inside(forms, EdgeId{other}, EdgeId{e})) return;
                                   crossings.emplace_back(EdgeId{other}, EdgeId{e});
                               });
    }
    std::ranges::sort(crossings);
    return crossings;
}

}  // namespace sightline::detail
