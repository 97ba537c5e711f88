// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Paths through two-parameter families of lines. Private.

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>

#include "sightline/event/swath.hpp"
#include "sightline/scene/scene3.hpp"
#include "spatial/scene_forms.hpp"

namespace sightline::detail {

/// All lines through a vertex, or all that meet two skew edges in their relative interiors.
struct LineFamily2 {
    std::optional<VertexId> vertex;
    std::optional<std::pair<EdgeId, EdgeId>> edges;
};

/// Lines of the family for t from 0 to 1.
struct LinePath {
    LineFamily2 family;
    LineCurve3 curve;
    /// Values of t at which the line passes through a vertex on one of the family's edges.
    std::vector<std::pair<Rational, VertexId>> vertices;
};

/// The same numbers on every platform.
class CheckRandom {
public:
    explicit CheckRandom(std::uint64_t seed) : engine_(seed) {}
    /// 0 … n − 1.
    [[nodiscard]] std::size_t index(std::size_t n) { return engine_() % n; }
    /// Strictly between 0 and 1, with 20 bits.
    [[nodiscard]] Rational fraction();
    /// Strictly between −1 and 1.
    [[nodiscard]] Rational signed_fraction() { return Rational(2) * fraction() - Rational(1); }

private:
    std::mt19937_64 engine_;
};

class PathMaker {
public:
    PathMaker(const Scene3& scene, CheckRandom& random);

    /// A path through lines of a vertex; in the middle it passes `through`, when that is given.
    [[nodiscard]] LinePath through_vertex(VertexId v, const std::optional<RationalLine3>& through);
    /// The same for two skew edges.
    [[nodiscard]] LinePath over_edges(EdgeId e, EdgeId f,
                                      const std::optional<RationalLine3>& through);

private:
    [[nodiscard]] RationalPoint3 random_point();
    void add_vertices_on(EdgeId e, const RationalPoint3& a, const Vector3& u, LinePath& path) const;

    const Scene3* scene_;
    CheckRandom* random_;
    RationalPoint3 low_;
    Vector3 size_;
};

/// Tells at once of most edges that no line of a path meets them.
class PathFilter {
public:
    PathFilter(const LineCurve3& curve, const SceneForms& forms);
    [[nodiscard]] bool surely_never_meets(EdgeId e) const;

private:
    const SceneForms* forms_;
    std::array<PluckerOf<Real>, 3> curve_;
};

/// A rational number strictly between a < b; empty when doubles don't tell them apart.
[[nodiscard]] std::optional<Rational> rational_between(const Surd& a, const Surd& b);

}  // namespace sightline::detail
