// SPDX-License-Identifier: GPL-3.0-or-later
// The lines in a plane that meet coplanar segments: where they fill an open set, where they only
// turn round a point, and where one stands alone.
#include <algorithm>
#include <map>
#include <set>

#include "event/pencil.hpp"

namespace sightline::detail {

namespace {

using Kind = TransversalElement::Kind;

class Region {
public:
    Region(const Plane3& plane, const std::vector<TransversalElement>& elements)
        : plane_(scaled(plane)), elements_(elements) {
        for (const TransversalElement& e : elements_) {
            if (e.kind() != Kind::segment) continue;
            ends_.insert(e.source());
            ends_.insert(e.target());
        }
    }

    Findings solve() {
        if (ends_.empty()) is_open_ = true;
        for (const RationalPoint3& end : ends_) turn_round(end);
        for (const auto& [line, is_alone] : alone_) {
            if (is_alone) findings_.lines.push_back(line);
        }
        if (is_open_) findings_.components.push_back(component());
        return std::move(findings_);
    }

private:
    // All lines through an end: of those that meet everything, the pieces between lines through
    // two ends are alike.
    void turn_round(const RationalPoint3& end) {
        const Pencil pencil(end, plane_);
        const CircleSet set = lines_of_pencil(pencil, elements_);
        std::vector<CirclePoint> corners;
        for (const RationalPoint3& other : ends_) {
            if (other != end) corners.push_back(pencil.parameter_of(other - end));
        }
        std::vector<CircleArc> thin;
        if (set.is_all) sort_pieces(pencil, cut_all(corners), thin);
        for (const CircleArc& arc : set.arcs) sort_pieces(pencil, cut(arc, corners), thin);
        join_ends(thin);
        const bool is_whole = thin.size() == 1 && thin[0].from == thin[0].to && thin[0].has_from;
        if (is_whole) thin.clear();
        if (is_whole || !thin.empty()) findings_.components.push_back(pencil.component(thin));
        for (const CirclePoint& p : set.points) alone_.emplace(pencil.line(p), true);
    }

    // Notes the corners of open pieces of the plane's component; collects those without.
    void sort_pieces(const Pencil& pencil, const std::vector<CircleArc>& pieces,
                     std::vector<CircleArc>& thin) {
        for (const CircleArc& piece : pieces) {
            const RationalLine3 from = pencil.line(piece.from), to = pencil.line(piece.to);
            if (piece.has_from) alone_[from] = false;
            if (piece.has_to) alone_[to] = false;
            if (borders_open_set(pencil, piece.through)) {
                is_open_ = true;
                if (piece.has_from) extremal_.insert(from);
                if (piece.has_to) extremal_.insert(to);
            } else if (!thin.empty() && thin.back().to == piece.from && piece.has_from) {
                thin.back().to = piece.to;
                thin.back().has_to = piece.has_to;
            } else {
                thin.push_back(piece);
            }
        }
    }

    // Whole pencils are cut at their first corner, too.
    static void join_ends(std::vector<CircleArc>& thin) {
        if (thin.size() < 2 || thin.back().to != thin.front().from || !thin.front().has_from) {
            return;
        }
        thin.front().from = thin.back().from;
        thin.front().has_from = thin.back().has_from;
        thin.pop_back();
    }

    // A line through one end only can be moved off it to a side when the segments that end there
    // all leave to the other side.
    [[nodiscard]] bool borders_open_set(const Pencil& pencil, const CirclePoint& at) const {
        const Vector3 direction = pencil.line(at).d;
        Sign common = Sign::zero;
        for (const TransversalElement& e : elements_) {
            if (e.kind() != Kind::segment) continue;
            const bool at_source = e.source() == pencil.center();
            if (!at_source && e.target() != pencil.center()) continue;
            const Vector3 leaves = (at_source ? e.target() : e.source()) - pencil.center();
            const Sign side = determinant(plane_.normal, direction, leaves).sign();
            if (side * common == Sign::negative) return false;
            common = side;
        }
        return true;
    }

    [[nodiscard]] TransversalComponent component() const {
        TransversalComponent result;
        result.kind = TransversalComponent::Kind::plane;
        result.plane = plane_;
        result.extremal.assign(extremal_.begin(), extremal_.end());
        return result;
    }

    Plane3 plane_;
    const std::vector<TransversalElement>& elements_;
    std::set<RationalPoint3> ends_;
    std::set<RationalLine3> extremal_;
    std::map<RationalLine3, bool> alone_;  // lines through two ends; whether no piece ends there
    bool is_open_ = false;
    Findings findings_;
};

}  // namespace

Findings solve_plane(const Plane3& plane, const std::vector<TransversalElement>& elements) {
    return Region(plane, elements).solve();
}

}  // namespace sightline::detail
