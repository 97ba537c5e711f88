// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/repair2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "scene/boolean.hpp"
#include "scene/box_tree.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline {
namespace {

bool is_spike(const Point2& before, const Point2& at, const Point2& after) {
    return (before < at) == (after < at) && orientation(before, at, after) == Sign::zero;
}

/// Removes repeated vertices and spikes; what is left may be too short to be a ring.
Ring2 cleaned(const Ring2& ring, std::size_t& repeats, std::size_t& spikes) {
    Ring2 kept;
    const auto push = [&](const Point2& p) {
        for (;;) {
            if (!kept.empty() && kept.back() == p) {
                ++repeats;
                return;
            }
            if (kept.size() < 2 || !is_spike(kept[kept.size() - 2], kept.back(), p)) break;
            kept.pop_back();
            ++spikes;
        }
        kept.push_back(p);
    };
    for (const Point2& p : ring) push(p);
    // Where the ring closes: drop from the end until both seams are sound.
    std::size_t first = 0;
    while (kept.size() - first > 2) {
        const Point2& last = kept.back();
        if (last == kept[first]) {
            ++repeats;
            kept.pop_back();
        } else if (is_spike(kept[kept.size() - 2], last, kept[first])) {
            ++spikes;
            kept.pop_back();
        } else if (is_spike(last, kept[first], kept[first + 1])) {
            ++spikes;
            ++first;
        } else {
            break;
        }
    }
    kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first));
    if (kept.size() < 3) kept.clear();
    return kept;
}

bool is_finite(const Point2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// One solid of the input: a polygon, or a hole of the world.
struct Body {
    Polygon2 polygon;
    std::size_t element = 0;
    bool is_world_hole = false;
    bool replaced = false;
};

class Repairer {
public:
    explicit Repairer(const SceneInput2& input) : input_(input) {}

    Result<RepairedScene2> run() {
        clean();
        // Rounding can make neighbours of a union overlap a little: then once more.
        constexpr int most_rounds = 4;
        Result<Scene2> scene = Scene2::make(input_);
        for (int round = 0; !scene && round < most_rounds; ++round) {
            const Errc code = scene.error().code;
            if (code != Errc::body_overlap && code != Errc::wrong_nesting &&
                code != Errc::outside_world)
                break;
            if (!rebuild_bodies()) break;
            scene = Scene2::make(input_);
        }
        if (!scene) return tl::unexpected(scene.error());
        return RepairedScene2{std::move(*scene), std::move(input_), std::move(changes_)};
    }

private:
    void clean() {
        std::vector<SceneElement2> kept;
        std::vector<std::uint32_t> lines;
        for (std::size_t i = 0; i < input_.elements.size(); ++i) {
            if (!clean_element(i)) continue;
            kept.push_back(std::move(input_.elements[i]));
            if (i < input_.lines.size()) lines.push_back(input_.lines[i]);
        }
        input_.elements = std::move(kept);
        input_.lines = std::move(lines);
    }

    /// False when nothing of the element is left.
    bool clean_element(std::size_t i) {
        if (auto* polygon = std::get_if<Polygon2>(&input_.elements[i]))
            return clean_polygon(*polygon, i);
        auto* wall = std::get_if<Polyline2>(&input_.elements[i]);
        if (wall == nullptr) return true;
        const std::size_t before = wall->points.size();
        const auto last = std::unique(wall->points.begin(), wall->points.end());
        wall->points.erase(last, wall->points.end());
        const std::size_t removed = before - wall->points.size();
        if (removed > 0)
            say(fmt::format("element {} (wall): removed {} segments of length zero", i, removed));
        if (wall->points.size() >= 2 || removed == 0) return true;
        say(fmt::format("element {} (wall): removed, nothing of it was left", i));
        return false;
    }

    bool clean_polygon(Polygon2& polygon, std::size_t i) {
        if (!clean_ring(polygon.outer, fmt::format("element {} (polygon), outer ring", i))) {
            say(fmt::format("element {} (polygon): removed, its outer ring has no area", i));
            return false;
        }
        std::vector<Ring2> holes;
        for (std::size_t h = 0; h < polygon.holes.size(); ++h) {
            const std::string name = fmt::format("element {} (polygon), hole {}", i, h);
            if (clean_ring(polygon.holes[h], name)) {
                holes.push_back(std::move(polygon.holes[h]));
            } else {
                say(name + ": removed, it has no area");
            }
        }
        polygon.holes = std::move(holes);
        return true;
    }

    bool clean_ring(Ring2& ring, const std::string& name) {
        // Orientation is meaningless for such numbers, and validation reports them.
        if (!std::all_of(ring.begin(), ring.end(), is_finite)) return true;
        if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
        std::size_t repeats = 0;
        std::size_t spikes = 0;
        ring = cleaned(ring, repeats, spikes);
        if (repeats > 0) say(fmt::format("{}: removed {} repeated vertices", name, repeats));
        if (spikes > 0) say(fmt::format("{}: removed {} vertices of spikes", name, spikes));
        return !ring.empty();
    }

    void say(std::string sentence) { changes_.push_back(std::move(sentence) + "."); }

    /// Merges what overlaps and clips what leaves the world; false when nothing could be done.
    bool rebuild_bodies() {
        std::vector<Body> bodies = collect_bodies();
        for (const Body& body : bodies) {
            if (!is_valid_alone(body.polygon)) return false;
        }
        const std::size_t before = changes_.size();
        std::map<std::size_t, std::vector<Polygon2>> added;  // by element
        merge_overlapping(bodies, added);
        if (input_.world) clip_to_world(bodies, added);
        if (changes_.size() == before) return false;
        replace(bodies, added);
        return true;
    }

    std::vector<Body> collect_bodies() {
        std::vector<Body> bodies;
        bool world_pending = input_.world;
        for (std::size_t i = 0; i < input_.elements.size(); ++i) {
            const auto* polygon = std::get_if<Polygon2>(&input_.elements[i]);
            if (polygon == nullptr) continue;
            if (!world_pending) {
                bodies.push_back({*polygon, i, false, false});
                continue;
            }
            world_pending = false;
            world_ = polygon->outer;
            for (const Ring2& hole : polygon->holes)
                bodies.push_back({Polygon2{hole, {}}, i, true, false});
        }
        return bodies;
    }

    static bool is_valid_alone(const Polygon2& polygon) {
        SceneInput2 alone;
        alone.elements.emplace_back(polygon);
        return Scene2::make(alone).has_value();
    }

    static bool overlap(const Polygon2& a, const Polygon2& b) {
        SceneInput2 pair;
        pair.elements.emplace_back(a);
        pair.elements.emplace_back(b);
        return !Scene2::make(pair).has_value();
    }

    static detail::Box2 box_of(const Polygon2& polygon) {
        detail::Box2 box = detail::Box2::of(polygon.outer[0], polygon.outer[0]);
        for (const Point2& p : polygon.outer) box.include(detail::Box2::of(p, p));
        return box;
    }

    /// Representative of each body's cluster of overlapping ones.
    static std::vector<std::size_t> clusters(const std::vector<Body>& bodies) {
        std::vector<std::size_t> leader(bodies.size());
        std::iota(leader.begin(), leader.end(), std::size_t{0});
        const auto find = [&leader](std::size_t i) {
            while (leader[i] != i) i = leader[i] = leader[leader[i]];
            return i;
        };
        std::vector<detail::Box2> boxes;
        boxes.reserve(bodies.size());
        for (const Body& body : bodies) boxes.push_back(box_of(body.polygon));
        const detail::BoxTree tree(boxes);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            tree.query(
                boxes[i], [](const detail::Box2&) { return true; },
                [&](std::uint32_t j) {
                    if (j <= i || find(i) == find(j) ||
                        !overlap(bodies[i].polygon, bodies[j].polygon))
                        return;
                    const std::size_t a = find(i);
                    const std::size_t b = find(j);
                    leader[std::max(a, b)] = std::min(a, b);
                });
        }
        for (std::size_t i = 0; i < bodies.size(); ++i) leader[i] = find(i);
        return leader;
    }

    void merge_overlapping(std::vector<Body>& bodies,
                           std::map<std::size_t, std::vector<Polygon2>>& added) {
        const std::vector<std::size_t> leader = clusters(bodies);
        std::map<std::size_t, std::vector<std::size_t>> members;
        for (std::size_t i = 0; i < bodies.size(); ++i) members[leader[i]].push_back(i);
        for (const auto& [first, all] : members) {
            if (all.size() < 2) continue;
            std::vector<Polygon2> polygons;
            std::string names;
            for (const std::size_t i : all) {
                polygons.push_back(std::move(bodies[i].polygon));
                bodies[i].replaced = true;
                names += fmt::format("{}{}", names.empty() ? "" : ", ", i);
            }
            add(detail::unite(polygons), "merged overlapping bodies " + names,
                added[bodies[first].element]);
        }
    }

    void clip_to_world(std::vector<Body>& bodies,
                       std::map<std::size_t, std::vector<Polygon2>>& added) {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            Body& body = bodies[i];
            if (body.replaced || lies_in_world(body.polygon)) continue;
            body.replaced = true;
            add(detail::clip(body.polygon, world_), fmt::format("clipped body {} to the world", i),
                added[body.element]);
        }
    }

    [[nodiscard]] bool lies_in_world(const Polygon2& polygon) const {
        SceneInput2 pair;
        pair.world = true;
        pair.elements.emplace_back(Polygon2{world_, {}});
        pair.elements.emplace_back(polygon);
        return Scene2::make(pair).has_value();
    }

    void add(detail::BooleanResult result, const std::string& what, std::vector<Polygon2>& to) {
        std::string sentence = fmt::format("{} into {} polygons", what, result.polygons.size());
        if (result.rounded_vertices > 0) {
            sentence += fmt::format(", rounding {} new vertices to the nearest doubles",
                                    result.rounded_vertices);
        }
        say(std::move(sentence));
        for (Polygon2& polygon : result.polygons) to.push_back(std::move(polygon));
    }

    /// New polygons take the place of the first element that they come from.
    void replace(const std::vector<Body>& bodies,
                 std::map<std::size_t, std::vector<Polygon2>>& added) {
        std::vector<bool> gone(input_.elements.size(), false);
        std::map<std::size_t, std::vector<Ring2>> world_holes;
        for (const Body& body : bodies) {
            if (body.is_world_hole) {
                std::vector<Ring2>& holes = world_holes[body.element];
                if (!body.replaced) holes.push_back(body.polygon.outer);
            } else if (body.replaced) {
                gone[body.element] = true;
            }
        }
        SceneInput2 next;
        next.world = input_.world;
        next.file = input_.file;
        const auto emit = [&](SceneElement2 element, std::size_t from) {
            next.elements.push_back(std::move(element));
            if (from < input_.lines.size()) next.lines.push_back(input_.lines[from]);
        };
        for (std::size_t i = 0; i < input_.elements.size(); ++i) {
            if (const auto holes = world_holes.find(i); holes != world_holes.end()) {
                std::get<Polygon2>(input_.elements[i]).holes = std::move(holes->second);
            }
            if (!gone[i]) emit(std::move(input_.elements[i]), i);
            for (Polygon2& polygon : added[i]) {
                // Rounding can leave repeats and spikes in what the union gave.
                if (clean_polygon(polygon, i)) emit(std::move(polygon), i);
            }
        }
        input_ = std::move(next);
    }

    SceneInput2 input_;
    Ring2 world_;
    std::vector<std::string> changes_;
};

}  // namespace

Result<RepairedScene2> repair(const SceneInput2& input) { return Repairer(input).run(); }

}  // namespace sightline
