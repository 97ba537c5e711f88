// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/view/view_events.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <ostream>

#include "view/placed_scene.hpp"

namespace sightline {
namespace {

using Kind = ViewEventCause::Kind;

struct SurdLess {
    bool operator()(const Surd& a, const Surd& b) const { return a < b; }
};

/// A polynomial c[0] + c[1] t + c[2] t².
using Quadratic = std::array<Rational, 3>;

/// The places where the view may change.
class Candidates {
public:
    Candidates(const Scene3& scene, const RationalPoint3& source, const RationalPoint3& target)
        : scene_(scene), a_(vector_to(source)), d_(target - source) {
        for (const Point3& p : scene.vertices()) points_.push_back(vector_to(to_rational(p)));
        for (std::uint32_t e = 0; e < scene.edges().size(); ++e) add_line(EdgeId{e});
    }

    Result<std::map<Surd, std::vector<ViewEventCause>, SurdLess>> find(const Limits& limits) {
        find_planes();
        find_vertices();
        const auto n = static_cast<std::uint32_t>(lines_.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            if (limits.stop && limits.stop())
                return fail(Errc::cancelled, "the search was cancelled");
            if (limits.progress) limits.progress(0.5 * i / n);
            for (std::uint32_t j = i + 1; j < n; ++j) find_triples(i, j);
            if (found_.size() > limits.max_elements) {
                return fail(Errc::limit_reached,
                            "more than " + std::to_string(limits.max_elements) +
                                " places where the view may change; shorten the segment");
            }
        }
        return std::move(found_);
    }

private:
    /// An edge's line; normals of planes through it and p(t) are normal[0] + t normal[1], up to a factor.
    struct Line {
        EdgeId edge;
        VertexId source;
        VertexId target;
        std::array<Vector3, 2> normal;
        std::array<std::array<double, 3>, 2> rounded;
    };

    static std::array<double, 3> round(const Vector3& v) {
        return {v.x.approx_double(), v.y.approx_double(), v.z.approx_double()};
    }

    void add_line(EdgeId e) {
        const Edge3& edge = scene_[e];
        const Vector3& u = points_[edge.source.index()];
        const Vector3 along = points_[edge.target.index()] - u;
        // (u - p) × along for p = a + t d.
        Line line{e, edge.source, edge.target, {cross(u - a_, along), -cross(d_, along)}, {}};
        line.rounded = {round(line.normal[0]), round(line.normal[1])};
        lines_.push_back(std::move(line));
    }

    void add(const Surd& t, const ViewEventCause& cause) {
        if (t.sign() != Sign::positive || !(t < Surd(1))) return;
        found_[t].push_back(cause);
    }

    // The root of c0 + c1 t.
    static std::optional<Rational> root(const Rational& c0, const Rational& c1) {
        if (c1.sign() == Sign::zero) return std::nullopt;
        return -c0 / c1;
    }

    void find_planes() {
        for (std::uint32_t f = 0; f < scene_.faces().size(); ++f) {
            const auto& plane = scene_[FaceId{f}].plane;
            const Vector3& u = points_[plane[0].index()];
            const Vector3 normal =
                cross(points_[plane[1].index()] - u, points_[plane[2].index()] - u);
            if (const auto t = root(dot(normal, a_ - u), dot(normal, d_))) {
                add(*t, {Kind::face_plane, FaceId{f}, VertexId{}, {}});
            }
        }
    }

    void find_vertices() {
        for (std::uint32_t v = 0; v < points_.size(); ++v) {
            if (!scene_.is_feature(VertexId{v})) continue;
            for (const Line& line : lines_) {
                if (line.source.value == v || line.target.value == v) continue;
                const Vector3& u = points_[line.source.index()];
                const auto t =
                    root(dot(line.normal[0], points_[v] - u), dot(line.normal[1], points_[v] - u));
                if (!t || t->sign() != Sign::positive || *t >= Rational(1)) continue;
                if (meets(line, a_ + *t * d_, points_[v])) {
                    add(*t, {Kind::vertex_edge,
                             FaceId{},
                             VertexId{v},
                             {line.edge, EdgeId{}, EdgeId{}}});
                }
            }
        }
    }

    // Whether the ray from p through x meets the closed edge, given that they are coplanar.
    bool meets(const Line& line, const Vector3& p, const Vector3& x) const {
        const Vector3 u = points_[line.source.index()] - p;
        const Vector3 w = points_[line.target.index()] - p;
        const Vector3 r = x - p;
        const Vector3 normal = cross(u, w);
        // Seen end-on, or p and x in one place: anything may happen.
        if (normal.is_zero() || r.is_zero()) return true;
        return dot(cross(u, r), normal).sign() != Sign::negative &&
               dot(cross(r, w), normal).sign() != Sign::negative;
    }

    [[nodiscard]] static bool share_end(const Line& x, const Line& y) {
        return x.source == y.source || x.source == y.target || x.target == y.source ||
               x.target == y.target;
    }

    // det(n1(t), n2(t), n3(t)), whose cubic term vanishes when lines are Plücker lines through p(t)'s planes.
    [[nodiscard]] static Quadratic form(const Line& x, const Line& y, const Line& z) {
        const auto& [a0, a1] = x.normal;
        const auto& [b0, b1] = y.normal;
        const auto& [c0, c1] = z.normal;
        return {determinant(a0, b0, c0),
                determinant(a1, b0, c0) + determinant(a0, b1, c0) + determinant(a0, b0, c1),
                determinant(a1, b1, c0) + determinant(a1, b0, c1) + determinant(a0, b1, c1)};
    }

    // Whether the form certainly has no root between 0 and 1, by doubles in Bernstein form.
    [[nodiscard]] static bool has_no_root(const Line& x, const Line& y, const Line& z) {
        double size = 0;
        const auto det = [&](int i, int j, int k) {
            const auto& a = x.rounded[static_cast<std::size_t>(i)];
            const auto& b = y.rounded[static_cast<std::size_t>(j)];
            const auto& c = z.rounded[static_cast<std::size_t>(k)];
            const auto norm = [](const std::array<double, 3>& v) {
                return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
            };
            size += norm(a) * norm(b) * norm(c);
            return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
        };
        const double c0 = det(0, 0, 0);
        const double c1 = det(1, 0, 0) + det(0, 1, 0) + det(0, 0, 1);
        const double c2 = det(1, 1, 0) + det(1, 0, 1) + det(0, 1, 1);
        const double error = 0x1p-44 * size;
        const double middle = c0 + c1 / 2;
        const double end = c0 + c1 + c2;
        return (c0 > error && middle > error && end > error) ||
               (c0 < -error && middle < -error && end < -error);
    }

    void find_triples(std::uint32_t i, std::uint32_t j) {
        if (share_end(lines_[i], lines_[j])) return;
        for (std::uint32_t k = j + 1; k < lines_.size(); ++k) {
            if (share_end(lines_[i], lines_[k]) || share_end(lines_[j], lines_[k])) continue;
            if (has_no_root(lines_[i], lines_[j], lines_[k])) continue;
            const Quadratic c = form(lines_[i], lines_[j], lines_[k]);
            const ViewEventCause cause{Kind::three_edges,
                                       FaceId{},
                                       VertexId{},
                                       {lines_[i].edge, lines_[j].edge, lines_[k].edge}};
            if (c[2].sign() == Sign::zero) {
                if (const auto t = root(c[0], c[1])) add_triple(*t, cause, i, j, k);
                continue;
            }
            const Rational half = -c[1] / (Rational(2) * c[2]);
            const Rational radicand = half * half - c[0] / c[2];
            if (radicand.sign() == Sign::negative) continue;
            add_triple(Surd(half, 1, radicand), cause, i, j, k);
            if (radicand.sign() != Sign::zero) add_triple(Surd(half, -1, radicand), cause, i, j, k);
        }
    }

    // Keeps a root at which the line of sight that the planes share may meet all three edges.
    void add_triple(const Surd& t, const ViewEventCause& cause, std::uint32_t i, std::uint32_t j,
                    std::uint32_t k) {
        if (t.sign() != Sign::positive || !(t < Surd(1))) return;
        const double at = t.approx_double();
        const auto normal = [&](std::uint32_t line) {
            const auto& n = lines_[line].rounded;
            return std::array<double, 3>{n[0][0] + at * n[1][0], n[0][1] + at * n[1][1],
                                         n[0][2] + at * n[1][2]};
        };
        const auto times = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
            return std::array<double, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                         a[0] * b[1] - a[1] * b[0]};
        };
        const auto inner = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        };
        const auto n1 = normal(i);
        const auto n2 = normal(j);
        const auto direction = times(n1, n2);
        // Planes that are nearly one give no certain direction: kept.
        if (inner(direction, direction) < 1e-12 * inner(n1, n1) * inner(n2, n2)) {
            return add(t, cause);
        }
        const auto a = round(a_);
        const auto d = round(d_);
        for (const int sense : {1, -1}) {
            bool meets_all = true;
            for (const std::uint32_t line : {i, j, k}) {
                const auto u = round(points_[lines_[line].source.index()]);
                const auto w = round(points_[lines_[line].target.index()]);
                std::array<double, 3> ru{};
                std::array<double, 3> rw{};
                for (std::size_t c = 0; c < 3; ++c) {
                    const double p = a[c] + at * d[c];
                    ru[c] = u[c] - p;
                    rw[c] = w[c] - p;
                }
                const auto n = times(ru, rw);
                const double slack = 1e-9 * inner(n, n) + 1e-280;
                const double scale = std::sqrt(inner(direction, direction));
                std::array<double, 3> r{};
                for (std::size_t c = 0; c < 3; ++c) r[c] = sense * direction[c] / scale;
                const double size =
                    std::sqrt(std::max(inner(ru, ru), inner(rw, rw)) * inner(n, n)) * 1e-7;
                meets_all = meets_all && inner(times(ru, r), n) > -slack - size &&
                            inner(times(r, rw), n) > -slack - size;
            }
            if (meets_all) return add(t, cause);
        }
    }

    const Scene3& scene_;
    Vector3 a_;
    Vector3 d_;
    std::vector<Vector3> points_;
    std::vector<Line> lines_;
    std::map<Surd, std::vector<ViewEventCause>, SurdLess> found_;
};

// A rational number between two others of any kind, with few digits when that is possible.
Rational between(const Surd& x, const Surd& y) {
    Rational low(0);
    Rational high(1);
    while (true) {
        Rational middle = (low + high) / 2;
        if (Surd(middle) <= x) {
            low = std::move(middle);
        } else if (Surd(middle) >= y) {
            high = std::move(middle);
        } else {
            return middle;
        }
    }
}

}  // namespace

Result<ViewChange3> view_change(const PointVisibility3& visibility, const RationalPoint3& source,
                                const RationalPoint3& target, const Limits& limits) {
    if (source == target) {
        return fail(Errc::bad_parameter, "the segment has no length; give two points");
    }
    const Scene3& scene = *visibility.prepared().scene;
    auto candidates = Candidates(scene, source, target).find(limits);
    if (!candidates) return tl::unexpected(candidates.error());
    const auto from = [&](const Rational& t) {
        return visibility.from(source + t * (target - source));
    };
    ViewChange3 change{source, target, {}, {}};
    Surd last(0);
    std::optional<std::pair<Surd, std::vector<ViewEventCause>>> event;
    std::size_t done = 0;
    const auto step = [&](const Surd& next) -> Result<void> {
        auto view = from(between(last, next));
        if (!view) return tl::unexpected(view.error());
        if (event) {
            const bool differs = !(change.views.back().map == view->map);
            bool only_there = false;
            if (!differs && event->first.is_rational()) {
                const auto at = from(event->first.rational_part());
                if (!at) return tl::unexpected(at.error());
                only_there = !(at->map == view->map);
            }
            if (!differs && !only_there) return {};
            std::sort(event->second.begin(), event->second.end());
            change.events.push_back({event->first, event->second, !differs});
        }
        change.views.push_back(*std::move(view));
        return {};
    };
    for (auto& [at, causes] : *candidates) {
        if (limits.stop && limits.stop()) return fail(Errc::cancelled, "the search was cancelled");
        if (const auto stepped = step(at); !stepped) return tl::unexpected(stepped.error());
        event.emplace(at, std::move(causes));
        last = at;
        if (limits.progress) {
            limits.progress(0.5 + 0.5 * static_cast<double>(++done) /
                                      static_cast<double>(candidates->size()));
        }
    }
    if (const auto stepped = step(Surd(1)); !stepped) return tl::unexpected(stepped.error());
    return change;
}

std::ostream& operator<<(std::ostream& out, const ViewEventCause& cause) {
    switch (cause.kind) {
        case Kind::face_plane:
            return out << "plane of " << to_string(cause.face);
        case Kind::vertex_edge:
            return out << to_string(cause.vertex) << ' ' << to_string(cause.edges[0]);
        case Kind::three_edges:
            break;
    }
    return out << to_string(cause.edges[0]) << ' ' << to_string(cause.edges[1]) << ' '
               << to_string(cause.edges[2]);
}

}  // namespace sightline
