// SPDX-License-Identifier: GPL-3.0-or-later
// Scene2::make against the definition, transcribed: small random scenes on a grid, in integers.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

#include "scene/scene_helpers.hpp"
#include "sightline/scene/text_format.hpp"

namespace sightline {
namespace {

using Integer = std::int64_t;

struct Place {  // homogeneous, w > 0
    Integer x, y, w;
};
using GridRing = std::vector<std::array<Integer, 2>>;
struct GridPolygon {
    std::vector<GridRing> rings;  // outer, then holes
};

Integer side(const std::array<Integer, 2>& a, const std::array<Integer, 2>& b, const Place& p) {
    const Integer s = (b[0] - a[0]) * (p.y - a[1] * p.w) - (b[1] - a[1]) * (p.x - a[0] * p.w);
    return s > 0 ? 1 : s < 0 ? -1 : 0;
}
Integer side(const std::array<Integer, 2>& a, const std::array<Integer, 2>& b,
             const std::array<Integer, 2>& p) {
    return side(a, b, Place{p[0], p[1], 1});
}
bool between(const std::array<Integer, 2>& a, const std::array<Integer, 2>& b,
             const std::array<Integer, 2>& p) {
    return side(a, b, p) == 0 && std::min(a, b) <= p && p <= std::max(a, b);
}

struct GridEdge {
    std::array<Integer, 2> a, b;
    std::size_t polygon;
};

/// Corners and edges through one place: a chain is where it comes from and where it goes.
struct Chain {
    std::array<Integer, 2> from, to;
};

class Definition {
public:
    explicit Definition(const std::vector<GridPolygon>& polygons, bool world)
        : polygons_(polygons), world_(world) {
        for (std::size_t p = 0; p < polygons.size(); ++p) {
            for (std::size_t r = 0; r < polygons[p].rings.size(); ++r) {
                const GridRing& ring = polygons[p].rings[r];
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    edges_.push_back({ring[i], ring[(i + 1) % ring.size()], body_of(p, r)});
                }
            }
        }
    }

    bool is_valid() const { return !crosses() && !chains_cross() && regions_are_right(); }

private:
    // With a world, each ring of the first polygon bounds a solid of its own.
    std::size_t body_of(std::size_t polygon, std::size_t ring) const {
        return world_ && polygon == 0 ? 100 + ring : polygon;
    }

    bool crosses() const {
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            for (std::size_t j = i + 1; j < edges_.size(); ++j) {
                const GridEdge& e = edges_[i];
                const GridEdge& f = edges_[j];
                if (side(e.a, e.b, f.a) * side(e.a, e.b, f.b) < 0 &&
                    side(f.a, f.b, e.a) * side(f.a, f.b, e.b) < 0)
                    return true;
                if (e.polygon != f.polygon || side(e.a, e.b, f.a) != 0 || side(e.a, e.b, f.b) != 0)
                    continue;
                const auto low = std::max(std::min(e.a, e.b), std::min(f.a, f.b));
                if (low < std::min(std::max(e.a, e.b), std::max(f.a, f.b))) return true;
            }
        }
        return false;
    }

    bool chains_cross() const {
        std::map<std::pair<std::size_t, std::array<Integer, 2>>, std::vector<Chain>> at;
        for (std::size_t p = 0; p < polygons_.size(); ++p) {
            for (std::size_t r = 0; r < polygons_[p].rings.size(); ++r) {
                const GridRing& ring = polygons_[p].rings[r];
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    at[{body_of(p, r), ring[i]}].push_back(
                        {ring[(i + ring.size() - 1) % ring.size()], ring[(i + 1) % ring.size()]});
                }
            }
        }
        for (auto& [where, chains] : at) {
            for (const GridEdge& e : edges_) {
                if (e.polygon == where.first && e.a != where.second && e.b != where.second &&
                    between(e.a, e.b, where.second)) {
                    chains.push_back({e.a, e.b});
                }
            }
            for (const Chain& c : chains) {
                for (const Chain& d : chains) {
                    if (&c != &d &&
                        is_left(where.second, c, d.from) != is_left(where.second, c, d.to))
                        return true;
                }
            }
        }
        return false;
    }

    /// Whether the ray p→q leaves to the left of the chain from→p→to.
    static bool is_left(const std::array<Integer, 2>& p, const Chain& chain,
                        const std::array<Integer, 2>& q) {
        const bool of_in = side(chain.from, p, q) > 0;
        const bool of_out = side(p, chain.to, q) > 0;
        return side(chain.from, p, chain.to) > 0 ? of_in && of_out : of_in || of_out;
    }

    static int winding(const GridRing& ring, const Place& p) {
        int turns = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const auto& a = ring[i];
            const auto& b = ring[(i + 1) % ring.size()];
            const bool a_up = a[1] * p.w > p.y;
            const bool b_up = b[1] * p.w > p.y;
            if (!a_up && b_up && side(a, b, p) > 0) ++turns;
            if (a_up && !b_up && side(a, b, p) < 0) --turns;
        }
        return turns;
    }

    /// Each bounded region of the arrangement has a triangle of arrangement vertices inside of it.
    bool regions_are_right() const {
        const std::vector<Place> vertices = arrangement_vertices();
        std::map<const GridRing*, int> signs;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            for (std::size_t j = i + 1; j < vertices.size(); ++j) {
                for (std::size_t k = j + 1; k < vertices.size(); ++k) {
                    const Place &a = vertices[i], &b = vertices[j], &c = vertices[k];
                    const Place centre{a.x * b.w * c.w + b.x * a.w * c.w + c.x * a.w * b.w,
                                       a.y * b.w * c.w + b.y * a.w * c.w + c.y * a.w * b.w,
                                       3 * a.w * b.w * c.w};
                    if (!is_right_at(centre, signs)) return false;
                }
            }
        }
        return true;
    }

    std::vector<Place> arrangement_vertices() const {
        std::set<std::array<Integer, 3>> found;
        const auto add = [&found](Integer x, Integer y, Integer w) {
            const Integer g = std::gcd(std::gcd(x, y), w) * (w < 0 ? -1 : 1);
            found.insert({x / g, y / g, w / g});
        };
        for (const GridEdge& e : edges_) {
            add(e.a[0], e.a[1], 1);
            for (const GridEdge& f : edges_) {
                const Integer ex = e.b[0] - e.a[0], ey = e.b[1] - e.a[1];
                const Integer fx = f.b[0] - f.a[0], fy = f.b[1] - f.a[1];
                const Integer w = ex * fy - ey * fx;
                if (w == 0) continue;
                const Integer t = (f.a[0] - e.a[0]) * fy - (f.a[1] - e.a[1]) * fx;
                const Integer u = (f.a[0] - e.a[0]) * ey - (f.a[1] - e.a[1]) * ex;
                const bool inside = w > 0 ? t >= 0 && t <= w && u >= 0 && u <= w
                                          : t <= 0 && t >= w && u <= 0 && u >= w;
                if (inside) add(e.a[0] * w + ex * t, e.a[1] * w + ey * t, w);
            }
        }
        std::vector<Place> places;
        for (const auto& p : found) places.push_back({p[0], p[1], p[2]});
        return places;
    }

    static bool is_on(const GridEdge& e, const Place& p) {
        const auto within = [&p](Integer a, Integer b, Integer c) {
            return std::min(a, b) * p.w <= c && c <= std::max(a, b) * p.w;
        };
        return side(e.a, e.b, p) == 0 && within(e.a[0], e.b[0], p.x) && within(e.a[1], e.b[1], p.y);
    }

    bool is_right_at(const Place& p, std::map<const GridRing*, int>& signs) const {
        for (const GridEdge& e : edges_) {
            if (is_on(e, p)) return true;  // not in a region
        }
        int owners = 0;
        for (std::size_t i = 0; i < polygons_.size(); ++i) {
            int holes = 0;
            bool in_outer = false;
            for (std::size_t r = 0; r < polygons_[i].rings.size(); ++r) {
                const GridRing& ring = polygons_[i].rings[r];
                const int turns = winding(ring, p);
                if (turns == 0) continue;
                if (std::abs(turns) > 1) return false;
                if (signs.try_emplace(&ring, turns).first->second != turns) return false;
                (r == 0 ? in_outer : (++holes, in_outer)) = r == 0 ? true : in_outer;
            }
            if (holes > 1 || (holes == 1 && !in_outer)) return false;
            const bool is_world = world_ && i == 0;
            owners += is_world ? (in_outer ? holes : 1) : (in_outer && holes == 0 ? 1 : 0);
        }
        return owners <= 1;
    }

    const std::vector<GridPolygon>& polygons_;
    bool world_;
    std::vector<GridEdge> edges_;
};

GridRing random_ring(std::mt19937_64& random, Integer low, Integer high, std::size_t most) {
    GridRing ring(3 + random() % (most - 2));
    for (auto& p : ring) {
        for (Integer& c : p)
            c = low + static_cast<Integer>(random() % static_cast<std::uint64_t>(high - low + 1));
    }
    // Readers would drop a repeated closing vertex.
    return ring.front() == ring.back() ? random_ring(random, low, high, most) : ring;
}

SceneInput2 input_of(const std::vector<GridPolygon>& polygons, bool world) {
    SceneInput2 input;
    input.world = world;
    for (const GridPolygon& polygon : polygons) {
        Polygon2 p;
        for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
            Ring2& ring = r == 0 ? p.outer : p.holes.emplace_back();
            for (const auto& v : polygon.rings[r])
                ring.push_back({static_cast<double>(v[0]), static_cast<double>(v[1])});
        }
        input.elements.emplace_back(std::move(p));
    }
    return input;
}

struct Kind {
    const char* name;
    std::size_t polygons, holes, vertices;
    bool world;

    friend std::ostream& operator<<(std::ostream& out, const Kind& kind) {
        return out << kind.name;
    }
};

class Definitions : public ::testing::TestWithParam<Kind> {};

TEST_P(Definitions, MakeAcceptsExactlyTheValidScenes) {
    const Kind kind = GetParam();
    std::mt19937_64 random(7);
    int valid = 0;
    int invalid = 0;
    for (int round = 0; round < 20000; ++round) {
        std::vector<GridPolygon> polygons(kind.polygons);
        for (GridPolygon& polygon : polygons) {
            // Half of the outer rings are the border of the grid, so that holes have room.
            const bool roomy = kind.holes > 0 && random() % 4 != 0;
            polygon.rings.push_back(roomy ? GridRing{{0, 0}, {5, 0}, {5, 5}, {0, 5}}
                                          : random_ring(random, 0, 5, kind.vertices));
            for (std::size_t h = 0; h < kind.holes; ++h)
                polygon.rings.push_back(random_ring(random, 0, 5, 3));
            if (kind.world && polygons.size() > 1) break;
        }
        for (GridPolygon& polygon : polygons) {
            if (polygon.rings.empty()) polygon.rings.push_back(random_ring(random, 0, 5, 3));
        }
        const SceneInput2 input = input_of(polygons, kind.world);
        const auto scene = Scene2::make(input);
        const Errc code = scene ? Errc{} : scene.error().code;
        if (!scene && (code == Errc::too_few_vertices || code == Errc::repeated_vertex ||
                       code == Errc::spike))
            continue;
        const bool expected = Definition(polygons, kind.world).is_valid();
        std::ostringstream text;
        write_text(text, input);
        ASSERT_EQ(scene.has_value(), expected)
            << text.str() << (scene ? "" : scene.error().message);
        (expected ? valid : invalid) += 1;
        if (!scene) continue;
        ASSERT_EQ(scene_from_text(to_text(*scene)), scene) << text.str();
    }
    EXPECT_GT(valid, 40) << "the sample must contain both";
    EXPECT_GT(invalid, 40);
}

INSTANTIATE_TEST_SUITE_P(
    Scene2Differential, Definitions,
    ::testing::Values(Kind{"ring", 1, 0, 7, false}, Kind{"two_bodies", 2, 0, 4, false},
                      Kind{"three_bodies", 3, 0, 3, false}, Kind{"hole", 1, 1, 5, false},
                      Kind{"two_holes", 1, 2, 4, false}, Kind{"world", 1, 2, 4, true},
                      Kind{"world_and_body", 2, 1, 4, true}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace sightline
