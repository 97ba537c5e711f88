// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/local_picture.hpp"

#include <algorithm>

namespace sightline::detail {
namespace {

const Rational& component(const Vector3& v, std::size_t k) {
    return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

bool parallel(const Vector3& a, const Vector3& b) { return cross(a, b).is_zero(); }

char letter(Sign s) { return s == Sign::positive ? '+' : s == Sign::negative ? '-' : '0'; }

// Whether v, in the plane of the cone, lies in the closed cone that its rays span.
bool in_cone(const Vector3& normal, const std::vector<Vector3>& rays, const Vector3& v) {
    const auto turn = [&](const Vector3& a, const Vector3& b) {
        return determinant(normal, a, b).sign();
    };
    for (const Vector3& a : rays) {
        if (turn(a, v) == Sign::zero && dot(a, v).sign() == Sign::positive) return true;
        for (const Vector3& b : rays) {
            if (turn(a, b) == Sign::positive && turn(a, v) == Sign::positive &&
                turn(v, b) == Sign::positive) {
                return true;
            }
        }
    }
    // A half plane has two opposite rays and a third one between them; a whole plane is covered by pairs.
    return false;
}

}  // namespace

LocalPicture::LocalPicture(const Vector3& delta) : delta_(delta) {
    while (axis_ < 2 && component(delta, axis_).sign() == Sign::zero) ++axis_;
}

// Points modulo the place: (r, w) less a multiple of (delta, w of the place), without the component that
// vanishes thereby. The viewpoint's direction is (0, 0, 1).
Vector3 LocalPicture::chart(const Vector3& r, const Rational& w) const {
    const std::size_t i = (axis_ + 1) % 3;
    const std::size_t j = (axis_ + 2) % 3;
    const Rational factor = component(r, axis_) / component(delta_, axis_);
    return {component(r, i) - factor * component(delta_, i),
            component(r, j) - factor * component(delta_, j), w - factor * w_};
}

LocalPicture::Cell LocalPicture::cell(const std::string& key) {
    const auto [it, is_new] =
        names_.emplace(std::to_string(place_) + key, static_cast<Cell>(parent_.size()));
    if (is_new) {
        parent_.push_back(it->second);
        inside_.push_back(0);
    }
    return it->second;
}

LocalPicture::Cell LocalPicture::root(Cell c) {
    while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
    return c;
}

void LocalPicture::join(Cell a, Cell b) {
    a = root(a);
    b = root(b);
    parent_[b] = a;
    inside_[a] = static_cast<char>(inside_[a] != 0 || inside_[b] != 0);
}

void LocalPicture::add_place(const Rational& w, const std::vector<Triangle>& triangles) {
    w_ = w;
    ++place_;
    planes_.clear();
    std::vector<Cone> cones;
    for (const Triangle& t : triangles) {
        const std::size_t i = (axis_ + 1) % 3;
        const std::size_t j = (axis_ + 2) % 3;
        Cone cone{{component(t.n, i), component(t.n, j), t.m}, t.is_sheet, {}};
        for (const auto& [r, weight] : t.corners) {
            const Vector3 ray = chart(r, weight);
            if (!ray.is_zero()) cone.rays.push_back(ray);
        }
        if (std::none_of(planes_.begin(), planes_.end(),
                         [&](const Vector3& p) { return parallel(p, cone.normal); })) {
            planes_.push_back(cone.normal);
        }
        cones.push_back(std::move(cone));
    }
    for (std::size_t p = 0; p < planes_.size(); ++p) cut_circle(p, cones);
}

void LocalPicture::cut_circle(std::size_t plane, const std::vector<Cone>& cones) {
    const Vector3& n = planes_[plane];
    std::vector<Vector3> cuts;
    const auto cut = [&](const Vector3& v) {
        // With the quarters, no arc is a half circle.
        for (const Vector3& c : {v, cross(n, v), -v, -cross(n, v)}) cuts.push_back(c);
    };
    for (const Vector3& other : planes_) {
        if (!parallel(n, other)) cut(cross(n, other));
    }
    for (const Cone& cone : cones) {
        if (!parallel(n, cone.normal)) continue;
        for (const Vector3& ray : cone.rays) cut(ray);
    }
    const Vector3 first = cuts.front();
    const auto turn = [&](const Vector3& v, const Vector3& w) {
        return determinant(n, v, w).sign();
    };
    const auto half = [&](const Vector3& v) {
        const Sign s = turn(first, v);
        if (s != Sign::zero) return s == Sign::positive ? 1 : 3;
        return dot(first, v).sign() == Sign::positive ? 0 : 2;
    };
    std::sort(cuts.begin(), cuts.end(), [&](const Vector3& v, const Vector3& w) {
        const int a = half(v);
        const int b = half(w);
        return a != b ? a < b : turn(v, w) == Sign::positive;
    });
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const Vector3& v = cuts[i];
        const Vector3& w = cuts[(i + 1) % cuts.size()];
        if (turn(v, w) == Sign::positive) visit_arc(plane, v + w, cones);
    }
}

void LocalPicture::visit_arc(std::size_t plane, const Vector3& middle,
                             const std::vector<Cone>& cones) {
    std::string key;
    for (const Vector3& p : planes_) key += letter(dot(p, middle).sign());
    key[plane] = '+';
    const Cell positive = cell(key);
    key[plane] = '-';
    const Cell negative = cell(key);
    bool is_covered = false;
    for (const Cone& cone : cones) {
        if (!parallel(cone.normal, planes_[plane])) continue;
        if (!in_cone(cone.normal, cone.rays, middle)) continue;
        is_covered = true;
        if (cone.is_sheet) continue;
        const bool same = dot(cone.normal, planes_[plane]).sign() == Sign::positive;
        inside_[root(same ? negative : positive)] = 1;
    }
    if (!is_covered) join(positive, negative);
}

std::vector<LocalPicture::Cell> LocalPicture::cells_round(bool to_viewpoint,
                                                          std::span<const Vector3> asides) {
    const Vector3 pole{0, 0, to_viewpoint ? 1 : -1};
    std::vector<Cell> cells;
    for (const Vector3& aside : asides) {
        const Vector3 v = chart(aside, 0);
        const Vector3 w = cross(pole, v);
        std::string key;
        for (const Vector3& p : planes_) {
            Sign s = dot(p, pole).sign();
            if (s == Sign::zero) s = dot(p, v).sign();
            if (s == Sign::zero) s = dot(p, w).sign();
            key += letter(s);
        }
        cells.push_back(cell(key));
    }
    return cells;
}

bool LocalPicture::connects(std::span<const Cell> from, std::span<const Cell> to) {
    for (const Cell a : from) {
        if (inside_[root(a)] != 0) continue;
        for (const Cell b : to) {
            if (root(a) == root(b)) return true;
        }
    }
    return false;
}

}  // namespace sightline::detail
