// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/reference/transversals.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace sightline::reference {

namespace {

using Elements = std::vector<TransversalElement>;
using Kind = TransversalElement::Kind;
using Family = TransversalComponent::Kind;

bool is_zero(const Rational& x) { return x.sign() == Sign::zero; }

RationalPoint3 point_at(const Vector3& v) { return {v.x, v.y, v.z}; }

Plane3 scaled_plane(const Plane3& p) {
    const Vector3& n = p.normal;
    const Rational by = !is_zero(n.x) ? n.x : !is_zero(n.y) ? n.y : n.z;
    return {Rational(1) / by * n, p.offset / by};
}

bool is_less(const Plane3& p, const Plane3& q) {
    return std::pair(p.normal, p.offset) < std::pair(q.normal, q.offset);
}

// Places of a one-parameter family, in the order in which one walks it: finite numbers, infinity.
using Place = std::optional<Rational>;

// A one-parameter family of lines, and the places where something may change.
struct Walk {
    std::function<RationalLine3(const Place&)> line;
    std::vector<Place> critical;
};

struct Piece {
    Place from, through, to;
    bool has_from, has_to;
};

Place between(const Place& p, const Place& q) {
    if (!p) return q ? Place(*q - 1) : Place(0);
    if (!q) return *p + 1;
    if (*p < *q) return (*p + *q) / 2;
    return std::nullopt;
}

class Search {
public:
    explicit Search(std::span<const TransversalElement> elements)
        : elements_(elements.begin(), elements.end()) {
        for (const TransversalElement& e : elements_) {
            if (e.kind() != Kind::point) carriers_.insert(scaled(e.carrier()));
            if (e.kind() != Kind::line) ends_.insert({e.source(), e.target()});
        }
    }

    Transversals run() {
        if (find_products()) return {{}, components_};
        find_places();
        for (const RationalPoint3& x : places_) {
            if (holds_all(x)) add(Family::bundle, x, std::nullopt);
        }
        for (const Plane3& plane : planes_) find_region(plane);
        for (const RationalPoint3& x : places_) {
            for (const Plane3& plane : planes_at(x)) find_pencil(x, plane);
        }
        find_regulus();
        return {isolated(), sorted()};
    }

private:
    template <typename Line>
    [[nodiscard]] bool meets_all(const Line& line) const {
        return std::ranges::all_of(elements_, [&](const auto& e) { return meets(line, e); });
    }
    [[nodiscard]] bool holds_all(const RationalPoint3& x) const {
        return std::ranges::all_of(elements_, [&](const TransversalElement& e) {
            const auto [low, high] = std::minmax(e.source(), e.target());
            if (e.kind() == Kind::point) return x == low;
            return is_on(e.carrier(), x) && (e.kind() == Kind::line || (low <= x && x <= high));
        });
    }

    // All lines that meet one segment, or both of two.
    bool find_products() {
        std::vector<TransversalElement> pieces;
        for (const RationalLine3& carrier : carriers_) {
            std::optional<std::pair<RationalPoint3, RationalPoint3>> piece;
            const TransversalElement* whole = nullptr;
            for (const TransversalElement& e : elements_) {
                if (e.kind() == Kind::point) return false;
                if (scaled(e.carrier()) != carrier) continue;
                if (e.kind() == Kind::line) {
                    whole = &e;
                    continue;
                }
                const auto [low, high] = std::minmax(e.source(), e.target());
                if (!piece) {
                    piece = {low, high};
                } else {
                    piece = {std::max(piece->first, low), std::min(piece->second, high)};
                }
            }
            if (piece && !(piece->first < piece->second)) return false;
            pieces.push_back(piece ? TransversalElement::segment(piece->first, piece->second)
                                   : *whole);
        }
        const bool is_skew_pair =
            carriers_.size() == 2 && !is_zero(side(*carriers_.begin(), *carriers_.rbegin()));
        if (carriers_.size() != 1 && !is_skew_pair) return false;
        std::sort(pieces.begin(), pieces.end(),
                  [](const auto& a, const auto& b) { return a.source() < b.source(); });
        TransversalComponent c;
        c.kind = is_skew_pair ? Family::congruence : Family::segment;
        c.pieces = pieces;
        components_.push_back(c);
        return true;
    }

    void find_places() {
        places_ = ends_;
        for (const RationalLine3& l : carriers_) {
            for (const RationalLine3& k : carriers_) {
                if (l == k || !is_zero(side(l, k))) continue;
                const RationalPoint3 foot = foot_of_origin(l);
                const RationalPoint3 p = is_on(k, foot) ? foot + l.d : foot;
                planes_.insert(scaled_plane(plane_through(p, k)));
                const auto meeting = meeting_point(l, k);
                if (meeting.is_finite()) places_.insert(point_at(meeting.divided()));
            }
        }
        const std::set<Plane3, decltype(&is_less)> pairs = planes_;
        for (const Plane3& plane : pairs) {
            for (const RationalLine3& l : carriers_) {
                const auto crossing = meeting_point(l, plane);
                if (crossing.is_finite()) places_.insert(point_at(crossing.divided()));
            }
        }
    }
    [[nodiscard]] std::set<Plane3, decltype(&is_less)> planes_at(const RationalPoint3& x) const {
        std::set<Plane3, decltype(&is_less)> planes(&is_less);
        for (const Plane3& plane : planes_) {
            if (is_zero(plane.height(x))) planes.insert(plane);
        }
        for (const RationalLine3& l : carriers_) {
            if (!is_on(l, x)) planes.insert(scaled_plane(plane_through(x, l)));
        }
        return planes;
    }

    // The pieces of a walk that belong, and the single lines that do.
    std::vector<Piece> pieces_of(Walk walk,
                                 const std::function<bool(const RationalLine3&)>& belongs,
                                 bool& is_all) {
        std::sort(walk.critical.begin(), walk.critical.end(),
                  [](const Place& p, const Place& q) { return p && (!q || *p < *q); });
        walk.critical.erase(std::unique(walk.critical.begin(), walk.critical.end()),
                            walk.critical.end());
        const auto& c = walk.critical;
        std::vector<Piece> pieces;
        is_all = true;
        for (std::size_t i = 0; i < c.size(); ++i) {
            const Place& next = c[(i + 1) % c.size()];
            const Piece piece{c[i], between(c[i], next), next, accepts(walk.line(c[i]), belongs),
                              accepts(walk.line(next), belongs)};
            is_all = is_all && piece.has_from;
            if (piece.has_from) pool_.insert(walk.line(c[i]));
            if (!belongs(walk.line(piece.through))) {
                is_all = false;
                continue;
            }
            const bool joins = !pieces.empty() && pieces.back().to == c[i] && piece.has_from;
            if (joins) {
                pieces.back().to = piece.to;
                pieces.back().has_to = piece.has_to;
            } else {
                pieces.push_back(piece);
            }
        }
        if (pieces.size() > 1 && pieces.back().to == pieces.front().from && pieces.back().has_to) {
            pieces.front().from = pieces.back().from;
            pieces.front().has_from = pieces.back().has_from;
            pieces.pop_back();
        }
        return pieces;
    }
    [[nodiscard]] bool accepts(const RationalLine3& line,
                               const std::function<bool(const RationalLine3&)>&) const {
        return line.is_line() && meets_all(line);
    }

    void find_pencil(const RationalPoint3& x, const Plane3& plane) {
        const Vector3& n = plane.normal;
        const Vector3 axis = !is_zero(n.x) ? Vector3{0, 1, 0} : Vector3{1, 0, 0};
        const Vector3 e = cross(n, axis), f = cross(n, e);
        Walk walk;
        walk.line = [&](const Place& p) { return scaled(line_along(x, p ? *p * e + f : e)); };
        const auto add_direction = [&](const Vector3& d) {
            const Rational along_e = determinant(n, d, f), along_f = determinant(n, e, d);
            walk.critical.push_back(is_zero(along_f) ? Place() : Place(along_e / along_f));
        };
        for (const RationalPoint3& p : ends_) {
            if (p != x && is_zero(plane.height(p))) add_direction(p - x);
        }
        for (const RationalLine3& l : carriers_) {
            const auto crossing = meeting_point(l, plane);
            if (!crossing.is_finite()) {
                add_direction(l.d);
            } else if (const auto p = point_at(crossing.divided()); p != x) {
                add_direction(p - x);
            }
        }
        if (walk.critical.empty()) return;
        bool is_all = false;
        const auto pieces = pieces_of(
            walk, [&](const RationalLine3& l) { return meets_all(l) && !touches_region(plane, l); },
            is_all);
        if (pieces.empty() || holds_all(x)) return;
        TransversalComponent c;
        c.kind = Family::pencil;
        c.point = x;
        c.plane = plane;
        if (!is_all) {
            for (const Piece& p : pieces) c.ranges.push_back(pencil_range(walk, p, x, n));
        }
        add(std::move(c));
    }
    static TransversalRange pencil_range(const Walk& walk, const Piece& piece,
                                         const RationalPoint3& x, const Vector3& n) {
        TransversalRange r = range(walk, piece);
        if (r.from == r.to) {
            r.through = scaled(line_along(x, cross(n, r.from.d)));
            return r;
        }
        const auto side_of = [&](const Vector3& d) {
            return determinant(n, d, r.from.d).sign() * determinant(n, d, r.to.d).sign();
        };
        const Vector3 sum = r.from.d + r.to.d;
        r.through =
            scaled(line_along(x, side_of(sum) == side_of(r.through.d) ? sum : r.from.d - r.to.d));
        return r;
    }
    static TransversalRange range(const Walk& walk, const Piece& piece) {
        TransversalRange r{walk.line(piece.from), walk.line(piece.through), walk.line(piece.to),
                           piece.has_from, piece.has_to};
        if (r.to < r.from) {
            std::swap(r.from, r.to);
            std::swap(r.has_from, r.has_to);
        }
        return r;
    }

    void find_regulus() {
        if (carriers_.size() < 3 ||
            std::ranges::any_of(elements_, [](const auto& e) { return e.kind() == Kind::point; })) {
            return;
        }
        const std::vector<RationalLine3> all(carriers_.begin(), carriers_.end());
        for (const RationalLine3& l : all) {
            for (const RationalLine3& k : all) {
                if (!(l == k) && is_zero(side(l, k))) return;
            }
        }
        const RationalPoint3 a = foot_of_origin(all[0]);
        Walk walk;
        walk.line = [&](const Place& p) {
            if (p) return scaled(line_through(a + *p * all[0].d, all[1], all[2]));
            // The line parallel to the first: in the planes through the others along that direction.
            const auto plane = [&](const RationalLine3& l) {
                const Vector3 n = cross(all[0].d, l.d);
                return Plane3{n, dot(n, vector_to(foot_of_origin(l)))};
            };
            const RationalLine3 line = line_of(plane(all[1]), plane(all[2]));
            if (line.is_line()) return scaled(line);
            return RationalLine3{{}, scaled_plane(plane(all[1])).normal};
        };
        // The fourth line meets all of the others' lines or two of them.
        for (int t = 0; t < 3 && all.size() == 4; ++t) {
            if (!is_zero(side(walk.line(Rational(t)), all[3]))) return;
        }
        walk.critical.push_back(std::nullopt);
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (const RationalPoint3& p : ends_) {
                if (is_on(all[i], p)) add_transversal(walk, all, p, i);
            }
            // Where the line is parallel to this one.
            for (std::size_t j = 1; j < 3 && i > 0; ++j) {
                if (j == i) continue;
                const Vector3 n = cross(all[i].d, all[j].d);
                add_crossing(walk, all[0], {n, dot(n, vector_to(foot_of_origin(all[j])))});
            }
        }
        bool is_all = false;
        const auto pieces = pieces_of(
            walk, [&](const RationalLine3& l) { return l.is_line() && meets_all(l); }, is_all);
        if (pieces.empty()) return;
        TransversalComponent c;
        c.kind = Family::regulus;
        c.generators = {all[0], all[1], all[2]};
        if (!is_all) {
            for (const Piece& p : pieces) c.ranges.push_back(range(walk, p));
        }
        add(std::move(c));
    }
    // The place on the first line from where the line through p meets the others.
    static void add_transversal(Walk& walk, const std::vector<RationalLine3>& all,
                                const RationalPoint3& p, std::size_t i) {
        if (i == 0) {
            walk.critical.push_back(dot(p - foot_of_origin(all[0]), all[0].d) /
                                    dot(all[0].d, all[0].d));
            return;
        }
        const std::size_t j = i == 1 ? 2 : 1;
        add_crossing(walk, all[0], plane_through(p, all[j]));
    }
    static void add_crossing(Walk& walk, const RationalLine3& first, const Plane3& plane) {
        const auto x = meeting_point(first, plane);
        if (!x.is_finite()) return;
        walk.critical.push_back(dot(point_at(x.divided()) - foot_of_origin(first), first.d) /
                                dot(first.d, first.d));
    }

    [[nodiscard]] bool lies_in(const Plane3& plane, const RationalLine3& l) const {
        const RationalPoint3 p = foot_of_origin(l);
        return is_zero(plane.height(p)) && is_zero(plane.height(p + l.d));
    }

    // Whether lines near l in the plane, through none of the ends, meet all elements: l moved by a
    // little of another line w of the plane, to either side.
    [[nodiscard]] bool touches_region(const Plane3& plane, const RationalLine3& l) const {
        const auto samples = samples_.find(plane);
        if (samples == samples_.end() || !lies_in(plane, l)) return false;
        return std::ranges::any_of(samples->second, [&](const RationalLine3& w) {
            return meets_when_moved(plane, l, w, 1) || meets_when_moved(plane, l, w, -1);
        });
    }
    [[nodiscard]] bool meets_when_moved(const Plane3& plane, const RationalLine3& l,
                                        const RationalLine3& w, int side) const {
        const auto sign_at = [&](const RationalPoint3& p) {
            const Sign own = height_in(plane, l, p);
            return own != Sign::zero ? own : sign_of(side) * height_in(plane, w, p);
        };
        return std::ranges::all_of(elements_, [&](const TransversalElement& e) {
            if (e.kind() == Kind::point) return false;
            return e.kind() == Kind::line ||
                   sign_at(e.source()) * sign_at(e.target()) == Sign::negative;
        });
    }
    [[nodiscard]] static Sign height_in(const Plane3& plane, const RationalLine3& l,
                                        const RationalPoint3& p) {
        return dot(cross(l.d, plane.normal), p - foot_of_origin(l)).sign();
    }

    // One line inside of every open cell, through none of the ends: some mixture of three corners.
    void find_samples(const Plane3& plane, const std::vector<RationalLine3>& corners) {
        std::vector<RationalLine3>& samples = samples_[plane];
        std::set<std::vector<Sign>> known;
        const auto add_sample = [&](const RationalLine3& l) {
            if (!l.is_line() || !meets_when_moved(plane, l, l, 1)) return;
            std::vector<Sign> sides;
            for (const RationalPoint3& p : ends_) sides.push_back(height_in(plane, l, p));
            if (known.insert(sides).second) samples.push_back(l);
        };
        const auto add_mixture = [&](const RationalLine3& a, const RationalLine3& b,
                                     const RationalLine3& c) {
            add_sample({a.d + b.d + c.d, a.m + b.m + c.m});
        };
        // With a single segment beside lines there is one cell, and it has one corner.
        for (const TransversalElement& e : elements_) {
            const Vector3 u = e.target() - e.source();
            add_sample(line_along(e.source() + Rational(1) / 2 * u, cross(plane.normal, u)));
        }
        for (std::size_t i = 0; i < corners.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                for (std::size_t k = 0; k < j; ++k) {
                    add_mixture(corners[i], corners[j], corners[k]);
                    add_mixture(corners[i], corners[j], -corners[k]);
                    add_mixture(corners[i], -corners[j], corners[k]);
                    add_mixture(corners[i], -corners[j], -corners[k]);
                }
            }
        }
    }

    void find_region(const Plane3& plane) {
        for (const RationalPoint3& p : ends_) {
            if (!is_zero(plane.height(p))) return;
        }
        for (const RationalLine3& l : carriers_) {
            if (!lies_in(plane, l)) return;
        }
        if (std::ranges::any_of(elements_, [](const auto& e) { return e.kind() == Kind::point; })) {
            return;
        }
        std::set<RationalLine3> corners;  // some may be parallel to line elements
        for (const RationalPoint3& p : ends_) {
            for (const RationalPoint3& q : ends_) {
                if (!(p < q)) continue;
                const RationalLine3 l = scaled(line_through(p, q));
                const bool is_corner = std::ranges::all_of(elements_, [&](const auto& e) {
                    return e.kind() == Kind::line || meets(l, e);
                });
                if (is_corner) corners.insert(l);
            }
        }
        find_samples(plane, {corners.begin(), corners.end()});
        TransversalComponent c;
        c.kind = Family::plane;
        c.plane = plane;
        for (const RationalLine3& l : corners) {
            if (!meets_all(l)) continue;
            pool_.insert(l);
            if (touches_region(plane, l)) c.extremal.push_back(l);
        }
        if (!samples_[plane].empty()) add(std::move(c));
    }

    void add(Family kind, const RationalPoint3& x, const std::optional<Plane3>& plane) {
        TransversalComponent c;
        c.kind = kind;
        c.point = x;
        c.plane = plane;
        add(std::move(c));
    }
    void add(TransversalComponent c) {
        std::sort(c.ranges.begin(), c.ranges.end(), [](const auto& a, const auto& b) {
            return std::tie(a.from, a.to, a.through) < std::tie(b.from, b.to, b.through);
        });
        components_.push_back(std::move(c));
    }

    [[nodiscard]] bool is_in_component(const TransversalComponent& c, const SurdLine3& line) const {
        if (!is_in_family(c, line)) return false;
        if (c.kind != Family::plane) return true;
        const RationalLine3 rational{
            {line.d.x.rational_part(), line.d.y.rational_part(), line.d.z.rational_part()},
            {line.m.x.rational_part(), line.m.y.rational_part(), line.m.z.rational_part()}};
        return touches_region(*c.plane, rational);
    }

    std::vector<TransversalLine> isolated() {
        std::set<SurdLine3> found;
        const auto offer = [&](const SurdLine3& l) {
            if (l.d.is_zero() || !meets_all(l)) return;
            if (std::ranges::none_of(components_,
                                     [&](const auto& c) { return is_in_component(c, l); })) {
                found.insert(scaled(l));
            }
        };
        for (const RationalLine3& l : carriers_) pool_.insert(l);
        for (const RationalPoint3& p : places_) {
            for (const RationalPoint3& q : places_) {
                if (p < q) pool_.insert(scaled(line_through(p, q)));
            }
            for (const RationalLine3& l : carriers_) {
                for (const RationalLine3& k : carriers_) {
                    const RationalLine3 vee = line_through(p, l, k);
                    if (vee.is_line()) pool_.insert(scaled(vee));
                }
            }
        }
        for (const RationalLine3& l : pool_) offer(to_surd(l));
        std::optional<std::vector<SurdLine3>> all;
        if (elements_.size() == 4 && std::ranges::none_of(elements_, [](const auto& e) {
                return e.kind() == Kind::point;
            })) {
            all = lines_meeting({elements_[0].carrier(), elements_[1].carrier(),
                                 elements_[2].carrier(), elements_[3].carrier()});
        }
        if (all) std::ranges::for_each(*all, offer);
        const std::vector<SurdLine3> listed(found.begin(), found.end());
        std::vector<TransversalLine> lines;
        for (const SurdLine3& l : listed) {
            const auto& order = all ? *all : listed;
            const auto root = std::ranges::find(order, l) - order.begin();
            lines.push_back({l, static_cast<std::uint8_t>(root)});
        }
        return lines;
    }

    std::vector<TransversalComponent> sorted() {
        const auto key = [](const TransversalComponent& c) {
            return std::tuple(c.kind, c.plane ? c.plane->normal : Vector3{},
                              c.plane ? c.plane->offset : Rational(),
                              c.point.value_or(RationalPoint3{}));
        };
        std::sort(components_.begin(), components_.end(),
                  [&](const auto& a, const auto& b) { return key(a) < key(b); });
        return components_;
    }

    Elements elements_;
    std::set<RationalPoint3> ends_;
    std::set<RationalLine3> carriers_;
    std::set<RationalPoint3> places_;
    std::set<Plane3, decltype(&is_less)> planes_{&is_less};
    std::map<Plane3, std::vector<RationalLine3>, decltype(&is_less)> samples_{&is_less};
    std::set<RationalLine3> pool_;
    std::vector<TransversalComponent> components_;
};

}  // namespace

Transversals transversals(std::span<const TransversalElement> elements) {
    return Search(elements).run();
}

}  // namespace sightline::reference
