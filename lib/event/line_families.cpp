// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "sightline/event/swath.hpp"

namespace sightline {
namespace {

bool are_coplanar(const RationalLine3& a, const RationalLine3& b) {
    return side(a, b).sign() == Sign::zero;
}

/// Where two different lines of one plane meet.
ProjectivePoint3 common_point(const RationalLine3& a, const RationalLine3& b) {
    if (cross(a.d, b.d).is_zero()) return {a.d, 0};
    return meeting_point(a, b);
}

/// The plane of two different lines that have one.
Plane3 common_plane(const RationalLine3& a, const RationalLine3& b) {
    const RationalPoint3 p = foot_of_origin(a);
    const Vector3 normal = cross(a.d, b.d);
    if (normal.is_zero()) return plane_through(p, b);
    return {normal, dot(normal, vector_to(p))};
}

bool lies_in(const RationalLine3& l, const Plane3& plane) {
    const auto meeting = meeting_point(l, plane);
    return !meeting.is_finite() && meeting.p.is_zero();
}

/// What meets the lines so far.
class Conditions {
public:
    explicit Conditions(const RationalPoint3& p) { bundles_.push_back({vector_to(p), 1}); }
    Conditions(const RationalLine3& a, const RationalLine3& b) {
        if (are_coplanar(a, b)) {
            bundles_.push_back(common_point(a, b));
            fields_.push_back(common_plane(a, b));
        } else {
            congruence_ = {a, b};
        }
    }

    void add(const RationalLine3& l) {
        std::vector<SurdLine3> isolated;
        std::vector<Swath> swaths;
        for (const Swath& swath : swaths_) {
            if (const auto lines = swath.lines_meeting(l)) {
                isolated.insert(isolated.end(), lines->begin(), lines->end());
            } else {
                swaths.push_back(swath);
            }
        }
        std::erase_if(isolated_, [&](const SurdLine3& line) {
            return side(line, to_surd(l)).sign() != Sign::zero;
        });
        isolated_.insert(isolated_.end(), isolated.begin(), isolated.end());
        swaths_ = std::move(swaths);
        cut_larger(l);
        tidy();
    }

    [[nodiscard]] LineFamilies result() && {
        return {std::move(isolated_), std::move(swaths_),
                !bundles_.empty() || !fields_.empty() || congruence_.has_value()};
    }

private:
    void cut_larger(const RationalLine3& l) {
        if (congruence_) {
            cut_congruence(l);
            return;
        }
        std::erase_if(bundles_, [&](const ProjectivePoint3& p) {
            if (is_on(l, p)) return false;
            swaths_.push_back(Swath::pencil(p, l));
            return true;
        });
        std::erase_if(fields_, [&](const Plane3& plane) {
            if (lies_in(l, plane)) return false;
            swaths_.push_back(Swath::pencil(meeting_point(l, plane), plane));
            return true;
        });
    }

    void cut_congruence(const RationalLine3& l) {
        auto [a, b] = *congruence_;
        congruence_.reset();
        if (are_coplanar(l, b)) std::swap(a, b);
        if (!are_coplanar(l, a)) {
            swaths_.push_back(Swath::regulus(a, b, l));
            return;
        }
        const Plane3 plane = common_plane(a, l);
        swaths_.push_back(Swath::pencil(common_point(a, l), b));
        swaths_.push_back(Swath::pencil(meeting_point(b, plane), plane));
    }

    /// Removes what is repeated, or contained in something larger.
    void tidy() {
        std::vector<Swath> swaths;
        for (const Swath& swath : swaths_) {
            if (std::ranges::find(swaths, swath) == swaths.end() && !is_in_larger(swath)) {
                swaths.push_back(swath);
            }
        }
        swaths_ = std::move(swaths);
        std::ranges::sort(isolated_);
        isolated_.erase(std::unique(isolated_.begin(), isolated_.end()), isolated_.end());
        std::erase_if(isolated_, [this](const SurdLine3& line) {
            return is_in_larger(line) || std::ranges::any_of(swaths_, [&](const Swath& swath) {
                       return swath.contains(line);
                   });
        });
    }
    [[nodiscard]] bool is_in_larger(const Swath& swath) const {
        if (swath.is_regulus()) return false;
        const ProjectivePoint3& p = swath.centre();
        return std::ranges::any_of(bundles_,
                                   [&](const ProjectivePoint3& b) {
                                       return b.w * p.p == p.w * b.p && cross(b.p, p.p).is_zero() &&
                                              b.is_finite() == p.is_finite();
                                   }) ||
               std::ranges::any_of(fields_, [&](const Plane3& f) { return swath.all_in(f); });
    }
    [[nodiscard]] bool is_in_larger(const SurdLine3& line) const {
        return std::ranges::any_of(bundles_,
                                   [&](const ProjectivePoint3& b) { return is_on(line, b); }) ||
               std::ranges::any_of(fields_, [&](const Plane3& f) {
                   const auto meeting = meeting_point(line, to_surd(f.normal), Surd(f.offset));
                   return !meeting.is_finite() && meeting.p.is_zero();
               });
    }

    std::vector<SurdLine3> isolated_;
    std::vector<Swath> swaths_;
    std::vector<ProjectivePoint3> bundles_;
    std::vector<Plane3> fields_;
    std::optional<std::pair<RationalLine3, RationalLine3>> congruence_;
};

/// The line of several points, when they have one that meets all lines.
LineFamilies line_of_points(std::span<const RationalPoint3> points,
                            std::span<const RationalLine3> lines) {
    const RationalLine3 line = line_through(points[0], points[1]);
    const bool fits =
        std::ranges::all_of(points, [&](const RationalPoint3& p) { return is_on(line, p); }) &&
        std::ranges::all_of(lines, [&](const RationalLine3& l) { return are_coplanar(line, l); });
    LineFamilies result;
    if (fits) result.isolated.push_back(scaled(to_surd(line)));
    return result;
}

}  // namespace

LineFamilies families_meeting(const std::vector<RationalPoint3>& points,
                              const std::vector<RationalLine3>& lines) {
    std::vector<RationalPoint3> places = points;
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<RationalLine3> different;
    for (const RationalLine3& l : lines) different.push_back(scaled(l));
    std::ranges::sort(different);
    different.erase(std::unique(different.begin(), different.end()), different.end());

    if (places.size() >= 2) return line_of_points(places, different);
    if (places.empty() && different.size() < 2)
        return {.isolated = {}, .swaths = {}, .has_larger = true};
    const std::size_t first = places.empty() ? 2 : 0;
    Conditions conditions =
        places.empty() ? Conditions(different[0], different[1]) : Conditions(places[0]);
    for (const RationalLine3& l : std::span(different).subspan(first)) conditions.add(l);
    return std::move(conditions).result();
}

}  // namespace sightline
