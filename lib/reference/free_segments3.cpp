// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/free_segments3.hpp"

#include <algorithm>
#include <ranges>

#include "reference/directions2.hpp"
#include "reference/surroundings3.hpp"

namespace sightline::reference::detail {

LineCut::LineCut(const ExactScene& scene, const LinePicture& picture)
    : scene_(&scene), picture_(&picture), crossings_of_body_(scene.scene.bodies().size()) {
    find_traces();
    find_features();
    find_blockers();
}

std::size_t LineCut::index_of(const Surd& t) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(points_, t) - points_.begin());
}

std::optional<std::size_t> LineCut::point_at(const Surd& t) const {
    const std::size_t i = index_of(t);
    return i < points_.size() && points_[i] == t ? std::optional(i) : std::nullopt;
}

std::optional<std::size_t> LineCut::meeting(EdgeId e) const {
    const Edge3& edge = scene_->scene[e];
    for (const auto& [v, at] : vertices_) {
        if (v == edge.source || v == edge.target) return at;
    }
    for (const Crossing& c : edges_) {
        if (c.edge == e) return c.at;
    }
    return std::nullopt;
}

void LineCut::find_traces() {
    const auto triangles = scene_->scene.triangles();
    std::vector<std::optional<std::array<Surd, 2>>> traces;
    for (const Triangle3& t : triangles) {
        traces.push_back(picture_->trace(t));
        if (!traces.back()) continue;
        for (const Surd& at : *traces.back()) points_.push_back(at);
    }
    std::ranges::sort(points_);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (!traces[i]) continue;
        const auto& [first, last] = *traces[i];
        const Triangle3& t = triangles[i];
        traces_.push_back({t.face, i, index_of(first), index_of(last)});
        if (!is_sheet(body(t.face)) && picture_->is_crossed_when_moved(t)) {
            crossings_of_body_[body(t.face).index()].push_back(traces_.back().first);
        }
    }
}

void LineCut::find_features() {
    const Scene3& scene = scene_->scene;
    std::vector<bool> on(scene.vertices().size());
    for (std::uint32_t i = 0; i < on.size(); ++i) {
        const VertexId v{i};
        on[i] = scene.is_feature(v) && picture_->is_at(v);
        if (on[i]) vertices_.emplace_back(v, index_of(picture_->height(v)));
    }
    for (std::uint32_t i = 0; i < scene.edges().size(); ++i) {
        const auto& [a, b, body, faces] = scene.edges()[i];
        if (on[a.index()] && on[b.index()]) {
            const std::size_t from = index_of(picture_->height(a));
            const std::size_t to = index_of(picture_->height(b));
            runs_.push_back({EdgeId{i}, std::min(from, to), std::max(from, to)});
        } else if (const auto at = picture_->crossing(a, b)) {
            edges_.push_back({EdgeId{i}, index_of(*at)});
        }
    }
}

bool LineCut::is_on_boundary(BodyId solid, std::size_t piece) const {
    return std::ranges::any_of(
        traces_, [&](const Trace& t) { return body(t.face) == solid && covers(t, piece); });
}

// From a piece that is not on the boundary, the line leaves the solid as often as it enters it, and once
// more when it starts inside.
bool LineCut::is_inside(BodyId solid, std::size_t piece) const {
    const auto behind = std::ranges::count_if(crossings_of_body_[solid.index()],
                                              [&](std::size_t at) { return at >= piece; });
    return (behind % 2 == 1) != scene_->scene[solid].is_world;
}

// Whether the cross-sections of the solids on whose boundary the piece lies cover the disc round it.
bool LineCut::is_sealed(std::size_t piece) const {
    const std::size_t axis = picture_->line().axis;
    std::vector<Sector> sectors;
    std::vector<FaceId> with_edge;
    for (const Run& r : runs_) {
        const Edge3& edge = scene_->scene[r.edge];
        if (is_sheet(edge.body) || !covers(r, piece)) continue;
        const RationalTriple& along = scene_->edges[r.edge.index()].direction;
        const auto into_left = cross(scene_->normals[edge.faces[0].index()], along);
        const auto into_right = cross(along, scene_->normals[edge.faces[1].index()]);
        Sector sector{picture_->projected(to_surd(into_right)),
                      picture_->projected(to_surd(into_left))};
        if (along[axis].sign() == Sign::negative) std::swap(sector.from, sector.to);
        sectors.push_back(std::move(sector));
        with_edge.insert(with_edge.end(), edge.faces.begin(), edge.faces.end());
    }
    for (const Trace& t : traces_) {
        if (is_sheet(body(t.face)) || !covers(t, piece)) continue;
        if (std::ranges::count(with_edge, t.face) > 0) continue;
        const RationalTriple& n = scene_->normals[t.face.index()];
        const Rational& x = n[(axis + 1) % 3];
        const Rational& y = n[(axis + 2) % 3];
        sectors.push_back({{-y, x}, {y, -x}});  // the half plane n·v <= 0
    }
    return covers_circle(sectors);
}

void LineCut::find_blockers() {
    blockers_.resize(points_.size() + 1);
    for (std::size_t piece = 0; piece < blockers_.size(); ++piece) {
        std::vector<BodyId> on;
        for (std::uint32_t i = 0; i < scene_->scene.bodies().size(); ++i) {
            const BodyId b{i};
            if (is_sheet(b)) continue;
            if (is_on_boundary(b, piece)) {
                on.push_back(b);
            } else if (is_inside(b, piece)) {
                blockers_[piece].push_back(b);
            }
        }
        if (!blockers_[piece].empty() || (!on.empty() && is_sealed(piece))) {
            blockers_[piece].insert(blockers_[piece].end(), on.begin(), on.end());
        }
    }
}

// ---- sheets ---------------------------------------------------------------------------------------

std::vector<LineCut::Interval> LineCut::sheet_intervals() const {
    std::vector<Interval> result;
    for (const Trace& t : traces_) {
        if (is_sheet(body(t.face))) result.push_back({t.first, t.last});
    }
    std::ranges::sort(result, {}, &Interval::first);
    std::vector<Interval> merged;
    for (const Interval& i : result) {
        if (merged.empty() || merged.back().last < i.first) {
            merged.push_back(i);
        } else {
            merged.back().last = std::max(merged.back().last, i.last);
        }
    }
    return merged;
}

std::vector<std::pair<LineCut::Interval, std::vector<BodyId>>> LineCut::crossed_sheets() const {
    std::vector<std::pair<Interval, std::vector<BodyId>>> result;
    for (const Interval& i : sheet_intervals()) {
        const auto pieces = std::views::iota(i.first, i.last + 2);
        if (std::ranges::any_of(pieces, [&](std::size_t k) { return is_blocked(k); })) continue;
        auto sheets = Surroundings(*this, i.first, i.last).separating_sheets();
        if (!sheets.empty()) result.emplace_back(i, std::move(sheets));
    }
    return result;
}

// ---- segments -------------------------------------------------------------------------------------

SegmentEnd LineCut::solid_end(std::size_t blocked_piece, std::size_t point) const {
    SegmentEnd end;
    for (const Trace& t : traces_) {
        if (std::ranges::count(blockers_[blocked_piece], body(t.face)) > 0 && t.first <= point &&
            point <= t.last) {
            end.push_back({t.face, false});
        }
    }
    std::ranges::sort(end);
    end.erase(std::unique(end.begin(), end.end()), end.end());
    return end;
}

SegmentEnd LineCut::sheet_end(const std::vector<BodyId>& sheets, std::size_t point,
                              int direction) const {
    SegmentEnd end;
    for (const Trace& t : traces_) {
        if (std::ranges::count(sheets, body(t.face)) == 0 || point < t.first || t.last < point) {
            continue;
        }
        const Surd rise = dot(to_surd(scene_->normals[t.face.index()]), picture_->line().direction);
        end.push_back({t.face, direction * to_int(rise.sign()) > 0});
    }
    std::ranges::sort(end);
    end.erase(std::unique(end.begin(), end.end()), end.end());
    return end;
}

void LineCut::add_contact(std::size_t blocked_piece, std::vector<FaceId>& faces) const {
    for (const Trace& t : traces_) {
        if (!is_sheet(body(t.face)) && covers(t, blocked_piece)) faces.push_back(t.face);
    }
}

Cell LineCut::cell_of(const LineSegment& segment) const {
    const std::size_t first = segment.from.value_or(0);
    const std::size_t last = segment.to.value_or(points_.size());
    const auto touches = [&](std::size_t at) { return first <= at && at <= last; };
    Cell cell;
    cell.label.ends = segment.ends;
    std::ranges::sort(cell.label.ends);
    Support& support = cell.label.support;
    std::vector<Place> places(points_.size());
    for (const auto& [v, at] : vertices_) {
        if (!touches(at)) continue;
        support.vertices.push_back(v);
        places[at].vertices.push_back(v);
    }
    for (const auto& [e, at] : edges_) {
        if (!touches(at)) continue;
        support.edges.push_back(e);
        places[at].edges.push_back(e);
    }
    for (const Run& r : runs_) {
        if (std::max(first, r.first) >= std::min(last, r.last)) continue;
        if (!touches(r.first) || !touches(r.last)) support.along.push_back(r.edge);
        // Where another edge crosses this one, the two fix a point.
        for (const Crossing& c : edges_) {
            if (touches(c.at) && r.first < c.at && c.at < r.last) {
                places[c.at].edges.push_back(r.edge);
            }
        }
    }
    for (Place& place : places) {
        if (place == Place{}) continue;
        std::ranges::sort(place.edges);
        place.edges.erase(std::unique(place.edges.begin(), place.edges.end()), place.edges.end());
        cell.places.push_back(std::move(place));
    }
    std::ranges::sort(cell.places);
    if (segment.from && is_blocked(*segment.from)) add_contact(*segment.from, cell.contact);
    if (segment.to && is_blocked(*segment.to + 1)) add_contact(*segment.to + 1, cell.contact);
    std::ranges::sort(cell.contact);
    cell.contact.erase(std::unique(cell.contact.begin(), cell.contact.end()), cell.contact.end());
    return cell;
}

std::vector<LineSegment> LineCut::maximal_free_segments() const {
    const auto crossed = crossed_sheets();
    auto sheet = crossed.begin();
    std::vector<LineSegment> result;
    for (std::size_t piece = 0; piece <= points_.size(); ++piece) {
        if (is_blocked(piece)) continue;
        LineSegment segment;
        if (piece > 0) {
            segment.from = piece - 1;
            segment.ends[0] = solid_end(piece - 1, piece - 1);
        }
        while (piece < points_.size() && !is_blocked(piece + 1)) {
            if (sheet != crossed.end() && sheet->first.first == piece) {
                // What comes ends where it would leave the sheets; what leaves starts where they begin.
                const auto& [interval, sheets] = *sheet;
                LineSegment next;
                next.from = interval.first;
                next.ends[0] = sheet_end(sheets, interval.first, -1);
                segment.to = interval.last;
                segment.ends[1] = sheet_end(sheets, interval.last, 1);
                result.push_back(std::exchange(segment, next));
                ++sheet;
            }
            ++piece;
        }
        if (piece < points_.size()) {
            segment.to = piece;
            segment.ends[1] = solid_end(piece + 1, piece);
        }
        result.push_back(std::move(segment));
    }
    for (LineSegment& segment : result) segment.cell = cell_of(segment);
    return result;
}

}  // namespace sightline::reference::detail
