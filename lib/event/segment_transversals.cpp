// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/event/segment_transversals.hpp"

#include <algorithm>
#include <type_traits>

#include "event/pencil.hpp"
#include "event/scaled_segments.hpp"
#include "event/swath_polynomials.hpp"

namespace sightline {

namespace {

using detail::Ends;
using detail::ErrorBounded;
using detail::IntervalNumber;
using detail::QuadrupleHits;
using detail::ScaledSegments;
using detail::TripleOfSegments;

// Hits, and which root the smaller t is, when that had to be known.
struct Verdict {
    QuadrupleHits hits;
    std::optional<bool> smaller_is_first;
};

bool needs_order(const QuadrupleHits& hits) { return hits.smaller != hits.larger && !hits.is_only; }

template <typename Number>
Verdict verdict_on(const Ends<Number>& i, const Ends<Number>& j, const TripleOfSegments<Number>& k,
                   const TripleOfSegments<Number>& l) {
    if (!k.is_certain || !l.is_certain) return {{.is_certain = false}, {}};
    detail::RootCounter<Number> counter(k, l);
    Verdict verdict{counter.count(), {}};
    if (!verdict.hits.is_certain || !needs_order(verdict.hits)) return verdict;
    verdict.smaller_is_first = detail::smaller_is_first(i, j, k, counter.quadratic());
    return verdict;
}

Ends<IntervalNumber> as_interval(const Ends<Interval>& e) {
    const auto number = [](const Interval& x) { return IntervalNumber(x.lower, x.upper); };
    return {{number(e.source.x), number(e.source.y), number(e.source.z)},
            {number(e.target.x), number(e.target.y), number(e.target.z)}};
}

// Not inlined, so that no double operation strays into the scope that rounds upward.
[[gnu::noinline]] Verdict interval_verdict(const Ends<Interval>& i, const Ends<Interval>& j,
                                           const Ends<Interval>& k, const Ends<Interval>& l) {
    const detail::RoundingUp scope;
    const Ends<IntervalNumber> a = as_interval(i), b = as_interval(j);
    return verdict_on(a, b, detail::triple_of(a, b, as_interval(k)),
                      detail::triple_of(a, b, as_interval(l)));
}

[[gnu::noinline]] std::optional<Sign> interval_volume(const Ends<Interval>& i,
                                                      const Ends<Interval>& j) {
    const detail::RoundingUp scope;
    const Ends<IntervalNumber> a = as_interval(i), b = as_interval(j);
    return detail::certain_sign(detail::volume(a.source, a.target, b.source, b.target));
}

template <typename Number>
Number volume_of(const Ends<Number>& i, const Ends<Number>& j) {
    return detail::volume(i.source, i.target, j.source, j.target);
}

// Whether two coplanar elements on different lines have no point in common: then what meets both
// lies in their plane.
bool lie_apart_in_a_plane(const TransversalElement& a, const TransversalElement& b) {
    const RationalLine3 first = a.carrier(), second = b.carrier();
    if (!first.is_line() || !second.is_line()) return false;
    if (is_on(first, b.source()) && is_on(first, b.target())) return false;
    const auto meeting = meeting_point(first, second);
    if (!meeting.is_finite()) return true;
    const Vector3 v = meeting.divided();
    const RationalPoint3 p{v.x, v.y, v.z};
    return !(detail::holds(a, p) && detail::holds(b, p));
}

class Batch {
public:
    Batch(std::span<const RationalSegment3> segments, const TransversalOptions& options)
        : options_(options), scaled_(segments), n_(segments.size()) {
        for (const RationalSegment3& s : segments) {
            elements_.push_back(TransversalElement::segment(s));
        }
    }

    Result<SegmentTransversals> run() {
        find_coplanar();
        for (std::uint32_t i = 0; i + 3 < n_; ++i) {
            for (std::uint32_t j = i + 1; j + 2 < n_; ++j) {
                pair(i, j);
                report(i, j);
                if (error_) return tl::unexpected(*error_);
            }
        }
        return std::move(result_);
    }

private:
    void find_coplanar() {
        coplanar_.assign(n_ * n_, true);
        apart_.assign(n_ * n_, false);
        for (std::size_t i = 0; i < n_; ++i) {
            for (std::size_t j = i + 1; j < n_; ++j) {
                coplanar_[i * n_ + j] = coplanar_[j * n_ + i] = is_coplanar(i, j);
                if (!coplanar_[i * n_ + j] || options_.arithmetic != Arithmetic::filtered) continue;
                apart_[i * n_ + j] = lie_apart_in_a_plane(elements_[i], elements_[j]);
            }
        }
    }
    [[nodiscard]] bool is_coplanar(std::size_t i, std::size_t j) const {
        std::optional<Sign> sign;
        if (options_.arithmetic == Arithmetic::filtered) {
            sign = volume_of(scaled_.bounded[i], scaled_.bounded[j]).sign();
        }
        if (options_.arithmetic == Arithmetic::double_) {
            sign = sign_of(volume_of(scaled_.rounded[i], scaled_.rounded[j]));
        }
        if (options_.arithmetic == Arithmetic::interval) {
            sign = interval_volume(scaled_.enclosed[i], scaled_.enclosed[j]).value_or(Sign::zero);
        }
        if (!sign) sign = volume_of(scaled_.exact[i], scaled_.exact[j]).sign();
        return *sign == Sign::zero;
    }
    [[nodiscard]] bool coplanar(std::size_t i, std::size_t j) const {
        return coplanar_[i * n_ + j];
    }

    void pair(std::uint32_t i, std::uint32_t j) {
        switch (options_.arithmetic) {
            case Arithmetic::filtered:
                return pair_in(scaled_.bounded, i, j, Tier::filter);
            case Arithmetic::double_:
                return pair_in(scaled_.rounded, i, j, Tier::filter);
            case Arithmetic::exact:
                return pair_in(scaled_.exact, i, j, Tier::exact);
            case Arithmetic::interval:
                break;
        }
        for (std::uint32_t k = j + 1; k < n_; ++k) {
            for (std::uint32_t l = k + 1; l < n_ && !error_; ++l) {
                const SegmentSupport s{i, j, k, l};
                if (!is_skew_enough(s)) {
                    count(Tier::undecided);
                } else {
                    settle(s, s, interval_of(s), Tier::interval);
                }
            }
        }
    }

    template <typename Number>
    void pair_in(const std::vector<Ends<Number>>& ends, std::uint32_t i, std::uint32_t j,
                 Tier tier) {
        std::vector<TripleOfSegments<Number>> triples(n_);
        std::vector<bool> is_known(n_, false);
        for (std::uint32_t k = j + 1; k < n_ && !coplanar(i, j); ++k) {
            if (coplanar(i, k) || coplanar(j, k)) continue;
            triples[k] = detail::triple_of(ends[i], ends[j], ends[k]);
            is_known[k] = true;
        }
        for (std::uint32_t k = j + 1; k < n_; ++k) {
            for (std::uint32_t l = k + 1; l < n_ && !error_; ++l) {
                const SegmentSupport s{i, j, k, l};
                if (is_known[k] && is_known[l]) {
                    settle(s, s, verdict_on(ends[i], ends[j], triples[k], triples[l]), tier);
                } else {
                    coplanar_case(ends, s, tier);
                }
            }
        }
    }

    // Whether no two are coplanar but, perhaps, the last.
    [[nodiscard]] bool is_skew_enough(const SegmentSupport& s) const {
        return !coplanar(s[0], s[1]) && !coplanar(s[0], s[2]) && !coplanar(s[0], s[3]) &&
               !coplanar(s[1], s[2]) && !coplanar(s[1], s[3]);
    }

    // One coplanar pair does no harm in the last two places. With more, planes decide.
    template <typename Number>
    void coplanar_case(const std::vector<Ends<Number>>& ends, const SegmentSupport& s, Tier tier) {
        if (options_.arithmetic == Arithmetic::double_) return count(Tier::undecided);
        for (int a = 0; a < 4; ++a) {
            for (int b = a + 1; b < 4; ++b) {
                SegmentSupport t = s;
                std::swap(t[b], t[3]);
                std::swap(t[a], t[2]);
                if (!is_skew_enough(t)) continue;
                const auto& i = ends[t[0]];
                const auto& j = ends[t[1]];
                return settle(s, t,
                              verdict_on(i, j, detail::triple_of(i, j, ends[t[2]]),
                                         detail::triple_of(i, j, ends[t[3]])),
                              tier);
            }
        }
        if (is_one_beside_the_plane_of_two(s)) return count(Tier::filter);
        general(s);
    }

    // Whether a segment certainly misses a plane in which all lines lie that meet two others.
    [[nodiscard]] bool is_one_beside_the_plane_of_two(const SegmentSupport& s) const {
        for (const std::uint32_t a : s) {
            for (const std::uint32_t b : s) {
                if (a >= b || !apart_[a * n_ + b]) continue;
                for (const std::uint32_t c : s) {
                    if (c != a && c != b && is_beside_plane(a, b, c)) return true;
                }
            }
        }
        return false;
    }
    // Whether c lies strictly on one side of the plane of a and b, by doubles with a bound.
    [[nodiscard]] bool is_beside_plane(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const auto& e = scaled_.bounded;
        for (const auto& p : {e[b].source, e[b].target}) {
            const auto from = detail::volume(e[a].source, e[a].target, p, e[c].source).sign();
            const auto to = detail::volume(e[a].source, e[a].target, p, e[c].target).sign();
            if (from && to && *from * *to == Sign::positive) return true;
        }
        return false;
    }

    [[nodiscard]] Verdict interval_of(const SegmentSupport& t) const {
        const auto& e = scaled_.enclosed;
        return interval_verdict(e[t[0]], e[t[1]], e[t[2]], e[t[3]]);
    }
    [[nodiscard]] Verdict exact_of(const SegmentSupport& t) const {
        const auto& e = scaled_.exact;
        return verdict_on(e[t[0]], e[t[1]], detail::triple_of(e[t[0]], e[t[1]], e[t[2]]),
                          detail::triple_of(e[t[0]], e[t[1]], e[t[3]]));
    }
    [[nodiscard]] static bool is_settled(const Verdict& v) {
        return v.hits.is_certain &&
               (!needs_order(v.hits) || v.hits.needs_general || v.smaller_is_first.has_value());
    }

    // Takes a verdict on the segments in the order t, asking further tiers where it is open.
    void settle(const SegmentSupport& s, const SegmentSupport& t, Verdict verdict, Tier tier) {
        if (!is_settled(verdict) && options_.arithmetic == Arithmetic::filtered) {
            verdict = interval_of(t);
            tier = Tier::interval;
            if (!is_settled(verdict)) verdict = exact_of(t), tier = Tier::exact;
        }
        const QuadrupleHits& hits = verdict.hits;
        const bool is_open = !is_settled(verdict) || hits.needs_general;
        if (is_open && is_exact_allowed()) return general(s);
        count(is_open ? Tier::undecided : tier);
        if (is_open || !hits.any()) return;
        if (hits.is_only) return add(s, 0);
        if (hits.smaller && hits.larger) {
            add(s, 0);
            return add(s, 1);
        }
        add(s, hits.smaller == *verdict.smaller_is_first ? 0 : 1);
    }
    [[nodiscard]] bool is_exact_allowed() const {
        return options_.arithmetic == Arithmetic::filtered ||
               options_.arithmetic == Arithmetic::exact;
    }

    void general(const SegmentSupport& s) {
        if (++general_calls_ % 256 == 0 && options_.limits.stop && options_.limits.stop()) {
            error_ = Error{Errc::cancelled, "stopped while looking for lines through segments"};
        }
        count(Tier::exact);
        const std::array<TransversalElement, 4> four{elements_[s[0]], elements_[s[1]],
                                                     elements_[s[2]], elements_[s[3]]};
        Transversals found = transversals(four);
        for (const TransversalLine& line : found.lines) add(s, line.root);
        for (TransversalComponent& c : found.components) {
            result_.components.push_back({s, std::move(c)});
        }
        check_size();
    }

    void add(const SegmentSupport& s, std::uint8_t root) {
        result_.lines.push_back({s, root});
        check_size();
    }
    void check_size() {
        const std::size_t size = result_.lines.size() + result_.components.size();
        if (size <= options_.limits.max_elements) return;
        error_ = Error{Errc::limit_reached,
                       "more than " + std::to_string(options_.limits.max_elements) +
                           " lines and components; raise the limit or leave out segments"};
    }
    void count(Tier tier) {
        if (options_.tally != nullptr) options_.tally->add(Predicate::transversals3, tier);
    }
    void report(std::uint32_t i, std::uint32_t j) {
        if (options_.limits.progress && j + 3 == n_) {
            const double rest = 1 - (i + 1.0) / static_cast<double>(n_ - 3);
            options_.limits.progress(1 - rest * rest * rest * rest);
        }
        if (options_.limits.stop && options_.limits.stop()) {
            error_ = Error{Errc::cancelled, "stopped while looking for lines through segments"};
        }
    }

    const TransversalOptions& options_;
    ScaledSegments scaled_;
    std::size_t n_;
    std::vector<TransversalElement> elements_;
    std::vector<bool> coplanar_;
    std::vector<bool> apart_;  // of coplanar ones, those without a common point
    SegmentTransversals result_;
    std::optional<Error> error_;
    std::size_t general_calls_ = 0;
};

// Of two conjugate lines that meet three pairwise skew segments and a fourth, the first or second;
// empty where the lines are rational or the first three are not skew.
std::optional<SurdLine3> irrational_line(const std::vector<TransversalElement>& four,
                                         std::uint8_t root) {
    const RationalLine3 l1 = four[0].carrier(), l2 = four[1].carrier(), l3 = four[2].carrier();
    for (const Rational& x : {side(l1, l2), side(l1, l3), side(l2, l3)}) {
        if (x.sign() == Sign::zero) return std::nullopt;
    }
    const Vector3 a = vector_to(four[0].source());
    const auto swath =
        detail::swath(detail::moving_plane(a, l1.d, l2), detail::moving_plane(a, l1.d, l3));
    const auto f = detail::side_polynomial(swath, four[3].carrier());
    const Rational discriminant = f.c1 * f.c1 - 4 * f.c0 * f.c2;
    if (f.c2.sign() == Sign::zero || discriminant.sign() != Sign::positive) return std::nullopt;
    const Rational twice = 2 * f.c2;
    const Surd t(-f.c1 / twice, Rational(1) / twice, discriminant);
    if (t.is_rational()) return std::nullopt;
    // t² from the quadratic, so that each coordinate is linear in t.
    const Rational square = -f.c1 / f.c2, constant = -f.c0 / f.c2;
    const auto value = [&](const Rational& c0, const Rational& c1, const Rational& c2) {
        return Surd(c0 + c2 * constant) + Surd(c1 + c2 * square) * t;
    };
    const auto vector = [&](const detail::Quadratic<Vector3>& v) {
        return SurdVector3{value(v.c0.x, v.c1.x, v.c2.x), value(v.c0.y, v.c1.y, v.c2.y),
                           value(v.c0.z, v.c1.z, v.c2.z)};
    };
    SurdLine3 line{vector(swath.d), vector(swath.m)};
    const Surd& by = line.d.x != Surd() ? line.d.x : line.d.y != Surd() ? line.d.y : line.d.z;
    const Surd inverse = Surd(1) / by;
    line = {inverse * line.d, inverse * line.m};
    const auto c = line.coordinates();
    const SurdLine3 other{{c[0].conjugate(), c[1].conjugate(), c[2].conjugate()},
                          {c[3].conjugate(), c[4].conjugate(), c[5].conjugate()}};
    return (line < other) == (root == 0) ? line : other;
}

}  // namespace

Result<SegmentTransversals> transversals(std::span<const RationalSegment3> segments,
                                         const TransversalOptions& options) {
    return Batch(segments, options).run();
}

SurdLine3 exact_line(std::span<const RationalSegment3> segments,
                     const SegmentTransversals::Line& line) {
    std::vector<TransversalElement> four;
    for (const std::uint32_t i : line.support) {
        SIGHTLINE_EXPECT(i < segments.size());
        four.push_back(TransversalElement::segment(segments[i]));
    }
    if (auto quick = irrational_line(four, line.root)) return std::move(*quick);
    const Transversals all = transversals(four);
    const auto found = std::ranges::find(all.lines, line.root, &TransversalLine::root);
    SIGHTLINE_EXPECT(found != all.lines.end());
    return found->line;
}

}  // namespace sightline
