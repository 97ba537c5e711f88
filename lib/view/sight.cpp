// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/sight.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "view/local_picture.hpp"

namespace sightline::detail {
namespace {

using Kind = ViewRegion::Kind;

const Rational& component(const Vector3& v, std::size_t k) {
    return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

std::size_t nonzero_component(const Vector3& v) {
    for (std::size_t k = 0; k < 2; ++k) {
        if (component(v, k).sign() != Sign::zero) return k;
    }
    return 2;
}

// The sign of a linear form on delta + ε aside + ε² along.
Sign first_sign(const Rational& at_delta, const Rational& at_aside, const Rational& at_along) {
    if (at_delta.sign() != Sign::zero) return at_delta.sign();
    if (at_aside.sign() != Sign::zero) return at_aside.sign();
    return at_along.sign();
}

}  // namespace

void for_triangles_near(const Image& image, const std::array<double, 3>& near,
                        std::vector<std::uint32_t>& out) {
    const Point3 c = approx_point(image.from().coordinates);
    std::array<double, 3> origin{c.x, c.y, c.z};
    std::array<double, 3> d{};
    const Box3 bounds = image.scene().bvh.bounds();
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        d[k] = image.at_infinity() ? origin[k] : near[k] - origin[k];
        if (image.at_infinity()) origin[k] = near[k];
        size = std::max({size, std::abs(bounds.low[k]), std::abs(bounds.high[k]),
                         std::abs(origin[k]), std::abs(near[k])});
    }
    const double length = std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
    // Rejects only what is certainly off the line: infinities and NaN reject nothing.
    const auto descend = [&](const Box3& box) {
        std::array<double, 3> m{};
        std::array<double, 3> h{};
        double reach = length;
        for (std::size_t k = 0; k < 3; ++k) {
            m[k] = (box.low[k] / 2 + box.high[k] / 2) - origin[k];
            h[k] = box.high[k] / 2 - box.low[k] / 2;
            reach += std::abs(m[k]) + h[k];
        }
        const double margin = 0x1p-44 * (size * reach + length * reach) + 0x1p-1000;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3;
            const std::size_t j = (k + 2) % 3;
            if (std::abs(d[i] * m[j] - d[j] * m[i]) >
                std::abs(d[i]) * h[j] + std::abs(d[j]) * h[i] + margin) {
                return false;
            }
        }
        if (image.at_infinity()) return true;
        const double ahead = d[0] * m[0] + d[1] * m[1] + d[2] * m[2];
        const double half = std::abs(d[0]) * h[0] + std::abs(d[1]) * h[1] + std::abs(d[2]) * h[2];
        return !(ahead + half < -margin);
    };
    image.scene().bvh.traverse(descend, [&](std::uint32_t t) { out.push_back(t); });
}

Sight::Sight(Image& image, const Vector3& delta, const std::array<double, 3>& near)
    : image_(image), delta_(delta) {
    gather(near);
}

void Sight::gather(const std::array<double, 3>& near) {
    std::vector<std::uint32_t> triangles;
    for_triangles_near(image_, near, triangles);
    std::sort(triangles.begin(), triangles.end());
    const std::array<double, 3> d{delta_.x.approx_double(), delta_.y.approx_double(),
                                  delta_.z.approx_double()};
    // Most are passed at a distance: the line is certainly on different sides of two of their sides.
    const auto is_passed = [&](const PlacedTriangle& t) {
        bool left = false;
        bool right = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const SightPlane side = image_.plane(t.corners[k], t.corners[(k + 1) % 3]);
            double at = 0;
            double error = 0x1p-1000;
            for (std::size_t i = 0; i < 3; ++i) {
                at += side.normal[i] * d[i];
                error += 0x1p-48 * side.size[i] * std::abs(d[i]);
            }
            left = left || at > error;
            right = right || at < -error;
        }
        return left && right;
    };
    for (const std::uint32_t t : triangles) {
        if (!is_passed(image_.scene().triangles[t])) add(t);
    }
}

void Sight::add(std::uint32_t triangle) {
    const PlacedTriangle& t = image_.scene().triangles[triangle];
    const Vector3& a = image_.exact(t.corners[0]);
    const Vector3& b = image_.exact(t.corners[1]);
    const Vector3& c = image_.exact(t.corners[2]);
    const Vector3 ab = cross(a, b);
    const Vector3 bc = cross(b, c);
    const Vector3 ca = cross(c, a);
    Hit hit;
    hit.triangle = triangle;
    hit.is_sheet = image_.scene().face_is_sheet[t.face] != 0;
    hit.m = -dot(a, bc);
    hit.n = image_.exact_weight(t.corners[0]) * bc + image_.exact_weight(t.corners[1]) * ca +
            image_.exact_weight(t.corners[2]) * ab;
    const Rational height = dot(hit.n, delta_);
    if (hit.m.sign() == Sign::zero) {
        if (height.sign() != Sign::zero || !add_in_plane(hit)) return;
    } else {
        for (const Vector3* side : {&ab, &bc, &ca}) {
            if ((-dot(*side, delta_)).sign() * hit.m.sign() == Sign::negative) return;
        }
        hit.far = -height / hit.m;
        hit.near = hit.far;
    }
    hits_.push_back(std::move(hit));
}

// A triangle in a plane through the viewpoint that contains the line: a piece of the line, if any.
bool Sight::add_in_plane(Hit& hit) const {
    const PlacedTriangle& t = image_.scene().triangles[hit.triangle];
    const std::size_t axis = nonzero_component(hit.n);
    const std::size_t k = nonzero_component(delta_);
    std::array<Rational, 3> side;
    for (std::size_t i = 0; i < 3; ++i) {
        side[i] = component(cross(delta_, image_.exact(t.corners[i])), axis);
    }
    hit.in_plane = true;
    bool ahead = false;
    bool behind = false;
    const auto meet = [&](const Vector3& r, const Rational& w) {
        const Rational factor = component(r, k) / component(delta_, k);
        if (factor.sign() != Sign::positive) {
            behind = true;  // at the viewpoint, or beyond it
            return;
        }
        const Rational at = w / factor;
        if (!ahead || at < hit.far) hit.far = at;
        if (!ahead || at > hit.near) hit.near = at;
        ahead = true;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::uint32_t p = t.corners[i];
        const std::uint32_t q = t.corners[j];
        if (side[i].sign() == Sign::zero) meet(image_.exact(p), image_.exact_weight(p));
        if (side[i].sign() * side[j].sign() != Sign::negative) continue;
        const Rational whole = side[j] - side[i];
        const Rational s = side[j] / whole;
        const Rational r = -side[i] / whole;
        meet(s * image_.exact(p) + r * image_.exact(q),
             s * image_.exact_weight(p) + r * image_.exact_weight(q));
    }
    hit.near_is_infinite = ahead && behind;
    return ahead;
}

std::vector<Sight::Piece> Sight::pieces_until(const Rational& w) const {
    std::set<Rational> places;
    for (const Hit& hit : hits_) {
        if (hit.far > w) places.insert(hit.far);
        if (!hit.near_is_infinite && hit.near > w) places.insert(hit.near);
    }
    std::vector<Piece> pieces;
    std::optional<Rational> near;
    const auto add_piece = [&](const Rational& far) {
        Piece piece;
        piece.near = near;
        piece.far = far;
        piece.middle = near ? (*near + far) / 2 : far + 1;
        for (const Hit& hit : hits_) {
            if (hit.in_plane && hit.far <= far &&
                (hit.near_is_infinite || (near && hit.near >= *near))) {
                piece.fins.push_back(&hit);
            }
        }
        pieces.push_back(std::move(piece));
        near = far;
    };
    for (auto place = places.rbegin(); place != places.rend(); ++place) add_piece(*place);
    add_piece(w);
    return pieces;
}

Vector3 Sight::independent_of(const Vector3& aside) const { return cross(delta_, aside); }

// One direction aside of the line for each sector between the half planes of the fins round it.
Sight::Sectors Sight::sectors_of(const Piece& piece) const {
    std::vector<Vector3> rays;
    for (const Hit* fin : piece.fins) {
        const PlacedTriangle& t = image_.scene().triangles[fin->triangle];
        const std::size_t axis = nonzero_component(fin->n);
        bool left = false;
        bool right = false;
        for (const std::uint32_t corner : t.corners) {
            const Vector3& r = image_.exact(corner);
            const Sign s = component(cross(delta_, r), axis).sign();
            if (s == Sign::positive && !left) rays.push_back(r);
            if (s == Sign::negative && !right) rays.push_back(r);
            left = left || s == Sign::positive;
            right = right || s == Sign::negative;
        }
    }
    if (rays.empty()) {
        Vector3 aside = cross(delta_, Vector3{1, 0, 0});
        if (aside.is_zero()) aside = cross(delta_, Vector3{0, 1, 0});
        return {aside};
    }
    // Flat vectors, perpendicular to delta, sorted by angle from the first.
    for (Vector3& r : rays) r = cross(delta_, r);
    const Vector3 first = rays.front();
    const auto turn = [&](const Vector3& v, const Vector3& w) {
        return determinant(delta_, v, w).sign();
    };
    const auto half = [&](const Vector3& v) {
        const Sign s = turn(first, v);
        if (s != Sign::zero) return s == Sign::positive ? 1 : 3;
        return dot(first, v).sign() == Sign::positive ? 0 : 2;
    };
    std::sort(rays.begin(), rays.end(), [&](const Vector3& v, const Vector3& w) {
        const int a = half(v);
        const int b = half(w);
        return a != b ? a < b : turn(v, w) == Sign::positive;
    });
    rays.erase(std::unique(rays.begin(), rays.end(),
                           [&](const Vector3& v, const Vector3& w) {
                               return turn(v, w) == Sign::zero &&
                                      dot(v, w).sign() == Sign::positive;
                           }),
               rays.end());
    Sectors sectors;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vector3& v = rays[i];
        const Vector3& w = rays[(i + 1) % rays.size()];
        Vector3 between = rays.size() == 1 ? -v : v + w;
        if (rays.size() > 1) {
            const Sign s = turn(v, w);
            if (s == Sign::zero) between = cross(delta_, v);
            if (s == Sign::negative) between = -between;
        }
        // The rays were turned by a right angle about delta; turn back.
        sectors.push_back(-cross(delta_, between));
    }
    return sectors;
}

bool Sight::is_hit(const Hit& hit, const Vector3& aside, const Vector3& along) {
    if (hit.in_plane) return false;
    const PlacedTriangle& t = image_.scene().triangles[hit.triangle];
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector3 side =
            cross(image_.exact(t.corners[(k + 1) % 3]), image_.exact(t.corners[k]));
        const Sign s = first_sign(dot(side, delta_), dot(side, aside), dot(side, along));
        if (s * hit.m.sign() != Sign::positive) return false;
    }
    return true;
}

// Whether, aside of the line's point of weight w, there is the interior of a solid.
bool Sight::is_inside(const Rational& w, const Vector3& aside) {
    const Vector3 along = independent_of(aside);
    const Hit* nearest = nullptr;
    const auto is_nearer = [&](const Hit& a, const Hit& b) {
        if (a.far != b.far) return a.far > b.far;
        for (const Vector3* v : {&aside, &along}) {
            const Rational x = -dot(a.n, *v) / a.m;
            const Rational y = -dot(b.n, *v) / b.m;
            if (x != y) return x > y;
        }
        // Two bodies in contact: what comes first is the back of the nearer one.
        return a.m.sign() == Sign::negative;
    };
    for (const Hit& hit : hits_) {
        if (hit.is_sheet || hit.far >= w || !is_hit(hit, aside, along)) continue;
        if (nearest == nullptr || is_nearer(hit, *nearest)) nearest = &hit;
    }
    if (nearest == nullptr) return image_.scene().has_world;
    return nearest->m.sign() == Sign::negative;
}

bool Sight::is_free_until(const Rational& w) {
    const std::vector<Piece> pieces = pieces_until(w);
    for (const Piece& piece : pieces) {
        const Sectors sectors = sectors_of(piece);
        const bool sealed = std::all_of(sectors.begin(), sectors.end(), [&](const Vector3& aside) {
            return is_inside(piece.middle, aside);
        });
        if (sealed) return false;
    }
    return !image_.scene().has_sheets || !crosses_sheet(pieces);
}

SightEnd Sight::look(const Vector3& aside, const Vector3& along) {
    std::vector<const Hit*> nearest;
    const auto compare = [&](const Hit& a, const Hit& b) {
        if (a.far != b.far) return a.far <=> b.far;
        for (const Vector3* v : {&aside, &along}) {
            const Rational x = -dot(a.n, *v) / a.m;
            const Rational y = -dot(b.n, *v) / b.m;
            if (x != y) return x <=> y;
        }
        return std::strong_ordering::equal;
    };
    for (const Hit& hit : hits_) {
        // From a point, what lies behind has a negative weight.
        if (!image_.at_infinity() && hit.far.sign() != Sign::positive) continue;
        if (!is_hit(hit, aside, along)) continue;
        const auto order =
            nearest.empty() ? std::strong_ordering::greater : compare(hit, *nearest.front());
        if (order > 0) nearest.clear();
        if (order >= 0) nearest.push_back(&hit);
    }
    SightEnd end;
    const Scene3& scene = *image_.scene().scene;
    if (nearest.empty()) {
        if (image_.scene().has_world) {
            end.kind = Kind::blocked;
            end.body = BodyId{0};
        }
        return end;
    }
    end.kind = Kind::face;
    for (const Hit* hit : nearest) {
        const FaceId face{image_.scene().triangles[hit->triangle].face};
        const bool back = hit->m.sign() == Sign::negative;
        if (back && !hit->is_sheet) {
            SightEnd blocked;
            blocked.kind = Kind::blocked;
            blocked.body = scene[face].body;
            return blocked;
        }
        end.faces.push_back({face, back});
    }
    std::sort(end.faces.begin(), end.faces.end());
    end.faces.erase(std::unique(end.faces.begin(), end.faces.end()), end.faces.end());
    return end;
}

std::vector<const Sight::Hit*> Sight::hits_at(const Rational& w, bool with_sheets) const {
    std::vector<const Hit*> hits;
    for (const Hit& hit : hits_) {
        if (hit.is_sheet && !with_sheets) continue;
        if (hit.far <= w && (hit.near_is_infinite || hit.near >= w)) hits.push_back(&hit);
    }
    return hits;
}

bool Sight::crosses_sheet(const std::vector<Piece>& pieces) const {
    const auto in_sheet = [](const Piece& piece) {
        return std::any_of(piece.fins.begin(), piece.fins.end(),
                           [](const Hit* hit) { return hit->is_sheet; });
    };
    const auto place_in_sheet = [&](const Rational& w) {
        const auto hits = hits_at(w, true);
        return std::any_of(hits.begin(), hits.end(), [](const Hit* hit) { return hit->is_sheet; });
    };
    // Place i lies between pieces i and i + 1.
    std::size_t i = 0;
    if (in_sheet(pieces[0])) {
        // It starts in a sheet: it does not come from anywhere.
        while (i + 1 < pieces.size() && in_sheet(pieces[i])) ++i;
        if (i + 1 == pieces.size() && in_sheet(pieces[i])) return false;
    }
    for (; i + 1 < pieces.size(); ++i) {
        if (!place_in_sheet(pieces[i].far)) continue;
        std::size_t last = i;
        while (last + 1 < pieces.size() && in_sheet(pieces[last + 1])) ++last;
        if (last + 1 == pieces.size()) return false;  // it ends in the sheet
        if (run_separates(pieces, i, last)) return true;
        i = last;
    }
    return false;
}

bool Sight::run_separates(const std::vector<Piece>& pieces, std::size_t first,
                          std::size_t last) const {
    return !run_connects(pieces, first, last, true) && run_connects(pieces, first, last, false);
}

bool Sight::run_connects(const std::vector<Piece>& pieces, std::size_t first, std::size_t last,
                         bool with_sheets) const {
    LocalPicture local(delta_);
    // Sectors aside of the pieces before, between and behind the places of the run.
    const auto sectors = [&](std::size_t piece) {
        Piece p = pieces[piece];
        if (!with_sheets) {
            std::erase_if(p.fins, [](const Hit* hit) { return hit->is_sheet; });
        }
        return sectors_of(p);
    };
    std::vector<LocalPicture::Cell> incoming;
    std::vector<LocalPicture::Cell> outgoing;
    for (std::size_t place = first; place <= last; ++place) {
        const Rational& w = pieces[place].far;
        std::vector<LocalPicture::Triangle> triangles;
        for (const Hit* hit : hits_at(w, with_sheets)) {
            const auto& corners = image_.scene().triangles[hit->triangle].corners;
            LocalPicture::Triangle t{hit->n, hit->m, hit->is_sheet, {}};
            for (const std::uint32_t c : corners) {
                t.corners.emplace_back(image_.exact(c), image_.exact_weight(c));
            }
            triangles.push_back(std::move(t));
        }
        local.add_place(w, triangles);
        const auto before = local.cells_round(true, sectors(place));
        if (place == first) {
            incoming = before;
        } else {
            for (std::size_t i = 0; i < before.size(); ++i) local.join(outgoing[i], before[i]);
        }
        outgoing = local.cells_round(false, sectors(place + 1));
    }
    return local.connects(incoming, outgoing);
}

}  // namespace sightline::detail
