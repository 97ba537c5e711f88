// SPDX-License-Identifier: GPL-3.0-or-later
// Lattices of boxes, touching chains, pinched rings: everything collinear, coincident or sealed.
#include <algorithm>

#include "scene/families2_detail.hpp"
#include "sightline/scene/families.hpp"

namespace sightline::families {

using namespace detail;

namespace {

void expect_lattice(std::size_t columns, std::size_t rows) {
    SIGHTLINE_EXPECT(columns >= 1 && columns <= 1000);
    SIGHTLINE_EXPECT(rows >= 1 && rows <= 1000);
}

/// Boxes of side 2, two apart, row by row.
std::vector<IntRing> lattice_of_boxes(std::size_t columns, std::size_t rows) {
    expect_lattice(columns, rows);
    std::vector<IntRing> boxes;
    for (std::int64_t y = 0; y < static_cast<std::int64_t>(rows); ++y) {
        for (std::int64_t x = 0; x < static_cast<std::int64_t>(columns); ++x) {
            boxes.push_back(box(4 * x, 4 * y, 4 * x + 2, 4 * y + 2));
        }
    }
    return boxes;
}

SceneInput2 bodies(const std::vector<IntRing>& rings) {
    SceneInput2 scene;
    for (const IntRing& ring : rings) scene.elements.emplace_back(to_polygon(ring));
    return scene;
}

}  // namespace

SceneInput2 grid(const Grid& parameters, std::uint64_t) {
    return bodies(lattice_of_boxes(parameters.columns, parameters.rows));
}

SceneInput2 rotated_grid(const RotatedGrid& parameters, std::uint64_t) {
    const std::int64_t a = parameters.a;
    const std::int64_t b = parameters.b;
    SIGHTLINE_EXPECT(std::abs(a) <= 10'000 && std::abs(b) <= 10'000 && (a != 0 || b != 0));
    std::vector<IntRing> boxes = lattice_of_boxes(parameters.columns, parameters.rows);
    for (IntRing& ring : boxes) {
        for (IntPoint& p : ring) p = {a * p.x - b * p.y, b * p.x + a * p.y};
    }
    return bodies(boxes);
}

SceneInput2 grid_with_walls(const Grid& parameters, std::uint64_t seed) {
    Rng rng(seed);
    SceneInput2 scene = bodies(lattice_of_boxes(parameters.columns, parameters.rows));
    const auto wall = [&](IntPoint from, IntPoint step) {
        scene.elements.emplace_back(to_wall(from, from + step));
    };
    std::size_t crossings = 0;
    for (std::int64_t j = 0; j < static_cast<std::int64_t>(parameters.rows); ++j) {
        for (std::int64_t i = 0; i < static_cast<std::int64_t>(parameters.columns); ++i) {
            const IntPoint corner{4 * i + 2, 4 * j + 2};  // upper right of the box
            switch (rng.below(5)) {
                case 0:
                    wall(corner, {-2, 0});
                    break;  // along a whole side
                case 1:
                    wall(corner + IntPoint{-1, 0}, {3, 0});
                    break;  // along half a side and across
                case 2:
                    wall(corner + IntPoint{0, -1}, {2, 0});
                    break;  // from side to side
                case 3:
                    wall(corner, {0, 1});
                    break;  // out of the corner
                default:
                    break;
            }
            if (!rng.one_in(2)) continue;
            wall(corner, {2, 2});
            wall(corner + IntPoint{2, 0}, {-2, 2});
            if (++crossings % 3 == 0)
                scene.elements.emplace_back(to_point(corner + IntPoint{1, 1}));
        }
    }
    return scene;
}

SceneInput2 checkerboard(const Grid& parameters, std::uint64_t) {
    expect_lattice(parameters.columns, parameters.rows);
    std::vector<IntRing> squares;
    for (std::int64_t y = 0; y < static_cast<std::int64_t>(parameters.rows); ++y) {
        for (std::int64_t x = y % 2; x < static_cast<std::int64_t>(parameters.columns); x += 2) {
            squares.push_back(box(x, y, x + 1, y + 1));
        }
    }
    return bodies(squares);
}

SceneInput2 pinwheel_tiles(const Grid& parameters, std::uint64_t) {
    expect_lattice(parameters.columns, parameters.rows);
    std::vector<IntRing> boxes;
    for (std::int64_t j = 0; j < static_cast<std::int64_t>(parameters.rows); ++j) {
        for (std::int64_t i = 0; i < static_cast<std::int64_t>(parameters.columns); ++i) {
            const std::int64_t x = 4 * i;
            const std::int64_t y = 4 * j;
            boxes.push_back(box(x, y, x + 2, y + 1));
            boxes.push_back(box(x + 2, y, x + 3, y + 2));
            boxes.push_back(box(x + 1, y + 2, x + 3, y + 3));
            boxes.push_back(box(x, y + 1, x + 1, y + 3));
        }
    }
    return bodies(boxes);
}

namespace {

/// A box or diamond that touches, on the right, the point or side where the chain ends; the chain grows
/// to the right only, so nothing else meets.
struct ChainEnd {
    std::int64_t x = 0;
    std::int64_t low = 0;
    std::int64_t high = 0;  ///< equal to low: the chain ends in a point
};

IntRing next_link(Rng& rng, ChainKind kind, ChainEnd& end) {
    constexpr std::int64_t size = 8;
    const std::uint64_t choice = kind == ChainKind::corners ? 0
                                 : kind == ChainKind::edges ? 1
                                                            : rng.below(4);
    const std::int64_t inside =
        end.high > end.low ? rng.between(end.low + 1, end.high - 1) : end.low;
    if (choice == 3) {  // a diamond: its left tip touches the inside of the side (or the tip)
        const IntRing diamond{{end.x, inside},
                              {end.x + size, inside - size},
                              {end.x + 2 * size, inside},
                              {end.x + size, inside + size}};
        end = {end.x + 2 * size, inside, inside};
        return diamond;
    }
    std::int64_t low = end.low;                                        // the whole side
    if (choice == 0) low = rng.one_in(2) ? end.high : end.low - size;  // a corner
    if (choice == 1) low = rng.one_in(2) ? inside : inside - size;     // a piece
    const IntRing link = box(end.x, low, end.x + size, low + size);
    end = {end.x + size, low, low + size};
    return link;
}

std::vector<IntRing> ring_of_boxes(std::size_t boxes) {
    const auto side = std::max<std::int64_t>(2, static_cast<std::int64_t>((boxes + 3) / 4));
    std::vector<IntRing> rings;
    for (std::int64_t i = 0; i < side; ++i) {
        rings.push_back(box(i, 0, i + 1, 1));
        rings.push_back(box(side, i, side + 1, i + 1));
        rings.push_back(box(side - i, side, side - i + 1, side + 1));
        rings.push_back(box(0, side - i, 1, side - i + 1));
    }
    return rings;
}

}  // namespace

SceneInput2 touching_chain(const Chain& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.boxes >= 1 && parameters.boxes <= 1'000'000);
    if (parameters.kind == ChainKind::ring) return bodies(ring_of_boxes(parameters.boxes));
    Rng rng(seed);
    ChainEnd end{8, 0, 8};
    std::vector<IntRing> links{box(0, 0, 8, 8)};
    while (links.size() < parameters.boxes) links.push_back(next_link(rng, parameters.kind, end));
    return bodies(links);
}

SceneInput2 pinched(const Pinched& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.lobes >= 1 && parameters.lobes <= 1'000'000);
    Rng rng(seed);
    const auto lobes = static_cast<std::int64_t>(parameters.lobes);
    Polygon2 polygon;
    for (std::int64_t i = 0; i < lobes; ++i) {  // below, to the right: each joint once
        polygon.outer.push_back(to_point({8 * i, 0}));
        polygon.outer.push_back(to_point({8 * i + 4, -4}));
    }
    for (std::int64_t i = lobes; i > 0; --i) {  // above, back: each joint again
        polygon.outer.push_back(to_point({8 * i, 0}));
        polygon.outer.push_back(to_point({8 * i - 4, 4}));
    }
    for (std::int64_t i = 0; i < lobes; ++i) {
        const std::int64_t x = 8 * i + 4;
        const IntPoint touch =
            rng.one_in(2) ? IntPoint{x, -4} : IntPoint{x - 1, -3};  // a corner or an edge
        polygon.holes.push_back(to_ring({touch, {x + 1, 1}, {x - 1, 1}}));
    }
    SceneInput2 scene;
    scene.elements.emplace_back(std::move(polygon));
    scene.world = parameters.world;
    return scene;
}

}  // namespace sightline::families
