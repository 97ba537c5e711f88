// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which lines meet three segments, each polynomial written once for any number
/// type. Private.
///
/// A line that meets the skew segments i and j is a pair (t, u) of places on them. It meets the line
/// of k where h_k(t, u) = 0, a form that is linear in t and in u: its values at the ends of i and j
/// are four determinants. So u is a fractional linear function of t, and the lines that also meet l
/// are the roots of the quadratic h_k(t, 0) h_l(t, 1) - h_k(t, 1) h_l(t, 0). That u lies in [0, 1],
/// and that the point on k lies between k's ends, are sign conditions on linear forms of t, which
/// leave up to three intervals of t for each triple.

#include <array>
#include <optional>
#include <utility>

#include "arith/interval_cgal.hpp"
#include "geom/error_bounded.hpp"
#include "sightline/arith/rational.hpp"
#include "sightline/geom/vector3.hpp"

namespace sightline::detail {

inline std::optional<Sign> sign_if_certain(double x) { return sign_of(x); }
inline std::optional<Sign> sign_if_certain(const ErrorBounded& x) { return x.sign(); }
inline std::optional<Sign> sign_if_certain(const IntervalNumber& x) { return certain_sign(x); }
inline std::optional<Sign> sign_if_certain(const Rational& x) { return x.sign(); }

/// Takes signs and remembers whether one was not certain; then all that follows is void.
class Signs {
public:
    template <typename Number>
    Sign operator()(const Number& x) {
        const std::optional<Sign> sign = sign_if_certain(x);
        if (!sign) is_certain_ = false;
        return sign.value_or(Sign::zero);
    }
    [[nodiscard]] bool are_certain() const noexcept { return is_certain_; }

private:
    bool is_certain_ = true;
};

template <typename Number>
struct Ends {
    BasicVector3<Number> source;
    BasicVector3<Number> target;
};

/// A place in [0, 1]: n / d with d > 0. What lies strictly within says so, and needs no comparison
/// with the ends.
template <typename Number>
struct Fraction {
    Number n;
    Number d;
    Sign end = Sign::zero;  ///< negative: 0; positive: 1
};

template <typename Number>
[[nodiscard]] bool is_less(const Fraction<Number>& p, const Fraction<Number>& q, Signs& signs) {
    if (p.end != Sign::zero || q.end != Sign::zero) return p.end < q.end;
    return signs(p.n * q.d - q.n * p.d) == Sign::negative;
}

template <typename Number>
struct FractionRange {
    Fraction<Number> low;
    Fraction<Number> high;
};

/// A linear form by its values at t = 0 and t = 1.
template <typename Number>
struct FormValues {
    Number at0;
    Number at1;
};

/// What is known of the lines through i, j, k: h(t, 0) and h(t, 1), and the intervals of t.
template <typename Number>
struct TripleOfSegments {
    FormValues<Number> from_source;
    FormValues<Number> from_target;
    std::array<FractionRange<Number>, 3> ranges;
    int range_count = 0;
    bool is_certain = true;
};

/// Six times the volume of abcd, for differences taken beforehand.
template <typename Number>
[[nodiscard]] Number volume(const BasicVector3<Number>& a, const BasicVector3<Number>& b,
                            const BasicVector3<Number>& c, const BasicVector3<Number>& d) {
    return determinant(b - a, c - a, d - a);
}

/// t in [0, 1] for which f·g <= 0 for two pairs of forms.
template <typename Number>
class RangeFinder {
public:
    explicit RangeFinder(const std::array<FormValues<Number>, 4>& forms) : forms_(forms) {}

    void find(TripleOfSegments<Number>& triple) {
        for (int i = 0; i < 4; ++i) add_form(i);
        sort_roots();
        // Places: 0, the gap behind it, the first root, the gap behind it, …, 1.
        bool is_open = false;
        const int last = 2 * root_count_ + 2;
        for (int place = 0; place <= last && signs_.are_certain(); ++place) {
            const bool is_inside = holds_at(place);
            if (is_inside && !is_open) triple.ranges[triple.range_count].low = point(place);
            // A gap that ends here ends at the point before, or at this point when it holds.
            if (is_inside) triple.ranges[triple.range_count].high = point(place + place % 2);
            if (!is_inside && is_open) ++triple.range_count;
            is_open = is_inside;
        }
        if (is_open) ++triple.range_count;
        triple.is_certain = signs_.are_certain();
    }

private:
    void add_form(int i) {
        const Sign first = signs_(forms_[i].at0);
        const Sign second = signs_(forms_[i].at1);
        first_[i] = first;
        second_[i] = second;
        root_of_[i] = -1;
        if (first * second != Sign::negative) return;
        const auto& [at0, at1] = forms_[i];
        const Number none(0.0);
        const bool falls = first == Sign::positive;
        roots_[root_count_] = {
            i, falls ? Fraction<Number>{at0, at0 - at1} : Fraction<Number>{none - at0, at1 - at0}};
        ++root_count_;
    }
    void sort_roots() {
        for (int i = 1; i < root_count_; ++i) {
            for (int k = i; k > 0; --k) {
                const auto& p = roots_[k - 1].at;
                const auto& q = roots_[k].at;
                if (signs_(p.n * q.d - q.n * p.d) != Sign::positive) break;
                std::swap(roots_[k - 1], roots_[k]);
            }
        }
        int distinct = 0;
        for (int i = 0; i < root_count_; ++i) {
            const bool is_same =
                i > 0 && signs_(roots_[distinct - 1].at.n * roots_[i].at.d -
                                roots_[i].at.n * roots_[distinct - 1].at.d) == Sign::zero;
            if (!is_same) std::swap(roots_[distinct++], roots_[i]);
            root_of_[is_same ? roots_[i].form : roots_[distinct - 1].form] = distinct - 1;
        }
        root_count_ = distinct;
    }
    [[nodiscard]] Sign sign_at(int form, int place) const {
        const Sign first = first_[form];
        const Sign second = second_[form];
        if (place == 0) return first;
        if (place == 2 * root_count_ + 2) return second;
        if (root_of_[form] < 0) return first == Sign::zero ? second : first;
        const int own = 2 * root_of_[form] + 2;
        return place < own ? first : place > own ? second : Sign::zero;
    }
    [[nodiscard]] bool holds_at(int place) const {
        return sign_at(0, place) * sign_at(1, place) != Sign::positive &&
               sign_at(2, place) * sign_at(3, place) != Sign::positive;
    }
    [[nodiscard]] Fraction<Number> point(int place) const {
        const int number = place / 2;
        if (number == 0) return {Number(0.0), Number(1.0), Sign::negative};
        if (number > root_count_) return {Number(1.0), Number(1.0), Sign::positive};
        return roots_[number - 1].at;
    }

    struct Root {
        int form;
        Fraction<Number> at;
    };
    const std::array<FormValues<Number>, 4>& forms_;
    std::array<Root, 4> roots_;
    int root_count_ = 0;
    std::array<int, 4> root_of_{};
    std::array<Sign, 4> first_{};
    std::array<Sign, 4> second_{};
    Signs signs_;
};

template <typename Number>
[[nodiscard]] TripleOfSegments<Number> triple_of(const Ends<Number>& i, const Ends<Number>& j,
                                                 const Ends<Number>& k) {
    TripleOfSegments<Number> triple;
    triple.from_source = {volume(i.source, j.source, k.source, k.target),
                          volume(i.target, j.source, k.source, k.target)};
    triple.from_target = {volume(i.source, j.target, k.source, k.target),
                          volume(i.target, j.target, k.source, k.target)};
    const std::array<FormValues<Number>, 4> forms{
        triple.from_source, triple.from_target,
        FormValues<Number>{volume(i.source, j.source, j.target, k.source),
                           volume(i.target, j.source, j.target, k.source)},
        FormValues<Number>{volume(i.source, j.source, j.target, k.target),
                           volume(i.target, j.source, j.target, k.target)}};
    RangeFinder<Number>(forms).find(triple);
    return triple;
}

}  // namespace sightline::detail
