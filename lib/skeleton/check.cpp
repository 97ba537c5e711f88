// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/skeleton/check.hpp"

#include <algorithm>
#include <numeric>
#include <ostream>
#include <set>
#include <sstream>

#include "sightline/event/critical_line.hpp"
#include "sightline/skeleton/geometry.hpp"
#include "skeleton/check_path.hpp"
#include "skeleton/surd_line.hpp"
#include "spatial/line_cut.hpp"

namespace sightline {

namespace {

using namespace detail;

constexpr std::size_t most_mismatches = 20;

/// The labels of the maximal free segments that touch a family's generators; at a vertex there may be two.
using Labels = std::vector<SegmentLabel>;

/// Where several faces of a sheet meet at an end, their sides change with the line's direction although no other
/// feature is touched; that is no crossing.
SegmentLabel without_sides(SegmentLabel label) {
    for (SegmentEnd& end : label.ends) {
        if (end.size() < 2) continue;
        for (FaceSide& side : end) side.back = false;
        std::ranges::sort(end);
    }
    std::ranges::sort(label.ends);
    return label;
}

/// Cuts lines of a path.
class Shooter {
public:
    explicit Shooter(const Scene3& scene) : forms_(scene), cut_(forms_) {}

    Labels labels(const LineFamily2& family, const SurdLine3& l) {
        ++shots_;
        const SurdLineSource source(l, forms_);
        const Line line(source.real_line(), source, policy_);
        cut_.cut(line);
        std::uint32_t first = Run::none;
        std::uint32_t last = Run::none;
        if (family.vertex) {
            first = last = cut_.place_of(*family.vertex);
        } else {
            first = cut_.place_of(family.edges->first);
            last = cut_.place_of(family.edges->second);
        }
        if (first == Run::none || last == Run::none) return {};
        Labels result;
        for (const Run& run : cut_.runs()) {
            if (run.contains(first) && run.contains(last))
                result.push_back(without_sides(cut_.label(run)));
        }
        std::ranges::sort(result);
        return result;
    }
    [[nodiscard]] std::size_t shots() const { return shots_; }
    [[nodiscard]] const SceneForms& forms() const { return forms_; }

private:
    SceneForms forms_;
    LineCut cut_;
    Policy policy_;
    std::size_t shots_ = 0;
};

/// Arcs by the features of their support.
class ArcIndex {
public:
    ArcIndex(const Scene3& scene, const VisibilitySkeleton& skeleton)
        : vertices_(scene.vertices().size()), edges_(scene.edges().size()) {
        for (std::uint32_t a = 0; a < skeleton.arcs().size(); ++a) {
            const Support& support = skeleton[ArcId{a}].label.support;
            for (const VertexId v : support.vertices) vertices_[v].push_back(ArcId{a});
            for (const EdgeId e : support.edges) edges_[e].push_back(ArcId{a});
        }
    }
    /// Ascending.
    [[nodiscard]] std::vector<ArcId> arcs_in(const LineFamily2& family) const {
        if (family.vertex) return vertices_[*family.vertex];
        std::vector<ArcId> both;
        std::ranges::set_intersection(edges_[family.edges->first], edges_[family.edges->second],
                                      std::back_inserter(both));
        return both;
    }
    [[nodiscard]] const std::vector<ArcId>& arcs_at(EdgeId e) const { return edges_[e]; }
    [[nodiscard]] const std::vector<ArcId>& arcs_at(VertexId v) const { return vertices_[v]; }

private:
    PerVertex<std::vector<ArcId>> vertices_;
    PerEdge<std::vector<ArcId>> edges_;
};

/// A line of a path that meets something else besides the generators.
struct Event {
    Surd t;
    std::set<ArcId> arcs;  ///< that touch what it meets
};

class Checker {
public:
    Checker(const Scene3& scene, const VisibilitySkeleton& skeleton,
            const SkeletonCheckOptions& options)
        : scene_(scene),
          skeleton_(skeleton),
          options_(options),
          random_(options.seed),
          maker_(scene, random_),
          shooter_(scene),
          index_(scene, skeleton),
          geometry_(scene),
          order_(skeleton.arcs().size()) {
        std::iota(order_.begin(), order_.end(), 0U);
        for (std::size_t i = order_.size(); i > 1; --i) {
            std::swap(order_[i - 1], order_[random_.index(i)]);
        }
        for (std::uint32_t v = 0; v < scene.vertices().size(); ++v) {
            if (scene.is_feature(VertexId{v})) features_.push_back(VertexId{v});
        }
    }

    Result<SkeletonCheck> run(const Limits& limits) {
        for (std::size_t i = 0; i < options_.families; ++i) {
            if (limits.stop && limits.stop()) {
                return fail(Errc::cancelled, "stopped after " + std::to_string(i) + " of " +
                                                 std::to_string(options_.families) +
                                                 " families of lines");
            }
            if (limits.progress) {
                limits.progress(static_cast<double>(i) / static_cast<double>(options_.families));
            }
            const bool aims = i % 2 == 0 && !order_.empty();
            const auto path = aims ? path_across(ArcId{order_[i / 2 % order_.size()]}) : any_path();
            if (!path) continue;
            ++result_.families;
            walk(*path);
        }
        result_.shots = shooter_.shots();
        return std::move(result_);
    }

private:
    // ---- paths ------------------------------------------------------------------------------------

    [[nodiscard]] bool are_skew(EdgeId e, EdgeId f) const {
        return side(carrier(e, scene_), carrier(f, scene_)).sign() != Sign::zero;
    }

    std::optional<LinePath> path_across(ArcId arc) {
        const Support& support = skeleton_[arc].label.support;
        const auto lines = geometry_.lines(skeleton_, arc, 1 + random_.index(3));
        if (lines.empty()) {
            // Too short for doubles; one without coordinates is no arc.
            if (!geometry_.generators(skeleton_, arc)) report_false(arc, "has no lines at all");
            return std::nullopt;
        }
        const RationalLine3& through = lines[random_.index(lines.size())];
        std::vector<std::pair<EdgeId, EdgeId>> pairs;
        for (const EdgeId e : support.edges) {
            for (const EdgeId f : support.edges) {
                if (e < f && are_skew(e, f)) pairs.emplace_back(e, f);
            }
        }
        const std::size_t choices = support.vertices.size() + pairs.size();
        if (choices == 0) return any_path();  // lines of one plane through a point of contact
        const std::size_t choice = random_.index(choices);
        if (choice < support.vertices.size()) {
            return maker_.through_vertex(support.vertices[choice], through);
        }
        const auto [e, f] = pairs[choice - support.vertices.size()];
        return maker_.over_edges(e, f, through);
    }

    std::optional<LinePath> any_path() {
        const std::size_t edges = scene_.edges().size();
        if (features_.empty() || edges < 2) return std::nullopt;
        if (random_.index(2) == 0) {
            return maker_.through_vertex(features_[random_.index(features_.size())], std::nullopt);
        }
        // Any two edges, or two that some arc touches.
        const bool follows = random_.index(2) == 0 && !order_.empty();
        constexpr int attempts = 64;
        std::optional<LinePath> path;
        for (int i = 0; i < attempts; ++i) {
            EdgeId e{static_cast<std::uint32_t>(random_.index(edges))};
            EdgeId f{static_cast<std::uint32_t>(random_.index(edges))};
            if (follows) {
                const ArcId arc{order_[random_.index(order_.size())]};
                const auto& touched = skeleton_[arc].label.support.edges;
                if (touched.size() < 2) continue;
                e = touched[random_.index(touched.size())];
                f = touched[random_.index(touched.size())];
            }
            if (!are_skew(e, f)) continue;
            path = maker_.over_edges(e, f, std::nullopt);
            if (!labels_at(*path, Surd(random_.fraction())).empty()) break;
        }
        return path;
    }

    Labels labels_at(const LinePath& path, const Surd& t) {
        return shooter_.labels(path.family, path.curve.at(t));
    }

    // ---- events -----------------------------------------------------------------------------------

    static bool is_inside(const Surd& t) { return t > Surd(0) && t < Surd(1); }

    std::vector<Event> events_of(const LinePath& path) const {
        const PathFilter filter(path.curve, shooter_.forms());
        std::vector<Event> events;
        const auto add = [&](const Surd& t, const std::vector<ArcId>& arcs) {
            events.push_back({t, {arcs.begin(), arcs.end()}});
        };
        for (std::uint32_t i = 0; i < scene_.edges().size(); ++i) {
            const EdgeId e{i};
            const auto& over = path.family.edges;
            if (over && (e == over->first || e == over->second)) continue;
            if (filter.surely_never_meets(e)) continue;
            const auto c = path.curve.side(carrier(e, scene_));
            const bool vanishes =
                std::ranges::all_of(c, [](const Rational& x) { return x.sign() == Sign::zero; });
            if (vanishes) continue;
            for (const Surd& t : zeros_of(c)) {
                if (is_inside(t) && meets_inside(path.curve.at(t), e, scene_)) {
                    add(t, index_.arcs_at(e));
                }
            }
        }
        for (const auto& [t, v] : path.vertices) {
            if (is_inside(t)) add(t, index_.arcs_at(v));
        }
        add_contact_events(path, events);
        return merged(std::move(events));
    }

    /// Behind an end a line may run between bodies in contact, when it lies in the plane of a face.
    void add_contact_events(const LinePath& path, std::vector<Event>& events) const {
        if (!scene_.has_touching_bodies()) return;
        const std::vector<ArcId> arcs = index_.arcs_in(path.family);
        for (std::uint32_t f = 0; f < scene_.faces().size(); ++f) {
            const Plane3 plane = plane_of(FaceId{f}, scene_);
            if (!has_generator_in(plane, path.family)) continue;
            const auto c = path.curve.rise(plane.normal);
            const bool vanishes =
                std::ranges::all_of(c, [](const Rational& x) { return x.sign() == Sign::zero; });
            if (vanishes) continue;
            for (const Surd& t : zeros_of(c)) {
                if (is_inside(t)) events.push_back({t, {arcs.begin(), arcs.end()}});
            }
        }
    }

    [[nodiscard]] bool has_generator_in(const Plane3& plane, const LineFamily2& family) const {
        const auto contains = [&](VertexId v) {
            return plane.height(to_rational(scene_[v])).sign() == Sign::zero;
        };
        if (family.vertex) return contains(*family.vertex);
        const auto [e, f] = *family.edges;
        return (contains(scene_[e].source) && contains(scene_[e].target)) ||
               (contains(scene_[f].source) && contains(scene_[f].target));
    }

    /// In order, one at each t.
    static std::vector<Event> merged(std::vector<Event> events) {
        std::ranges::stable_sort(events, {}, &Event::t);
        std::vector<Event> result;
        for (Event& event : events) {
            if (result.empty() || result.back().t != event.t) {
                result.push_back(std::move(event));
                continue;
            }
            result.back().arcs.insert(event.arcs.begin(), event.arcs.end());
        }
        return result;
    }

    /// The arcs of the family that the path crosses there, by what the skeleton says.
    std::vector<ArcId> crossed_arcs(const std::vector<ArcId>& of_family, const Event& event,
                                    const SurdLine3& line) {
        std::vector<ArcId> arcs;
        for (const ArcId arc : event.arcs) {
            if (!std::ranges::binary_search(of_family, arc)) continue;
            if (geometry_.contains(skeleton_, arc, line)) arcs.push_back(arc);
        }
        return arcs;
    }

    // ---- walking ------------------------------------------------------------------------------------

    struct Gap {
        Surd first, last;
        std::optional<Labels> labels;  ///< empty when the gap is too small for doubles
    };

    void walk(const LinePath& path) {
        const std::vector<ArcId> of_family = index_.arcs_in(path.family);
        const std::vector<Event> events = events_of(path);
        std::vector<Gap> gaps;
        for (std::size_t i = 0; i <= events.size(); ++i) {
            Gap gap{i == 0 ? Surd(0) : events[i - 1].t, i < events.size() ? events[i].t : Surd(1),
                    std::nullopt};
            if (const auto t = rational_between(gap.first, gap.last)) {
                gap.labels = labels_at(path, Surd(*t));
            }
            gaps.push_back(std::move(gap));
        }
        for (std::size_t i = 0; i < events.size(); ++i) {
            compare(path, of_family, events[i], gaps[i], gaps[i + 1]);
        }
        sample(path, gaps);
    }

    /// What is found at a line against what is listed there.
    void compare(const LinePath& path, const std::vector<ArcId>& of_family, const Event& event,
                 const Gap& before, const Gap& after) {
        if (!before.labels || !after.labels) return;
        const SurdLine3 line = path.curve.at(event.t);
        Labels found = shooter_.labels(path.family, line);
        std::erase_if(found, [&](const SegmentLabel& label) {
            return std::ranges::find(*before.labels, label) != before.labels->end() ||
                   std::ranges::find(*after.labels, label) != after.labels->end();
        });
        if (found.empty() && *before.labels != *after.labels) {
            report_missing(
                path, "changes at t = " + event.t.to_string() + " where nothing new is touched",
                *before.labels);
        }
        for (const ArcId arc : crossed_arcs(of_family, event, line)) {
            const auto same = std::ranges::find(found, without_sides(skeleton_[arc].label));
            if (same == found.end()) {
                report_false(arc, "is not found by shooting along " + text_of(line));
                continue;
            }
            ++result_.crossings;
            found.erase(same);
        }
        for (const SegmentLabel& label : found) {
            report_missing(path, "crosses t = " + event.t.to_string(), {label});
        }
    }

    void sample(const LinePath& path, const std::vector<Gap>& gaps) {
        for (std::size_t i = 0; i < options_.samples; ++i) {
            const Rational t = random_.fraction();
            const auto gap = std::ranges::find_if(
                gaps, [&](const Gap& g) { return g.first < Surd(t) && Surd(t) < g.last; });
            if (gap == gaps.end() || !gap->labels) continue;
            const Labels found = labels_at(path, Surd(t));
            if (found == *gap->labels) continue;
            isolate(path, *gap, t, found);
        }
    }

    /// Between the gap's own sample and t the labels change.
    void isolate(const LinePath& path, const Gap& gap, Rational t, const Labels& found) {
        Rational known = *rational_between(gap.first, gap.last);
        constexpr int steps = 30;
        for (int i = 0; i < steps; ++i) {
            const Rational middle = (known + t) / Rational(2);
            (labels_at(path, Surd(middle)) == *gap.labels ? known : t) = middle;
        }
        report_missing(
            path,
            "changes near t = " + std::to_string(t.approx_double()) + " without meeting an edge",
            found);
    }

    // ---- reports ------------------------------------------------------------------------------------

    static std::string text_of(const SurdLine3& line) {
        std::ostringstream out;
        out << line;
        return out.str();
    }
    static std::string text_of(const SegmentLabel& label) {
        std::ostringstream out;
        out << label;
        return out.str();
    }
    static std::string text_of(const LineFamily2& family) {
        if (family.vertex) return "lines through " + to_string(*family.vertex);
        return "lines over " + to_string(family.edges->first) + " and " +
               to_string(family.edges->second);
    }
    void report(std::string text) {
        if (result_.mismatches.size() < most_mismatches) {
            result_.mismatches.push_back(std::move(text));
        }
    }
    void report_missing(const LinePath& path, const std::string& what, const Labels& labels) {
        ++result_.missing;
        std::string text = "missing: a path of " + text_of(path.family) + ' ' + what + ':';
        for (const SegmentLabel& label : labels) text += " [" + text_of(label) + ']';
        report(std::move(text));
    }
    void report_false(ArcId arc, const std::string& what) {
        ++result_.false_arcs;
        report("false: " + to_string(arc) + ' ' + std::string(name_of(skeleton_[arc].type)) + " [" +
               text_of(skeleton_[arc].label) + "] " + what);
    }

    const Scene3& scene_;
    const VisibilitySkeleton& skeleton_;
    SkeletonCheckOptions options_;
    CheckRandom random_;
    PathMaker maker_;
    Shooter shooter_;
    ArcIndex index_;
    SkeletonGeometry geometry_;
    std::vector<std::uint32_t> order_;
    std::vector<VertexId> features_;
    SkeletonCheck result_;
};

}  // namespace

Result<SkeletonCheck> check_skeleton(const Scene3& scene, const VisibilitySkeleton& skeleton,
                                     const SkeletonCheckOptions& options, const Limits& limits) {
    return Checker(scene, skeleton, options).run(limits);
}

std::ostream& operator<<(std::ostream& out, const SkeletonCheck& check) {
    return out << check.families << " families of lines, " << check.crossings
               << " crossings matched, " << check.missing << " missing, " << check.false_arcs
               << " false";
}

}  // namespace sightline
