// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "sightline/spatial/free_segment3.hpp"
#include "spatial/sheet_crossing.hpp"

namespace sightline::reference {

using detail::contains;
using detail::ExactTriangle;
using detail::ExactTriangles;
using detail::height;
using detail::inward;
using detail::LocalPicture;
using detail::over;

/// What there is round x, by looking at all planes through it and at points of the whole scene.
template <typename Number>
[[nodiscard]] LocalPicture<Number> picture_at(const ExactTriangles& exact,
                                              const BasicVector3<Number>& x, bool sheet_borders) {
    std::vector<const ExactTriangle*> all;
    for (const ExactTriangle& t : exact.triangles()) all.push_back(&t);
    return {std::move(all), x, sheet_borders,
            [&exact, x](const auto& d) { return detail::solids_along(exact, x, d); }};
}

/// A line p + t d and everything that it meets: the law of free segments, word by word.
///
/// The parameters at which it meets or leaves triangles, and the marks that the caller adds, cut the line
/// into pieces: piece i lies before parameter i, the last one behind all.
template <typename Number>
class LineCut3 {
public:
    using Vector = BasicVector3<Number>;

    LineCut3(const ExactTriangles& exact, Vector p, Vector d, std::vector<Number> marks)
        : exact_(exact), p_(std::move(p)), d_(std::move(d)), parameters_(std::move(marks)) {
        for (const ExactTriangle& t : exact_.triangles()) meet(t);
        std::sort(parameters_.begin(), parameters_.end());
        parameters_.erase(std::unique(parameters_.begin(), parameters_.end()), parameters_.end());
        pieces_.resize(parameters_.size() + 1);
    }

    [[nodiscard]] const std::vector<Number>& parameters() const noexcept { return parameters_; }
    [[nodiscard]] std::size_t index_of(const Number& mark) const {
        return static_cast<std::size_t>(
            std::lower_bound(parameters_.begin(), parameters_.end(), mark) - parameters_.begin());
    }
    [[nodiscard]] Vector point(const Number& t) const { return p_ + t * d_; }

    /// Whether the segment between two parameters, first < last, is free.
    [[nodiscard]] bool is_free(std::size_t first, std::size_t last) const {
        const Stop stop = next_stop(first, last);
        return !stop.at;
    }

    struct Stop {
        std::optional<std::size_t> at;  ///< parameter; empty when nothing stops the segment
        SegmentEnd faces;
    };
    /// Where the segment that starts at parameter `first` stops to be free.
    [[nodiscard]] Stop stop_after(std::size_t first) const {
        return next_stop(first, parameters_.size());
    }

    /// A maximal free segment: parameters, empty at infinity, and what is there.
    struct Maximal {
        Stop from;
        Stop to;
    };
    [[nodiscard]] std::vector<Maximal> maximal_segments() const {
        std::vector<Maximal> result;
        Stop from;
        bool open = !piece(0).is_interior;
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            if (open && piece(i + 1).is_interior) {
                close(result, from, {i, solid_end(i + 1, i)});
                open = false;
            } else if (!open && !piece(i + 1).is_interior) {
                from = {i, solid_end(i, i)};
                open = true;
            }
            if (!open || !is_on_sheet(i) || starts_inside_run(i)) continue;
            const Run run{i, run_end(i)};
            const bool whole = !piece(run.first).is_interior && !piece(run.last + 1).is_interior;
            const std::set<BodyId> sheets = whole ? crossed_sheets(run) : std::set<BodyId>{};
            if (sheets.empty()) continue;
            close(result, from, {run.last, sheet_end(sheets, run.last, d_)});
            from = {run.first, sheet_end(sheets, run.first, -d_)};
        }
        if (open) result.push_back({from, {}});
        return result;
    }

    /// The features that the segment touches.
    [[nodiscard]] Support support(const Maximal& segment) const {
        Support result;
        const auto& scene = exact_.scene();
        const auto touches = [&](const Number& t) {
            return (!segment.from.at || parameters_[*segment.from.at] <= t) &&
                   (!segment.to.at || t <= parameters_[*segment.to.at]);
        };
        std::vector<bool> on(scene.vertices().size());
        for (std::uint32_t v = 0; v < on.size(); ++v) {
            const auto t = parameter_of(vertex(VertexId{v}));
            on[v] = scene.is_feature(VertexId{v}) && t && touches(*t);
            if (on[v]) result.vertices.push_back(VertexId{v});
        }
        for (std::uint32_t e = 0; e < scene.edges().size(); ++e) {
            const Edge3& edge = scene.edges()[e];
            if (runs_along(edge)) {
                const bool both = on[edge.source.index()] && on[edge.target.index()];
                if (!both && shares_a_piece(segment, edge)) result.along.push_back(EdgeId{e});
            } else if (const auto t = crossing(edge); t && touches(*t)) {
                result.edges.push_back(EdgeId{e});
            }
        }
        return result;
    }

private:
    struct Piece {
        bool is_interior = false;
        bool is_on_sheet = false;
        std::vector<BodyId> solids;  // that contain it, inside or on their boundary
    };
    /// Parameters between which the line lies in W.
    struct Run {
        std::size_t first;
        std::size_t last;
    };

    // ---- events ----------------------------------------------------------------------------------

    void meet(const ExactTriangle& t) {
        const Number slope = dot(over<Number>(t.normal), d_);
        const Number start = height(t, p_);
        if (sign_of(slope) != Sign::zero) {
            const Number at = -start / slope;
            if (contains(t, point(at))) parameters_.push_back(at);
        } else if (sign_of(start) == Sign::zero) {
            meet_in_plane(t);
        }
    }

    void meet_in_plane(const ExactTriangle& t) {
        std::optional<Number> low;
        std::optional<Number> high;
        for (std::size_t i = 0; i < 3; ++i) {
            const Number start = inward(t, i, p_);
            const Number slope = inward(t, i, d_, false);
            if (sign_of(slope) == Sign::zero) {
                if (sign_of(start) == Sign::negative) return;
                continue;
            }
            const Number at = -start / slope;
            if (sign_of(slope) == Sign::positive && (!low || *low < at)) low = at;
            if (sign_of(slope) == Sign::negative && (!high || at < *high)) high = at;
        }
        if (*high < *low) return;
        parameters_.push_back(*low);
        parameters_.push_back(*high);
    }

    [[nodiscard]] Vector inner_point(std::size_t piece) const {
        if (parameters_.empty()) return p_;
        if (piece == 0) return point(parameters_.front() - Number(1));
        if (piece == parameters_.size()) return point(parameters_.back() + Number(1));
        return point((parameters_[piece - 1] + parameters_[piece]) / Number(2));
    }

    [[nodiscard]] const Piece& piece(std::size_t i) const {
        if (pieces_[i]) return *pieces_[i];
        Piece result;
        const Vector x = inner_point(i);
        for (const ExactTriangle& t : exact_.triangles()) {
            if (t.is_sheet && contains(t, x)) result.is_on_sheet = true;
        }
        const LocalPicture<Number> picture = picture_at(exact_, x, false);
        result.is_interior = picture.is_interior();
        std::set<BodyId> solids;
        for (const auto& cell : picture.cells())
            solids.insert(cell.solids.begin(), cell.solids.end());
        result.solids.assign(solids.begin(), solids.end());
        pieces_[i] = std::move(result);
        return *pieces_[i];
    }

    [[nodiscard]] bool is_on_sheet(std::size_t parameter) const {
        const Vector x = point(parameters_[parameter]);
        return std::any_of(exact_.triangles().begin(), exact_.triangles().end(),
                           [&](const ExactTriangle& t) { return t.is_sheet && contains(t, x); });
    }

    // ---- what blocks -----------------------------------------------------------------------------

    // What is interior to B ends a run: the segment ends there.
    [[nodiscard]] bool continues_run(std::size_t piece_index) const {
        return piece(piece_index).is_on_sheet && !piece(piece_index).is_interior;
    }
    [[nodiscard]] bool starts_inside_run(std::size_t i) const { return continues_run(i); }
    [[nodiscard]] std::size_t run_end(std::size_t i) const {
        while (i + 1 < parameters_.size() && continues_run(i + 1)) ++i;
        return i;
    }

    [[nodiscard]] Stop next_stop(std::size_t first, std::size_t last) const {
        // The interval of W that contains the start does not block.
        std::size_t i = first;
        bool may_cross = false;
        while (true) {
            if (i == last) return {};
            if (may_cross && is_on_sheet(i)) {
                const Run run{i, run_end(i)};
                if (run.last >= last) {
                    i = run.last;
                } else if (!piece(run.last + 1).is_interior) {
                    const auto sheets = crossed_sheets(run);
                    if (!sheets.empty()) {
                        return {run.last, sheet_end(sheets, run.last, d_)};
                    }
                }
                i = run.last;
                if (i >= last) return {};
            }
            if (piece(i + 1).is_interior) return {i, solid_end(i + 1, i)};
            if (i + 1 > parameters_.size() - 1) return {};
            may_cross = may_cross || !continues_run(i + 1);
            ++i;
        }
    }

    void close(std::vector<Maximal>& result, const Stop& from, Stop to) const {
        // A single point between two blocked pieces is no segment.
        if (from.at && *from.at == *to.at) return;
        result.push_back({from, std::move(to)});
    }

    // ---- ends ------------------------------------------------------------------------------------

    [[nodiscard]] SegmentEnd solid_end(std::size_t blocked_piece, std::size_t parameter) const {
        std::set<FaceSide> faces;
        const Vector x = point(parameters_[parameter]);
        const auto& solids = piece(blocked_piece).solids;
        for (const ExactTriangle& t : exact_.triangles()) {
            if (std::find(solids.begin(), solids.end(), t.body) != solids.end() && contains(t, x)) {
                faces.insert({t.face, false});
            }
        }
        return {faces.begin(), faces.end()};
    }

    [[nodiscard]] SegmentEnd sheet_end(const std::set<BodyId>& sheets, std::size_t parameter,
                                       const Vector& direction) const {
        std::set<FaceSide> faces;
        const Vector x = point(parameters_[parameter]);
        for (const ExactTriangle& t : exact_.triangles()) {
            if (!sheets.contains(t.body) || !contains(t, x)) continue;
            const Sign with_normal = sign_of(dot(over<Number>(t.normal), direction));
            faces.insert({t.face, with_normal == Sign::positive});
        }
        return {faces.begin(), faces.end()};
    }

    // The sheets that the segment crosses at the run; none when it does not cross W.
    [[nodiscard]] std::set<BodyId> crossed_sheets(const Run& run) const {
        std::vector<LocalPicture<Number>> pictures;
        for (std::size_t i = run.first; i <= run.last; ++i) {
            pictures.push_back(picture_at(exact_, point(parameters_[i]), true));
        }
        return detail::SheetCrossing<Number>(std::move(pictures), d_).crossed();
    }

    // ---- support ---------------------------------------------------------------------------------

    [[nodiscard]] Vector vertex(VertexId v) const {
        return over<Number>(ExactTriangles::vector_to(exact_.scene()[v]));
    }
    [[nodiscard]] std::optional<Number> parameter_of(const Vector& x) const {
        if (!cross(x - p_, d_).is_zero()) return std::nullopt;
        return dot(x - p_, d_) / dot(d_, d_);
    }
    [[nodiscard]] bool runs_along(const Edge3& edge) const {
        return parameter_of(vertex(edge.source)) && parameter_of(vertex(edge.target));
    }
    [[nodiscard]] bool shares_a_piece(const Maximal& segment, const Edge3& edge) const {
        Number low = *parameter_of(vertex(edge.source));
        Number high = *parameter_of(vertex(edge.target));
        if (high < low) std::swap(low, high);
        if (segment.from.at) low = std::max(low, parameters_[*segment.from.at]);
        if (segment.to.at) high = std::min(high, parameters_[*segment.to.at]);
        return low < high;
    }
    // Where the line meets the relative interior of an edge that it does not run along.
    [[nodiscard]] std::optional<Number> crossing(const Edge3& edge) const {
        const Vector a = vertex(edge.source);
        const Vector e = vertex(edge.target) - a;
        const Vector across = cross(d_, e);
        if (across.is_zero() || sign_of(dot(across, a - p_)) != Sign::zero) return std::nullopt;
        // p + t d = a + s e
        const Number size = dot(across, across);
        const Number s = determinant(a - p_, d_, across) / size;
        if (sign_of(s) != Sign::positive || !(s < Number(1))) return std::nullopt;
        return determinant(a - p_, e, across) / size;
    }

    const ExactTriangles& exact_;
    Vector p_;
    Vector d_;
    std::vector<Number> parameters_;
    mutable std::vector<std::optional<Piece>> pieces_;
};

}  // namespace sightline::reference
