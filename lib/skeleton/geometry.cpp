// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/skeleton/geometry.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "sightline/event/critical_line.hpp"
#include "skeleton/surd_line.hpp"
#include "spatial/line_cut.hpp"

namespace sightline {

namespace {

using namespace detail;

RationalPoint3 place(const Scene3& scene, VertexId v) { return to_rational(scene[v]); }

bool is_parallel(const SurdVector3& d, const Plane3& plane) {
    return dot(to_surd(plane.normal), d).sign() == Sign::zero;
}

/// The points where two of these edges cross inside both.
std::vector<RationalPoint3> crossings(const Scene3& scene, const std::vector<EdgeId>& edges) {
    std::vector<RationalPoint3> points;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const RationalLine3 a = carrier(edges[i], scene);
        for (std::size_t j = 0; j < i; ++j) {
            const RationalLine3 b = carrier(edges[j], scene);
            if (!meets_inside(to_surd(a), edges[j], scene)) continue;
            if (!meets_inside(to_surd(b), edges[i], scene)) continue;
            const Vector3 x = meeting_point(a, b).divided();
            points.push_back({x.x, x.y, x.z});
        }
    }
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

std::vector<RationalPoint3> places_of(const Scene3& scene, const Support& support) {
    std::vector<RationalPoint3> points;
    for (const VertexId v : support.vertices) points.push_back(place(scene, v));
    return points;
}

std::vector<RationalLine3> carriers_of(const Scene3& scene, const Support& support) {
    std::vector<RationalLine3> lines;
    for (const EdgeId e : support.edges) lines.push_back(carrier(e, scene));
    return lines;
}

}  // namespace

class SkeletonGeometry::Impl {
public:
    explicit Impl(const Scene3& scene) : scene_(&scene) {}

    std::optional<SurdLine3> line(const SkeletonNode& node) {
        const std::vector<SurdLine3>& lines = lines_of_node(node);
        if (lines.empty()) return std::nullopt;
        const bool is_second = node.root == Root::second && lines.size() > 1;
        return lines[is_second ? 1 : 0];
    }

    std::optional<SkeletonSegment> segment(const SkeletonNode& node) {
        const auto l = line(node);
        return l ? segment_on(*l, node.label) : std::nullopt;
    }

    std::optional<ArcGenerators> generators(const VisibilitySkeleton& skeleton, ArcId arc) {
        const Support& support = skeleton[arc].label.support;
        if (!support.vertices.empty()) {
            const VertexId v = support.vertices.front();
            for (const EdgeId e : support.edges) {
                if (!is_on(carrier(e, *scene_), place(*scene_, v))) return ArcGenerators{{v}, {e}};
            }
            return family_of(skeleton, arc) ? std::optional(ArcGenerators{{v}, {}}) : std::nullopt;
        }
        const auto& edges = support.edges;
        if (edges.size() == 3) return ArcGenerators{{}, edges};
        const auto family = family_of(skeleton, arc);
        if (!family) return std::nullopt;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (std::size_t j = i + 1; j < edges.size(); ++j) {
                for (std::size_t k = j + 1; k < edges.size(); ++k) {
                    ArcGenerators three{{}, {edges[i], edges[j], edges[k]}};
                    if (fixes(three, family->swath)) return three;
                }
            }
        }
        return ArcGenerators{{}, edges};  // with the plane of a contact
    }

    std::vector<RationalLine3> lines(const VisibilitySkeleton& skeleton, ArcId arc,
                                     std::size_t count) {
        const auto family = family_of(skeleton, arc);
        return family ? lines_of_family(*family, skeleton, arc, count)
                      : std::vector<RationalLine3>{};
    }

    bool contains(const VisibilitySkeleton& skeleton, ArcId arc, const SurdLine3& l) {
        const auto family = family_of(skeleton, arc);
        if (!family || !family->swath.contains(l)) return false;
        const auto base = base_of(*family, skeleton, arc);
        if (!base) return false;
        const auto t = position(l, base->source, base->target);
        return t && std::min(base->first, base->last) < *t &&
               *t < std::max(base->first, base->last);
    }

    std::vector<ApproxSegment> approx_segments(const VisibilitySkeleton& skeleton, ArcId arc,
                                               std::size_t count) {
        const auto family = family_of(skeleton, arc);
        if (!family) return {};
        std::vector<ApproxSegment> result;
        const auto add = [&](const SurdLine3& l, const SegmentLabel& label) {
            if (const auto s = segment_on(l, label)) result.push_back(approx_end_points(*s));
        };
        const SkeletonArc& a = skeleton[arc];
        add(family->first, skeleton[a.nodes[0]].label);
        for (const auto& l : lines_of_family(*family, skeleton, arc, count)) {
            add(to_surd(l), a.label);
        }
        add(family->last, skeleton[a.nodes[1]].label);
        return result;
    }

private:
    /// The lines that a node may stand for, ascending: one, or those between which its root decides.
    const std::vector<SurdLine3>& lines_of_node(const SkeletonNode& node) {
        constexpr std::size_t most_remembered = 10'000;
        if (remembered_.size() > most_remembered) remembered_.clear();
        const auto [known, is_new] = remembered_.try_emplace(node);
        if (is_new) known->second = find_lines(node);
        return known->second;
    }

    std::vector<SurdLine3> find_lines(const SkeletonNode& node) {
        const Support& support = node.label.support;
        if (node.root == Root::only) {
            if (const auto l = rational_line(node)) return {scaled(to_surd(*l))};
        }
        if (!support.along.empty()) {
            return {scaled(to_surd(carrier(support.along.front(), *scene_)))};
        }
        LineFamilies families = families_of(support, *scene_);
        auto& lines = families.isolated;
        if (node.root != Root::only && lines.size() == 2) {
            return {std::move(lines[node.root == Root::first ? 0 : 1])};
        }
        if (!families.swaths.empty() || families.has_larger) {
            add_crossing_lines(support, lines);
            add_plane_lines(node, lines);
        }
        keep_fitting(node, lines);
        if (lines.size() > 1) {
            std::erase_if(lines, [&](const SurdLine3& l) { return !has_label(l, node.label); });
        }
        return lines;
    }

    /// Most lines are rational and follow from two points, two planes, or a point of two planes.
    [[nodiscard]] std::optional<RationalLine3> rational_line(const SkeletonNode& node) const {
        const Support& support = node.label.support;
        std::optional<RationalLine3> l;
        if (!support.vertices.empty()) {
            const RationalPoint3 p = place(*scene_, support.vertices.front());
            for (const VertexId v : support.vertices) {
                const RationalPoint3 q = place(*scene_, v);
                if (q != p) l = line_through(p, q);
            }
            if (!l) l = common_line(planes_through(p, node));
        } else if (node.faces.size() == 1) {
            const auto points = points_in(plane_of(node.faces.front(), *scene_), support);
            if (points.size() > 1) l = line_through(points[0], points[1]);
        } else {
            std::vector<Plane3> planes;
            for (const FaceId f : node.faces) planes.push_back(plane_of(f, *scene_));
            l = common_line(planes);
        }
        return l && fits(*l, node) ? l : std::nullopt;
    }

    /// Planes through a vertex in which the line lies: those of the edges that it meets, and of faces.
    [[nodiscard]] std::vector<Plane3> planes_through(const RationalPoint3& p,
                                                     const SkeletonNode& node) const {
        std::vector<Plane3> planes;
        for (const FaceId f : node.faces) planes.push_back(plane_of(f, *scene_));
        for (const EdgeId e : node.label.support.edges) {
            const Plane3 plane = plane_through(p, carrier(e, *scene_));
            if (!plane.is_degenerate()) planes.push_back(plane);
        }
        return planes;
    }

    [[nodiscard]] static std::optional<RationalLine3> common_line(
        const std::vector<Plane3>& planes) {
        for (std::size_t i = 1; i < planes.size(); ++i) {
            const RationalLine3 l = line_of(planes[0], planes[i]);
            if (l.is_line()) return l;
        }
        return std::nullopt;
    }

    [[nodiscard]] bool fits(const RationalLine3& l, const SkeletonNode& node) const {
        const auto is_passed = [&](VertexId v) { return is_on(l, place(*scene_, v)); };
        const auto is_met = [&](EdgeId e) {
            if (side(l, carrier(e, *scene_)).sign() != Sign::zero) return false;
            const auto across = [&](VertexId v) {
                return cross(vector_to(place(*scene_, v)), l.d) - l.m;
            };
            const Edge3& edge = (*scene_)[e];
            return dot(across(edge.source), across(edge.target)).sign() == Sign::negative;
        };
        const auto contains_it = [&](FaceId f) {
            return dot(plane_of(f, *scene_).normal, l.d).sign() == Sign::zero;
        };
        const Support& support = node.label.support;
        return std::ranges::all_of(support.vertices, is_passed) &&
               std::ranges::all_of(support.edges, is_met) &&
               std::ranges::all_of(node.faces, contains_it);
    }

    void keep_fitting(const SkeletonNode& node, std::vector<SurdLine3>& lines) const {
        const Support& support = node.label.support;
        std::erase_if(lines, [&](const SurdLine3& l) {
            const auto is_met = [&](EdgeId e) { return meets_inside(l, e, *scene_); };
            const auto is_passed = [&](VertexId v) {
                return is_on(l, to_surd(vector_to(place(*scene_, v))));
            };
            const auto contains_it = [&](FaceId f) {
                return is_parallel(l.d, plane_of(f, *scene_));
            };
            return !std::ranges::all_of(node.faces, contains_it) ||
                   !std::ranges::all_of(support.edges, is_met) ||
                   !std::ranges::all_of(support.vertices, is_passed);
        });
        std::ranges::sort(lines);
        lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    }

    /// Lines that pass through one or two crossings of the support's edges besides.
    void add_crossing_lines(const Support& support, std::vector<SurdLine3>& lines) const {
        const auto points = crossings(*scene_, support.edges);
        const auto carriers = carriers_of(*scene_, support);
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t j = i; j < points.size(); ++j) {
                auto places = places_of(*scene_, support);
                places.insert(places.end(), {points[i], points[j]});
                const auto more = families_meeting(places, carriers).isolated;
                lines.insert(lines.end(), more.begin(), more.end());
            }
        }
    }

    /// Lines in planes that the support touches: through points where vertices and edges of it
    /// meet such a plane, or in two of the planes.
    void add_plane_lines(const SkeletonNode& node, std::vector<SurdLine3>& lines) const {
        const Support& support = node.label.support;
        std::vector<Plane3> planes;
        for (const FaceId f : node.faces) planes.push_back(plane_of(f, *scene_));
        const auto others = planes_at(support);
        planes.insert(planes.end(), others.begin(), others.end());
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const auto points = points_in(planes[i], support);
            for (std::size_t j = 0; j < points.size(); ++j) {
                for (std::size_t k = 0; k < j; ++k) {
                    lines.push_back(scaled(to_surd(line_through(points[k], points[j]))));
                }
            }
            for (std::size_t j = 0; j < i; ++j) {
                const RationalLine3 l = line_of(planes[j], planes[i]);
                if (l.is_line()) lines.push_back(scaled(to_surd(l)));
            }
        }
    }

    /// Planes of faces beside the support's edges and vertices, and of two edges at one vertex.
    [[nodiscard]] std::vector<Plane3> planes_at(const Support& support) const {
        std::set<FaceId> faces;
        std::vector<Plane3> planes;
        const auto add = [&](EdgeId e) {
            for (const FaceId f : (*scene_)[e].faces) {
                if (!f.is_none() && faces.insert(f).second) planes.push_back(plane_of(f, *scene_));
            }
        };
        for (const EdgeId e : support.edges) add(e);
        for (const VertexId v : support.vertices) {
            const auto edges = scene_->edges_at(v);
            for (std::size_t i = 0; i < edges.size(); ++i) {
                add(edges[i]);
                for (std::size_t j = 0; j < i; ++j) {
                    const Vector3 normal =
                        cross(carrier(edges[i], *scene_).d, carrier(edges[j], *scene_).d);
                    if (normal.is_zero()) continue;
                    planes.push_back({normal, dot(normal, vector_to(place(*scene_, v)))});
                }
            }
        }
        return planes;
    }

    [[nodiscard]] std::vector<RationalPoint3> points_in(const Plane3& plane,
                                                        const Support& support) const {
        std::vector<RationalPoint3> points;
        for (const VertexId v : support.vertices) {
            const RationalPoint3 p = place(*scene_, v);
            if (plane.height(p).sign() == Sign::zero) points.push_back(p);
        }
        for (const EdgeId e : support.edges) {
            const auto x = meeting_point(carrier(e, *scene_), plane);
            if (!x.is_finite()) continue;
            const Vector3 p = x.divided();
            points.push_back({p.x, p.y, p.z});
        }
        std::ranges::sort(points);
        points.erase(std::unique(points.begin(), points.end()), points.end());
        return points;
    }

    // ---- families ---------------------------------------------------------------------------------

    [[nodiscard]] std::vector<Swath> candidate_swaths(const Support& support) const {
        std::vector<Swath> swaths = families_of(support, *scene_).swaths;
        if (!support.vertices.empty()) return swaths;
        const auto carriers = carriers_of(*scene_, support);
        for (const RationalPoint3& x : crossings(*scene_, support.edges)) {
            const auto more = families_meeting({x}, carriers).swaths;
            swaths.insert(swaths.end(), more.begin(), more.end());
        }
        return swaths;
    }

    /// An arc's lines, and the first and last of their closure.
    struct Family {
        Swath swath;
        SurdLine3 first;
        SurdLine3 last;
    };

    std::optional<Family> family_of(const VisibilitySkeleton& skeleton, ArcId arc) {
        const SkeletonArc& a = skeleton[arc];
        const auto first = lines_among_arcs(skeleton, a.nodes[0]);
        const auto last = lines_among_arcs(skeleton, a.nodes[1]);
        auto family = family_among(candidate_swaths(a.label.support), first, last);
        return family ? family : family_among(contact_swaths(a.label), first, last);
    }

    /// Whether three edges, two of which may cross, leave this family and no larger one.
    [[nodiscard]] bool fixes(const ArcGenerators& g, const Swath& swath) const {
        const auto swaths = candidate_swaths({{}, g.edges, {}});
        return std::ranges::find(swaths, swath) != swaths.end();
    }

    /// Two points of a line that every line of the family meets in a point of its own, and where the first and the
    /// last do: 0 at `source`, 1 at `target`.
    struct Base {
        RationalPoint3 source;
        RationalPoint3 target;
        Surd first;
        Surd last;
    };

    std::optional<Base> base_of(const Family& family, const VisibilitySkeleton& skeleton,
                                ArcId arc) {
        const Swath& swath = family.swath;
        for (const EdgeId e : skeleton[arc].label.support.edges) {
            const RationalLine3 l = carrier(e, *scene_);
            if (!swath.all_meet(l) || swath.contains(l)) continue;
            if (!swath.is_regulus() && is_on(l, swath.centre())) continue;
            const RationalPoint3 source = place(*scene_, (*scene_)[e].source);
            const RationalPoint3 target = place(*scene_, (*scene_)[e].target);
            const auto first = position(family.first, source, target);
            const auto last = position(family.last, source, target);
            if (first && last) return Base{source, target, *first, *last};
        }
        return base_across(family, skeleton, arc);
    }

    /// Across that one of the two sectors between the first and the last line of a pencil whose lines have the
    /// arc's label.
    std::optional<Base> base_across(const Family& family, const VisibilitySkeleton& skeleton,
                                    ArcId arc) {
        if (family.swath.is_regulus() || !family.swath.centre().is_finite()) return std::nullopt;
        const Vector3 centre = family.swath.centre().divided();
        const auto at = [&](const Vector3& d) {
            return RationalPoint3{centre.x + d.x, centre.y + d.y, centre.z + d.z};
        };
        const auto first = rational_direction(family.first);
        const auto last = rational_direction(family.last);
        if (!first || !last) return std::nullopt;
        for (const Vector3& other : {*last, -*last}) {
            const RationalLine3 middle = line_through(at({0, 0, 0}), at(*first + other));
            if (!has_label(to_surd(middle), skeleton[arc].label)) continue;
            return Base{at(*first), at(other), Surd(0), Surd(1)};
        }
        return std::nullopt;
    }

    static std::optional<Vector3> rational_direction(const SurdLine3& l) {
        const SurdVector3& d = l.d;
        if (!d.x.is_rational() || !d.y.is_rational() || !d.z.is_rational()) return std::nullopt;
        return Vector3{d.x.rational_part(), d.y.rational_part(), d.z.rational_part()};
    }

    /// Where a line meets the line of two points; empty for parallels.
    [[nodiscard]] static std::optional<Surd> position(const SurdLine3& l,
                                                      const RationalPoint3& source,
                                                      const RationalPoint3& target) {
        const auto x = meeting_point(l, to_surd(line_through(source, target)));
        if (!x.is_finite()) return std::nullopt;
        const SurdVector3 d = to_surd(target - source);
        return dot(x.divided() - to_surd(vector_to(source)), d) / dot(d, d);
    }

    /// The lines that a node may stand for, less those that some arc at it can't end in.
    std::vector<SurdLine3> lines_among_arcs(const VisibilitySkeleton& skeleton, NodeId n) {
        std::vector<SurdLine3> lines = lines_of_node(skeleton[n]);
        if (lines.size() < 2) return lines;
        for (const ArcId a : skeleton.arcs_at(n)) {
            auto swaths = candidate_swaths(skeleton[a].label.support);
            for (Swath& swath : contact_swaths(skeleton[a].label))
                swaths.push_back(std::move(swath));
            std::erase_if(lines, [&](const SurdLine3& l) {
                return std::ranges::none_of(swaths, [&](const Swath& s) { return s.contains(l); });
            });
        }
        return lines;
    }

    static std::optional<Family> family_among(std::vector<Swath> swaths,
                                              const std::vector<SurdLine3>& first,
                                              const std::vector<SurdLine3>& last) {
        for (Swath& swath : swaths) {
            for (const SurdLine3& from : first) {
                for (const SurdLine3& to : last) {
                    if (!swath.contains(from) || !swath.contains(to) || from == to) continue;
                    return Family{std::move(swath), from, to};
                }
            }
        }
        return std::nullopt;
    }

    /// Pencils in planes of faces at the ends: behind an end the lines may run between bodies in contact.
    [[nodiscard]] std::vector<Swath> contact_swaths(const SegmentLabel& label) const {
        const Support& support = label.support;
        std::vector<Swath> swaths;
        for (const SegmentEnd& end : label.ends) {
            for (const FaceSide& side : end) {
                const Plane3 plane = plane_of(side.face, *scene_);
                auto points = points_in(plane, support);
                if (support.vertices.empty()) {
                    for (const RationalPoint3& x : crossings(*scene_, support.edges)) {
                        if (plane.height(x).sign() == Sign::zero) points.push_back(x);
                    }
                }
                for (const RationalPoint3& x : points) {
                    swaths.push_back(Swath::pencil({vector_to(x), 1}, plane));
                }
            }
        }
        return swaths;
    }

    std::vector<RationalLine3> lines_of_family(const Family& family,
                                               const VisibilitySkeleton& skeleton, ArcId arc,
                                               std::size_t count) {
        const auto base = base_of(family, skeleton, arc);
        if (!base) return {};
        const LineCurve3 curve = family.swath.along(base->source, base->target);
        const auto [least, greatest] = std::minmax(base->first, base->last);
        const double from = base->first.approx_double();
        const double step = (base->last.approx_double() - from) / static_cast<double>(count + 1);
        std::vector<RationalLine3> result;
        for (std::size_t i = 1; i <= count; ++i) {
            const Rational t(from + step * static_cast<double>(i));
            const bool is_between = least < Surd(t) && Surd(t) < greatest;
            RationalLine3 l = curve.at(t);
            if (is_between && l.is_line()) result.push_back(std::move(l));
        }
        return result;
    }

    // ---- ends -------------------------------------------------------------------------------------

    /// Where a line crosses the plane of one of the faces; empty when it lies in all of them.
    [[nodiscard]] std::optional<SurdVector3> piercing(const SurdLine3& l,
                                                      const SegmentEnd& end) const {
        for (const FaceSide& f : end) {
            const Plane3 plane = plane_of(f.face, *scene_);
            if (is_parallel(l.d, plane)) continue;
            return meeting_point(l, to_surd(plane.normal), Surd(plane.offset)).divided();
        }
        return std::nullopt;
    }

    std::optional<SkeletonSegment> segment_on(const SurdLine3& l, const SegmentLabel& label) {
        SkeletonSegment result{scaled(l), {}};
        for (std::size_t i = 0; i < 2; ++i) {
            if (label.ends[i].empty()) continue;
            const auto x = piercing(result.line, label.ends[i]);
            if (!x) return cut_segment(result.line, label);
            result.ends[i].at = *x;
        }
        set_infinite_ends(label, result);
        return result;
    }

    /// Ends at infinity; the other end, if any, is known.
    void set_infinite_ends(const SegmentLabel& label, SkeletonSegment& result) const {
        const SurdVector3& d = result.line.d;
        // Sorted ends: infinity comes first.
        if (!label.ends[0].empty()) return;
        if (label.ends[1].empty()) {
            result.ends = {SkeletonSegmentEnd{true, -d}, SkeletonSegmentEnd{true, d}};
            return;
        }
        Sign towards = Sign::positive;
        for (const SurdVector3& x : contacts(result.line, label.support)) {
            const Sign side = dot(x - result.ends[1].at, d).sign();
            if (side != Sign::zero) towards = side;
        }
        result.ends[0] = {true, towards == Sign::negative ? -d : d};
    }

    [[nodiscard]] std::vector<SurdVector3> contacts(const SurdLine3& l,
                                                    const Support& support) const {
        std::vector<SurdVector3> points;
        for (const VertexId v : support.vertices) {
            points.push_back(to_surd(vector_to(place(*scene_, v))));
        }
        for (const EdgeId e : support.edges) {
            const auto x = meeting_point(l, to_surd(carrier(e, *scene_)));
            if (x.is_finite()) points.push_back(x.divided());
        }
        return points;
    }

    // ---- what only a shot along the line can tell ------------------------------------------------------

    void prepare() {
        if (cut_) return;
        forms_ = std::make_unique<SceneForms>(*scene_);
        cut_ = std::make_unique<LineCut>(*forms_);
    }

    bool has_label(const SurdLine3& l, const SegmentLabel& label) {
        prepare();
        const SurdLineSource source(l, *forms_);
        const Line line(source.real_line(), source, policy_);
        cut_->cut(line);
        return std::ranges::any_of(cut_->runs(),
                                   [&](const Run& run) { return cut_->label(run) == label; });
    }

    std::optional<SkeletonSegment> cut_segment(const SurdLine3& l, const SegmentLabel& label) {
        prepare();
        const SurdLineSource source(l, *forms_);
        const Line line(source.real_line(), source, policy_);
        cut_->cut(line);
        for (const Run& run : cut_->runs()) {
            if (cut_->label(run) != label) continue;
            SkeletonSegment result{l, {end_of(l, run.first), end_of(l, run.last)}};
            if (result.ends[0].is_infinite) result.ends[0].at = -l.d;
            const bool swapped =
                !touches(run.first, label.ends[0]) || !touches(run.last, label.ends[1]);
            if (swapped) std::swap(result.ends[0], result.ends[1]);
            return result;
        }
        return std::nullopt;
    }

    /// The point of a place of the line that has been cut; without one, the line's direction.
    [[nodiscard]] SkeletonSegmentEnd end_of(const SurdLine3& l, std::uint32_t place_index) const {
        if (place_index == Run::none) return {true, l.d};
        const auto contacts = cut_->contacts();
        const auto c = std::ranges::find(contacts, place_index, &Contact::place);
        if (c->feature == Feature::vertex) {
            return {false, to_surd(vector_to(place(*scene_, VertexId{c->id})))};
        }
        if (c->feature == Feature::edge) {
            return {false, meeting_point(l, to_surd(carrier(EdgeId{c->id}, *scene_))).divided()};
        }
        const Plane3 plane = plane_of(FaceId{c->id}, *scene_);
        return {false, meeting_point(l, to_surd(plane.normal), Surd(plane.offset)).divided()};
    }

    /// Whether all faces of an end are at a place; infinity is nowhere.
    [[nodiscard]] bool touches(std::uint32_t place_index, const SegmentEnd& end) const {
        if (place_index == Run::none || end.empty()) {
            return place_index == Run::none && end.empty();
        }
        std::set<FaceId> faces;
        for (const Contact& c : cut_->contacts()) {
            if (c.place != place_index) continue;
            if (c.feature == Feature::face) faces.insert(FaceId{c.id});
            if (c.feature == Feature::edge) {
                const auto& beside = (*scene_)[EdgeId{c.id}].faces;
                faces.insert(beside.begin(), beside.end());
            }
            if (c.feature == Feature::vertex) {
                const auto& round = forms_->faces_at(VertexId{c.id});
                faces.insert(round.begin(), round.end());
            }
        }
        return std::ranges::all_of(end, [&](FaceSide f) { return faces.contains(f.face); });
    }

    const Scene3* scene_;
    Policy policy_;
    std::map<SkeletonNode, std::vector<SurdLine3>> remembered_;
    std::unique_ptr<SceneForms> forms_;
    std::unique_ptr<LineCut> cut_;
};

SkeletonGeometry::SkeletonGeometry(const Scene3& scene) : impl_(std::make_unique<Impl>(scene)) {}
SkeletonGeometry::SkeletonGeometry(SkeletonGeometry&& other) noexcept = default;
SkeletonGeometry& SkeletonGeometry::operator=(SkeletonGeometry&& other) noexcept = default;
SkeletonGeometry::~SkeletonGeometry() = default;

std::optional<SurdLine3> SkeletonGeometry::line(const SkeletonNode& node) {
    return impl_->line(node);
}

std::optional<SkeletonSegment> SkeletonGeometry::segment(const SkeletonNode& node) {
    return impl_->segment(node);
}

std::optional<ArcGenerators> SkeletonGeometry::generators(const VisibilitySkeleton& skeleton,
                                                          ArcId arc) {
    return impl_->generators(skeleton, arc);
}

std::vector<RationalLine3> SkeletonGeometry::lines(const VisibilitySkeleton& skeleton, ArcId arc,
                                                   std::size_t count) {
    return impl_->lines(skeleton, arc, count);
}

bool SkeletonGeometry::contains(const VisibilitySkeleton& skeleton, ArcId arc,
                                const SurdLine3& line) {
    return impl_->contains(skeleton, arc, line);
}

std::vector<ApproxSegment> SkeletonGeometry::approx_segments(const VisibilitySkeleton& skeleton,
                                                             ArcId arc, std::size_t count) {
    return impl_->approx_segments(skeleton, arc, count);
}

ApproxSegment approx_end_points(const SkeletonSegment& segment) {
    const auto rounded = [](const SurdVector3& x) {
        return Point3{x.x.approx_double(), x.y.approx_double(), x.z.approx_double()};
    };
    ApproxSegment result;
    for (std::size_t i = 0; i < 2; ++i) {
        result.ends[i] = rounded(segment.ends[i].at);
        result.is_infinite[i] = segment.ends[i].is_infinite;
    }
    const auto& [d, m] = segment.line;
    result.through = !result.is_infinite[0]   ? result.ends[0]
                     : !result.is_infinite[1] ? result.ends[1]
                                              : rounded((Surd(1) / dot(d, d)) * cross(d, m));
    return result;
}

SurdLine3 plucker(const Scene3& scene, const SkeletonNode& node) {
    const auto line = SkeletonGeometry(scene).line(node);
    SIGHTLINE_EXPECT(line.has_value());
    return *line;
}

SkeletonSegment segment(const Scene3& scene, const SkeletonNode& node) {
    const auto segment = SkeletonGeometry(scene).segment(node);
    SIGHTLINE_EXPECT(segment.has_value());
    return *segment;
}

}  // namespace sightline
