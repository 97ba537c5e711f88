// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <type_traits>

#include "scene/families2_detail.hpp"
#include "sightline/scene/transform2.hpp"

namespace sightline::families {

using namespace detail;

namespace {

template <typename... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

/// The shortest form that reads back as x.
std::string number(double x) {
    std::array<char, 32> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
    return {buffer.data(), error == std::errc{} ? end : buffer.data()};
}

/// a + b when that is a double: the error of the rounded sum (Knuth's two-sum) is zero.
std::optional<double> exact_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    const double error = (a - (sum - b_part)) + (b - b_part);
    return std::isfinite(sum) && error == 0 ? std::optional(sum) : std::nullopt;
}

/// a * b when that is a double. b is an integer, so no product underflows.
std::optional<double> exact_product(double a, double b) {
    const double product = a * b;
    const bool exact = std::isfinite(product) && std::fma(a, b, -product) == 0;
    return exact ? std::optional(product) : std::nullopt;
}

std::optional<double> exact_scaled(double x, int exponent) {
    if (exponent < -3000 || exponent > 3000) return x == 0 ? std::optional(x) : std::nullopt;
    const double scaled = std::ldexp(x, exponent);
    const bool exact = std::isfinite(scaled) && std::ldexp(scaled, -exponent) == x;
    return exact ? std::optional(scaled) : std::nullopt;
}

/// a x + b y when products and sum are doubles.
std::optional<double> exact_dot(double a, double x, double b, double y) {
    const std::optional<double> p = exact_product(x, a);
    const std::optional<double> q = exact_product(y, b);
    return p && q ? exact_sum(*p, *q) : std::nullopt;
}

using MovedPoint = std::optional<Point2>;

MovedPoint both(std::optional<double> x, std::optional<double> y) {
    return x && y ? MovedPoint(Point2{*x, *y}) : std::nullopt;
}

double nudged(Rng& rng, double x, unsigned per_mille) {
    if (rng.below(1000) >= per_mille) return x;
    const double infinity = std::numeric_limits<double>::infinity();
    return std::nextafter(x, rng.one_in(2) ? infinity : -infinity);
}

/// The scene with `move` applied to each point in input order; nullopt from `move`: can't be exact.
template <typename Move>
Result<SceneInput2> moved(const SceneInput2& scene, const Transform& transform, Move move) {
    SceneInput2 result = scene;
    std::optional<Errc> failure;
    const auto apply = [&](Point2& p) {
        const MovedPoint q = move(p);
        if (!q)
            failure = Errc::bad_parameter;
        else if (!std::isfinite(q->x) || !std::isfinite(q->y))
            failure = Errc::coordinate_too_large;
        else
            p = *q;
    };
    const auto apply_all = [&](std::vector<Point2>& points) {
        std::for_each(points.begin(), points.end(), apply);
    };
    for (SceneElement2& element : result.elements) {
        std::visit(Overloaded{[&](Polygon2& polygon) {
                                  apply_all(polygon.outer);
                                  for (Ring2& hole : polygon.holes) apply_all(hole);
                              },
                              [&](Polyline2& wall) { apply_all(wall.points); }, apply},
                   element);
    }
    if (!failure) return result;
    const bool inexact = *failure == Errc::bad_parameter;
    return fail(*failure,
                to_string(transform) + (inexact ? ": a coordinate can't be kept exact; use the "
                                                  "approx_ transform or smaller coordinates"
                                                : ": a coordinate overflows; use smaller ones"));
}

bool has_usable_parameters(const Transform& transform) {
    return std::visit(
        Overloaded{
            [](const Translation& t) { return std::isfinite(t.dx) && std::isfinite(t.dy); },
            [](const ApproxTranslation& t) { return std::isfinite(t.dx) && std::isfinite(t.dy); },
            [](const IntegerRotation& t) {
                constexpr std::int64_t most = std::int64_t{1} << 53;
                return (t.a != 0 || t.b != 0) && std::min(t.a, t.b) >= -most &&
                       std::max(t.a, t.b) <= most;
            },
            [](const ApproxScaling& t) { return std::isfinite(t.factor); },
            [](const ApproxRotation& t) { return std::isfinite(t.degrees); },
            [](const auto&) { return true; }},
        transform);
}

// What each transform does to one point, called in input order.

auto move_of(const Translation& t) {
    return [t](const Point2& p) { return both(exact_sum(p.x, t.dx), exact_sum(p.y, t.dy)); };
}
auto move_of(const PowerOfTwo& t) {
    return [t](const Point2& p) {
        return both(exact_scaled(p.x, t.exponent), exact_scaled(p.y, t.exponent));
    };
}
auto move_of(const IntegerRotation& t) {
    const auto a = static_cast<double>(t.a);
    const auto b = static_cast<double>(t.b);
    return [a, b](const Point2& p) {
        return both(exact_dot(a, p.x, -b, p.y), exact_dot(b, p.x, a, p.y));
    };
}
auto move_of(const Mirror&) {
    return [](const Point2& p) { return MovedPoint({0.0 - p.x, p.y}); };
}
auto move_of(const ApproxTranslation& t) {
    return [t](const Point2& p) { return MovedPoint({p.x + t.dx, p.y + t.dy}); };
}
auto move_of(const ApproxScaling& t) {
    return [t](const Point2& p) { return MovedPoint({p.x * t.factor, p.y * t.factor}); };
}
auto move_of(const ApproxRotation& t) {
    return [v = approx_cos_sin(t.degrees)](const Point2& p) {
        return MovedPoint({p.x * v.cosine - p.y * v.sine, p.x * v.sine + p.y * v.cosine});
    };
}
auto move_of(const Nudge& t) {
    return [t, rng = Rng(t.seed)](const Point2& p) mutable {
        const double x = nudged(rng, p.x, t.per_mille);
        return MovedPoint({x, nudged(rng, p.y, t.per_mille)});
    };
}

}  // namespace

bool is_exact(const Transform& transform) {
    return std::holds_alternative<Translation>(transform) ||
           std::holds_alternative<PowerOfTwo>(transform) ||
           std::holds_alternative<IntegerRotation>(transform) ||
           std::holds_alternative<Mirror>(transform) ||
           std::holds_alternative<Permutation>(transform);
}

std::string to_string(const Transform& transform) {
    const auto vector = [](double dx, double dy) { return number(dx) + ", " + number(dy); };
    return std::visit(
        Overloaded{
            [&](const Translation& t) { return "translation by " + vector(t.dx, t.dy); },
            [](const PowerOfTwo& t) { return "scaling by 2^" + std::to_string(t.exponent); },
            [](const IntegerRotation& t) {
                return "rotation by " + std::to_string(t.a) + " + " + std::to_string(t.b) + "i";
            },
            [](const Mirror&) { return std::string("mirror"); },
            [](const Permutation& t) { return "permutation, seed " + std::to_string(t.seed); },
            [&](const ApproxTranslation& t) {
                return "approx translation by " + vector(t.dx, t.dy);
            },
            [](const ApproxScaling& t) { return "approx scaling by " + number(t.factor); },
            [](const ApproxRotation& t) {
                return "approx rotation by " + number(t.degrees) + " degrees";
            },
            [](const Nudge& t) {
                return "nudge by one ulp, " + std::to_string(t.per_mille) + " in 1000, seed " +
                       std::to_string(t.seed);
            }},
        transform);
}

Result<SceneInput2> transformed(const SceneInput2& scene, const Transform& transform) {
    if (!has_usable_parameters(transform)) {
        return fail(Errc::bad_parameter,
                    to_string(transform) +
                        ": give finite numbers, and integers that doubles hold, not all 0");
    }
    return std::visit(
        Overloaded{[&](const Permutation& t) -> Result<SceneInput2> {
                       return permuted(scene, t.seed).scene;
                   },
                   [&](const auto& t) { return moved(scene, transform, move_of(t)); }},
        transform);
}

namespace {

/// A list of points with the number that each had.
struct Numbered {
    std::vector<Point2>* points;
    std::vector<std::uint32_t> numbers;
};

void reverse(Numbered& list) {
    std::reverse(list.points->begin(), list.points->end());
    std::reverse(list.numbers.begin(), list.numbers.end());
}

/// Chooses start and sense of a ring.
void permute_ring(Rng& rng, Numbered& ring) {
    if (ring.points->empty()) return;
    const auto shift = static_cast<std::ptrdiff_t>(rng.below(ring.points->size()));
    std::rotate(ring.points->begin(), ring.points->begin() + shift, ring.points->end());
    std::rotate(ring.numbers.begin(), ring.numbers.begin() + shift, ring.numbers.end());
    if (rng.one_in(2)) reverse(ring);
}

/// One element, its line in the file, and the numbers of its vertices.
struct NumberedElement {
    SceneElement2 element;
    std::uint32_t line = 0;
    std::vector<std::uint32_t> numbers;
};

std::vector<std::uint32_t> take_numbers(std::uint32_t& next, std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), next);
    next += static_cast<std::uint32_t>(count);
    return numbers;
}

void permute_polygon(Rng& rng, Polygon2& polygon, std::uint32_t& next,
                     std::vector<std::uint32_t>& numbers) {
    Numbered outer{&polygon.outer, take_numbers(next, polygon.outer.size())};
    permute_ring(rng, outer);
    numbers = outer.numbers;
    std::vector<std::pair<Ring2, std::vector<std::uint32_t>>> holes;
    for (Ring2& hole : polygon.holes) {
        Numbered ring{&hole, take_numbers(next, hole.size())};
        permute_ring(rng, ring);
        holes.emplace_back(std::move(hole), std::move(ring.numbers));
    }
    rng.shuffle(holes);
    polygon.holes.clear();
    for (auto& [hole, hole_numbers] : holes) {
        polygon.holes.push_back(std::move(hole));
        numbers.insert(numbers.end(), hole_numbers.begin(), hole_numbers.end());
    }
}

/// Permutes within the element.
void permute_element(Rng& rng, NumberedElement& item, std::uint32_t& next) {
    std::visit(
        Overloaded{[&](Polygon2& polygon) { permute_polygon(rng, polygon, next, item.numbers); },
                   [&](Polyline2& wall) {
                       Numbered list{&wall.points, take_numbers(next, wall.points.size())};
                       if (rng.one_in(2)) reverse(list);
                       item.numbers = std::move(list.numbers);
                   },
                   [&](Point2&) { item.numbers = take_numbers(next, 1); }},
        item.element);
}

}  // namespace

PermutedScene2 permuted(const SceneInput2& scene, std::uint64_t seed) {
    Rng rng(seed);
    std::vector<NumberedElement> items;
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < scene.elements.size(); ++i) {
        items.push_back({scene.elements[i], i < scene.lines.size() ? scene.lines[i] : 0, {}});
        permute_element(rng, items.back(), next);
    }
    const auto is_polygon = [](const NumberedElement& item) {
        return std::holds_alternative<Polygon2>(item.element);
    };
    const auto world =
        scene.world ? std::find_if(items.begin(), items.end(), is_polygon) : items.end();
    std::vector<NumberedElement> front;
    if (world != items.end()) {
        front.push_back(std::move(*world));
        items.erase(world);
    }
    rng.shuffle(items);
    std::move(items.begin(), items.end(), std::back_inserter(front));
    PermutedScene2 result{{.elements = {}, .world = scene.world, .file = scene.file, .lines = {}},
                          {}};
    for (NumberedElement& item : front) {
        result.scene.elements.push_back(std::move(item.element));
        if (!scene.lines.empty()) result.scene.lines.push_back(item.line);
        result.old_vertex.insert(result.old_vertex.end(), item.numbers.begin(), item.numbers.end());
    }
    return result;
}

}  // namespace sightline::families
