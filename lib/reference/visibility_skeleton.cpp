// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/reference/visibility_skeleton.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "reference/free_segments3.hpp"
#include "reference/line_family3.hpp"

namespace sightline::reference {
namespace {

using namespace detail;

/// A free segment of a line of a family that touches all generators of the family.
struct Found {
    Cell cell;
    ExactLine line;
    Freedom freedom;
};

class Builder {
public:
    explicit Builder(const ExactScene& scene) : scene_(scene) {}

    void add(const LineFamily& family) {
        for (const auto& [first, last] : family.live()) {
            std::vector<Surd> events = family.events(first, last);
            events.insert(events.begin(), first);
            events.push_back(last);
            add(family, events);
        }
    }

    [[nodiscard]] VisibilitySkeleton skeleton() && {
        cut_at_corners();
        return {std::move(nodes_), std::move(arcs_)};
    }

private:
    /// A node, at a parameter of a family.
    struct End {
        Surd at;
        NodeId node;
    };
    struct Arc {
        Found found;     ///< one of its segments
        ExactEdge base;  ///< of the family
        End from;
        End to;
    };
    /// A segment in which an arc ends, although the cell of the segment has dimension 1.
    struct Corner {
        Found found;
        NodeId node;
    };

    void add(const LineFamily& family, const std::vector<Surd>& events);
    [[nodiscard]] std::vector<Found> segments_at(const LineFamily& family, const Surd& s) const;
    [[nodiscard]] bool is_certainly_blocked(const LineFamily& family,
                                            const LinePicture& picture) const;
    /// A free segment of a line between two pieces of a family; a node, if it is one.
    struct Event {
        Found found;
        std::optional<NodeId> node;
    };
    NodeId node(const Found& found);
    /// Where an arc ends; null when it goes on.
    NodeId* limit(const Found& arc, std::vector<Event>& event);
    void cut_at_corners();

    const ExactScene& scene_;
    std::vector<SkeletonNode> nodes_;
    std::vector<Arc> found_arcs_;
    std::vector<Corner> corners_;
    std::vector<SkeletonArc> arcs_;
};

// A number strictly between two of [0, 1].
Rational between(const Surd& a, const Surd& b) {
    Rational low = 0;
    Rational high = 1;
    while (true) {
        Rational middle = (low + high) / 2;
        if (a >= middle) {
            low = std::move(middle);
        } else if (b <= middle) {
            high = std::move(middle);
        } else {
            return middle;
        }
    }
}

bool Builder::is_certainly_blocked(const LineFamily& family, const LinePicture& picture) const {
    std::vector<Interval> places;
    for (const EdgeId e : family.edges()) {
        const Edge3& edge = scene_.scene[e];
        places.push_back(picture.approx_crossing(edge.source, edge.target));
    }
    if (family.point()) places.push_back(enclosure((*family.point())[picture.line().axis]));
    // From the end of the first place's enclosure to the start of the last one's.
    Interval inner{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
    for (const Interval& at : places) {
        inner.lower = std::min(inner.lower, at.upper);
        inner.upper = std::max(inner.upper, at.lower);
    }
    return std::ranges::any_of(scene_.scene.triangles(), [&](const Triangle3& t) {
        return picture.certainly_blocks(t, inner);
    });
}

std::vector<Found> Builder::segments_at(const LineFamily& family, const Surd& s) const {
    const ExactLine line = family.line_at(s);
    const LinePicture picture(scene_, line);
    if (is_certainly_blocked(family, picture)) return {};
    const LineCut cut(scene_, picture);
    std::vector<std::optional<std::size_t>> places;
    for (const EdgeId e : family.edges()) places.push_back(cut.meeting(e));
    if (family.point()) places.push_back(cut.point_at((*family.point())[line.axis]));
    // The root s may be one where a line is parallel to a generator, or leaves it at an end.
    if (!std::ranges::all_of(places, [](const auto& p) { return p.has_value(); })) return {};
    const auto [first, last] = std::ranges::minmax(places);
    std::vector<Found> result;
    for (LineSegment& segment : cut.maximal_free_segments()) {
        if ((segment.from && *segment.from > *first) || (segment.to && *segment.to < *last))
            continue;
        Freedom free = freedom(scene_, segment.cell);
        result.push_back({std::move(segment.cell), line, std::move(free)});
    }
    return result;
}

NodeId Builder::node(const Found& found) {
    nodes_.push_back({node_type(scene_, found.cell, found.line), found.cell.label,
                      root_of(scene_, found.cell, found.line),
                      faces_in_plane(scene_, found.cell, found.line)});
    return NodeId{static_cast<std::uint32_t>(nodes_.size() - 1)};
}

// The free segment of an event's line that contains the limit of an arc's segments.
NodeId* Builder::limit(const Found& arc, std::vector<Event>& event) {
    const auto same =
        std::ranges::find(event, arc.cell, [](const Event& e) { return e.found.cell; });
    if (same != event.end()) return same->node ? &*same->node : nullptr;
    SIGHTLINE_EXPECT(event.size() == 1);  // else it would be open which one contains the limit
    Event& end = event.front();
    if (!end.node) {
        end.node = node(end.found);
        corners_.push_back({end.found, *end.node});
    }
    return &*end.node;
}

// Follows the segments of the family from event to event. Where the free segment of the event's line that
// contains the limit of an arc's segments is of the same cell, the arc goes on; else it is the arc's node.
void Builder::add(const LineFamily& family, const std::vector<Surd>& events) {
    std::vector<Arc> open;
    for (std::size_t i = 0; i < events.size(); ++i) {
        std::vector<Event> here;
        for (Found& found : segments_at(family, events[i])) {
            const bool is_node = found.freedom.dimension == 0;
            here.push_back({std::move(found), {}});
            if (is_node) here.back().node = node(here.back().found);
        }
        std::vector<Arc> going_on;
        for (Arc& arc : open) {
            const NodeId* end = limit(arc.found, here);
            if (end != nullptr) {
                arc.to = {events[i], *end};
                found_arcs_.push_back(std::move(arc));
            } else {
                going_on.push_back(std::move(arc));
            }
        }
        open.clear();
        if (i + 1 == events.size()) break;
        for (Found& found : segments_at(family, between(events[i], events[i + 1]))) {
            if (!family.is_family_of(found.freedom)) continue;
            if (const NodeId* start = limit(found, here)) {
                open.push_back({std::move(found), family.base(), {events[i], *start}, {}});
                continue;
            }
            const auto before = std::ranges::find(going_on, found.cell,
                                                  [](const Arc& arc) { return arc.found.cell; });
            SIGHTLINE_EXPECT(before != going_on.end());
            open.push_back(std::move(*before));
            going_on.erase(before);
        }
        SIGHTLINE_EXPECT(going_on.empty());
    }
}

// A pencil's line that meets the edge's line, as the parameter of the point there.
Surd parameter_of(const ExactLine& line, const ExactEdge& edge) {
    const SurdTriple across = cross(line.direction, to_surd(edge.direction));
    return dot(cross(minus(line.base, to_surd(edge.source)), line.direction), across) /
           -dot(across, across);
}

void Builder::cut_at_corners() {
    for (const Arc& arc : found_arcs_) {
        std::vector<End> ends{arc.from, arc.to};
        for (const Corner& corner : corners_) {
            if (corner.found.cell != arc.found.cell ||
                corner.found.freedom.pencil != arc.found.freedom.pencil) {
                continue;
            }
            const Surd at = parameter_of(corner.found.line, arc.base);
            if (arc.from.at < at && at < arc.to.at) ends.push_back({at, corner.node});
        }
        std::ranges::sort(ends, {}, &End::at);
        const auto same = [](const End& a, const End& b) { return a.at == b.at; };
        ends.erase(std::unique(ends.begin(), ends.end(), same), ends.end());
        const ArcType type = arc_type(scene_, arc.found.cell, arc.found.freedom);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            arcs_.push_back({type, arc.found.cell.label, {ends[i].node, ends[i + 1].node}});
        }
    }
}

void add_pencils(const ExactScene& scene, Builder& builder) {
    const auto edge_count = static_cast<std::uint32_t>(scene.edges.size());
    std::set<std::pair<RationalTriple, EdgeId>> pencils;
    const auto add = [&](const RationalTriple& p, std::uint32_t e) {
        if (plane_of(p, scene.edges[e]) != Plane{}) pencils.emplace(p, EdgeId{e});
    };
    for (const RationalTriple& p : scene.points) {
        for (std::uint32_t e = 0; e < edge_count; ++e) add(p, e);
    }
    for (std::uint32_t e = 0; e < edge_count; ++e) {
        for (std::uint32_t f = 0; f < e; ++f) {
            const ExactEdge& a = scene.edges[e];
            const ExactEdge& b = scene.edges[f];
            if (!coplanar(a, b) || collinear(a, b)) continue;
            const Plane plane = plane_of(a, b);
            for (const ExactEdge& c : scene.edges) {
                if (height(plane, c.source).sign() * height(plane, c.target).sign() !=
                    Sign::negative) {
                    continue;
                }
                const RationalTriple p = piercing_point(plane, c);
                add(p, e);
                add(p, f);
            }
        }
    }
    for (const auto& [p, e] : pencils) builder.add(LineFamily(scene, e, p));
}

bool is_on(const ExactEdge& e, const RationalTriple& p) {
    const RationalTriple to_source = minus(e.source, p);
    return is_zero(cross(to_source, e.direction)) &&
           dot(to_source, minus(e.target, p)).sign() != Sign::positive;
}

// Lines that end at a point, and behind it run on between two bodies in contact. No such line runs along an
// edge, so that two edges through the point cut them into two halves of the pencil.
void add_contact_pencils(const ExactScene& scene, Builder& builder) {
    std::set<Plane> planes;
    for (std::size_t f = 0; f < scene.planes.size(); ++f) {
        for (std::size_t g = 0; g < f; ++g) {
            const bool facing = dot(scene.normals[f], scene.normals[g]).sign() == Sign::negative;
            if (facing && scene.planes[f] == scene.planes[g]) planes.insert(scene.planes[f]);
        }
    }
    for (const Plane& plane : planes) {
        for (const RationalTriple& p : scene.points) {
            std::vector<RationalTriple> directions;
            for (const ExactEdge& e : scene.edges) {
                const bool in_plane =
                    is_zero(height(plane, e.source)) && is_zero(height(plane, e.target));
                if (!in_plane || !is_on(e, p)) continue;
                if (directions.empty() || !is_zero(cross(directions[0], e.direction))) {
                    directions.push_back(e.direction);
                }
            }
            if (directions.size() < 2) continue;
            const RationalTriple a = plus(p, directions[0]);
            const RationalTriple b = plus(p, directions[1]);
            const RationalTriple c = minus(p, directions[0]);
            builder.add(LineFamily(scene, edge_between(a, b), p));
            builder.add(LineFamily(scene, edge_between(b, c), p));
        }
    }
}

void add_reguli(const ExactScene& scene, Builder& builder) {
    const auto edge_count = static_cast<std::uint32_t>(scene.edges.size());
    const auto skew = [&](std::uint32_t a, std::uint32_t b) {
        return !coplanar(scene.edges[a], scene.edges[b]);
    };
    for (std::uint32_t a = 0; a < edge_count; ++a) {
        for (std::uint32_t b = 0; b < a; ++b) {
            if (!skew(a, b)) continue;
            for (std::uint32_t c = 0; c < b; ++c) {
                if (!skew(a, c) || !skew(b, c)) continue;
                builder.add(LineFamily(scene, EdgeId{a}, EdgeId{b}, EdgeId{c}));
            }
        }
    }
}

}  // namespace

std::vector<FreeSegment3> maximal_free_segments(const Scene3& scene, const SurdLine3& line) {
    const ExactScene exact(scene);
    // The foot of the origin (mathematics: formula 1).
    const SurdVector3 foot = sightline::cross(line.d, line.m);
    const Surd size = sightline::dot(line.d, line.d);
    const LinePicture picture(exact, ExactLine({foot.x / size, foot.y / size, foot.z / size},
                                               {line.d.x, line.d.y, line.d.z}));
    const LineCut cut(exact, picture);
    std::vector<FreeSegment3> result;
    for (const LineSegment& s : cut.maximal_free_segments()) {
        FreeSegment3 segment{s.cell.label, {}, {}, s.ends, freedom(exact, s.cell).dimension};
        if (s.from) segment.from = cut.points()[*s.from];
        if (s.to) segment.to = cut.points()[*s.to];
        result.push_back(std::move(segment));
    }
    return result;
}

VisibilitySkeleton visibility_skeleton(const Scene3& scene) {
    const ExactScene exact(scene);
    Builder builder(exact);
    add_pencils(exact, builder);
    add_contact_pencils(exact, builder);
    add_reguli(exact, builder);
    return std::move(builder).skeleton();
}

}  // namespace sightline::reference
