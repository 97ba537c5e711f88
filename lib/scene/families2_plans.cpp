// SPDX-License-Identifier: GPL-3.0-or-later
// Cities, floor plans, caves.
#include <algorithm>
#include <array>

#include "scene/families2_detail.hpp"
#include "sightline/scene/families.hpp"

namespace sightline::families {

using namespace detail;

// ---- cities ------------------------------------------------------------------------------------------------

namespace {

struct Block {
    std::int64_t x0, y0, x1, y1;
};

/// A row of houses that share their side walls, of different depths, along the block's lower side.
void add_row(Rng& rng, const Block& b, SceneInput2& scene) {
    for (std::int64_t x = b.x0; x < b.x1;) {
        const std::int64_t next = b.x1 - x < 16 ? b.x1 : x + rng.between(6, 10);
        const std::int64_t depth = rng.between((b.y1 - b.y0) / 2, b.y1 - b.y0);
        scene.elements.emplace_back(to_polygon(box(x, b.y0, next, b.y0 + depth)));
        x = next;
    }
}

void add_block(Rng& rng, const Block& b, SceneInput2& scene) {
    const std::int64_t mx = b.x0 + rng.between(5, b.x1 - b.x0 - 5);
    const std::int64_t my = b.y0 + rng.between(5, b.y1 - b.y0 - 5);
    const auto add = [&](const IntRing& ring) { scene.elements.emplace_back(to_polygon(ring)); };
    switch (rng.below(7)) {
        case 0:  // one house
            return add(box(b.x0, b.y0, b.x1, b.y1));
        case 1:  // an L
            return add(
                {{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, my}, {mx, my}, {mx, b.y1}, {b.x0, b.y1}});
        case 2: {  // a courtyard
            Polygon2 house = to_polygon(box(b.x0, b.y0, b.x1, b.y1));
            house.holes.push_back(to_ring(box(b.x0 + 3, b.y0 + 3, b.x1 - 3, b.y1 - 3)));
            scene.elements.emplace_back(std::move(house));
            return;
        }
        case 3:  // four houses that meet in a point
            add(box(b.x0, b.y0, mx, my));
            add(box(mx, b.y0, b.x1, my));
            add(box(mx, my, b.x1, b.y1));
            return add(box(b.x0, my, mx, b.y1));
        case 4:  // two houses that touch in a corner
            add(box(b.x0, b.y0, mx, my));
            return add(box(mx, my, b.x1, b.y1));
        case 5:
            return add_row(rng, b, scene);
        default:  // a square with a lamp post
            scene.elements.emplace_back(to_point({mx, my}));
    }
}

/// Lower and upper coordinates of `count` blocks with streets between them.
std::vector<std::pair<std::int64_t, std::int64_t>> block_lines(Rng& rng, std::size_t count) {
    constexpr std::array<std::int64_t, 4> street_widths{4, 4, 6, 12};
    std::vector<std::pair<std::int64_t, std::int64_t>> lines;
    std::int64_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t end = at + rng.between(20, 48);
        lines.emplace_back(at, end);
        at = end + street_widths[rng.below(street_widths.size())];
    }
    return lines;
}

}  // namespace

SceneInput2 city(const City& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.columns >= 1 && parameters.columns <= 500);
    SIGHTLINE_EXPECT(parameters.rows >= 1 && parameters.rows <= 500);
    Rng rng(seed);
    const auto columns = block_lines(rng, parameters.columns);
    const auto rows = block_lines(rng, parameters.rows);
    SceneInput2 scene;
    for (const auto& [y0, y1] : rows) {
        for (const auto& [x0, x1] : columns) add_block(rng, {x0, y0, x1, y1}, scene);
    }
    return scene;
}

// ---- rasters traced ------------------------------------------------------------------------------------------

namespace {

/// Free and solid unit cells; all beyond the raster is solid.
class Raster {
public:
    Raster(std::int64_t width, std::int64_t height, bool free)
        : width_(width), height_(height), free_(static_cast<std::size_t>(width * height), free) {}

    [[nodiscard]] std::int64_t width() const { return width_; }
    [[nodiscard]] std::int64_t height() const { return height_; }
    [[nodiscard]] bool is_free(IntPoint cell) const {
        return cell.x >= 0 && cell.y >= 0 && cell.x < width_ && cell.y < height_ &&
               free_[index(cell)];
    }
    void set(IntPoint cell, bool free) { free_[index(cell)] = free; }
    [[nodiscard]] std::size_t index(IntPoint cell) const {
        return static_cast<std::size_t>(cell.y * width_ + cell.x);
    }

private:
    std::int64_t width_;
    std::int64_t height_;
    std::vector<bool> free_;
};

constexpr std::array<IntPoint, 4> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// The free cells that are joined to `start` by sides.
std::vector<IntPoint> component_of(const Raster& raster, IntPoint start, std::vector<bool>& seen) {
    std::vector<IntPoint> cells{start};
    seen[raster.index(start)] = true;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (const IntPoint step : steps) {
            const IntPoint next = cells[i] + step;
            if (!raster.is_free(next) || seen[raster.index(next)]) continue;
            seen[raster.index(next)] = true;
            cells.push_back(next);
        }
    }
    return cells;
}

/// Makes all free cells solid but those of the largest component (the first of several).
std::size_t keep_largest_component(Raster& raster) {
    std::vector<bool> seen(static_cast<std::size_t>(raster.width() * raster.height()), false);
    std::vector<IntPoint> largest;
    for (std::int64_t y = 0; y < raster.height(); ++y) {
        for (std::int64_t x = 0; x < raster.width(); ++x) {
            if (!raster.is_free({x, y}) || seen[raster.index({x, y})]) continue;
            std::vector<IntPoint> cells = component_of(raster, {x, y}, seen);
            if (cells.size() > largest.size()) largest.swap(cells);
        }
    }
    const std::size_t size = largest.size();
    raster = Raster(raster.width(), raster.height(), false);
    for (const IntPoint cell : largest) raster.set(cell, true);
    return size;
}

/// The cell on the left of the unit edge that leaves lattice point p in direction k (an index into `steps`).
IntPoint left_cell(IntPoint p, unsigned k) {
    constexpr std::array<IntPoint, 4> offset{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
    return p + offset[k];
}
bool is_boundary(const Raster& raster, IntPoint p, unsigned k) {
    return raster.is_free(left_cell(p, k)) && !raster.is_free(left_cell(p, (k + 3) % 4));
}

/// Walks round a boundary with the free cells on the left; at a point where two free cells touch it stays
/// with its own. Marks the edges to the right (k = 0) that it passes. Corners only.
IntRing trace(const Raster& raster, IntPoint start, std::vector<bool>& passed) {
    IntRing ring;
    IntPoint at = start;
    unsigned k = 0;
    do {
        if (k == 0) passed[raster.index(at)] = true;
        at = at + steps[k];
        unsigned next = (k + 1) % 4;
        while (!is_boundary(raster, at, next)) next = (next + 3) % 4;
        if (next != k) ring.push_back(at);
        k = next;
    } while (at != start || k != 0);
    return ring;
}

/// The free cells, which hang together, as a world with holes; lattice line i of the raster lies at xs[i] and
/// ys[i].
SceneInput2 world_of(const Raster& raster, const std::vector<std::int64_t>& xs,
                     const std::vector<std::int64_t>& ys) {
    std::vector<bool> passed(static_cast<std::size_t>(raster.width() * raster.height()), false);
    Polygon2 world;
    for (std::int64_t y = 0; y < raster.height(); ++y) {
        for (std::int64_t x = 0; x < raster.width(); ++x) {
            if (passed[raster.index({x, y})] || !is_boundary(raster, {x, y}, 0)) continue;
            IntRing ring = trace(raster, {x, y}, passed);
            for (IntPoint& p : ring) {
                p = {xs[static_cast<std::size_t>(p.x)], ys[static_cast<std::size_t>(p.y)]};
            }
            // The first boundary met from below is the outer one.
            if (world.outer.empty()) {
                world.outer = to_ring(ring);
            } else {
                world.holes.push_back(to_ring(ring));
            }
        }
    }
    SceneInput2 scene;
    scene.elements.emplace_back(std::move(world));
    scene.world = true;
    return scene;
}

std::vector<std::int64_t> unit_lines(std::int64_t cells) {
    std::vector<std::int64_t> lines;
    for (std::int64_t i = 0; i <= cells; ++i) lines.push_back(i);
    return lines;
}

/// Solid where at least 5 of the 9 cells around are.
Raster smoothed(const Raster& raster) {
    Raster result = raster;
    for (std::int64_t y = 0; y < raster.height(); ++y) {
        for (std::int64_t x = 0; x < raster.width(); ++x) {
            int free = 0;
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                for (std::int64_t dx = -1; dx <= 1; ++dx)
                    free += raster.is_free({x + dx, y + dy}) ? 1 : 0;
            }
            result.set({x, y}, free >= 5);
        }
    }
    return result;
}

}  // namespace

SceneInput2 cave(const Cave& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.columns >= 8 && parameters.columns <= 4000);
    SIGHTLINE_EXPECT(parameters.rows >= 8 && parameters.rows <= 4000);
    Rng rng(seed);
    const auto width = static_cast<std::int64_t>(parameters.columns);
    const auto height = static_cast<std::int64_t>(parameters.rows);
    Raster raster(width, height, false);
    do {
        for (std::int64_t y = 0; y < height; ++y) {
            for (std::int64_t x = 0; x < width; ++x) raster.set({x, y}, rng.below(100) < 60);
        }
        raster = smoothed(smoothed(raster));
        for (int i = 0; i < 8; ++i) {  // pillars, so that rings touch in points
            const IntPoint cell{rng.between(0, width - 1), rng.between(0, height - 1)};
            raster.set(cell, false);
        }
    } while (keep_largest_component(raster) < 4);
    return world_of(raster, unit_lines(width), unit_lines(height));
}

// ---- floor plans -----------------------------------------------------------------------------------------------

namespace {

/// A wall on lattice line `line`, across unit cells from … to − 1, with doors in some of these cells.
struct Partition {
    bool vertical = false;
    std::int64_t line = 0;
    std::int64_t from = 0;
    std::int64_t to = 0;
    std::vector<std::int64_t> doors;  ///< ascending
};

/// Divides the cells of a block into rooms, recursively; a wall with a door or two at each division.
void divide(Rng& rng, const Block& b, std::vector<Partition>& walls) {
    const std::int64_t width = b.x1 - b.x0;
    const std::int64_t height = b.y1 - b.y0;
    if (std::max(width, height) < 2 || (width * height <= 12 && !rng.one_in(3))) return;
    const bool vertical = width == height ? rng.one_in(2) : width > height;
    Partition wall{.vertical = vertical, .line = 0, .from = 0, .to = 0, .doors = {}};
    wall.line = vertical ? rng.between(b.x0 + 1, b.x1 - 1) : rng.between(b.y0 + 1, b.y1 - 1);
    wall.from = vertical ? b.y0 : b.x0;
    wall.to = vertical ? b.y1 : b.x1;
    wall.doors.push_back(rng.between(wall.from, wall.to - 1));
    if (wall.to - wall.from >= 4 && rng.one_in(2))
        wall.doors.push_back(rng.between(wall.from, wall.to - 1));
    std::sort(wall.doors.begin(), wall.doors.end());
    wall.doors.erase(std::unique(wall.doors.begin(), wall.doors.end()), wall.doors.end());
    const std::int64_t line = wall.line;
    walls.push_back(std::move(wall));
    divide(rng, vertical ? Block{b.x0, b.y0, line, b.y1} : Block{b.x0, b.y0, b.x1, line}, walls);
    divide(rng, vertical ? Block{line, b.y0, b.x1, b.y1} : Block{b.x0, line, b.x1, b.y1}, walls);
}

/// Lattice lines of a raster in which even cells are walls, 1 wide, and odd ones unit cells, 7 wide.
std::vector<std::int64_t> wall_and_room_lines(std::int64_t cells) {
    std::vector<std::int64_t> lines{0};
    for (std::int64_t i = 0; i <= 2 * cells; ++i)
        lines.push_back(lines.back() + (i % 2 == 0 ? 1 : 7));
    return lines;
}

SceneInput2 thick_plan(std::int64_t width, std::int64_t height,
                       const std::vector<Partition>& walls) {
    Raster raster(2 * width + 1, 2 * height + 1, false);
    for (std::int64_t y = 1; y < 2 * height; ++y) {
        for (std::int64_t x = 1; x < 2 * width; ++x) raster.set({x, y}, true);
    }
    for (const Partition& wall : walls) {
        const auto cell = [&](std::int64_t along) {
            return wall.vertical ? IntPoint{2 * wall.line, along} : IntPoint{along, 2 * wall.line};
        };
        for (std::int64_t i = 2 * wall.from; i <= 2 * wall.to; ++i) raster.set(cell(i), false);
        for (const std::int64_t door : wall.doors) raster.set(cell(2 * door + 1), true);
    }
    return world_of(raster, wall_and_room_lines(width), wall_and_room_lines(height));
}

SceneInput2 thin_plan(std::int64_t width, std::int64_t height,
                      const std::vector<Partition>& walls) {
    SceneInput2 scene;
    scene.world = true;
    scene.elements.emplace_back(to_polygon(box(0, 0, 8 * width, 8 * height)));
    for (const Partition& wall : walls) {
        const auto add = [&](std::int64_t from, std::int64_t to) {
            const auto at = [&](std::int64_t along) {
                return wall.vertical ? IntPoint{8 * wall.line, along}
                                     : IntPoint{along, 8 * wall.line};
            };
            scene.elements.emplace_back(to_wall(at(from), at(to)));
        };
        std::int64_t from = 8 * wall.from;
        for (const std::int64_t door : wall.doors) {
            add(from, 8 * door + 3);
            from = 8 * door + 6;
        }
        add(from, 8 * wall.to);
    }
    return scene;
}

}  // namespace

SceneInput2 floor_plan(const FloorPlan& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.columns >= 1 && parameters.columns <= 2000);
    SIGHTLINE_EXPECT(parameters.rows >= 1 && parameters.rows <= 2000);
    Rng rng(seed);
    const auto width = static_cast<std::int64_t>(parameters.columns);
    const auto height = static_cast<std::int64_t>(parameters.rows);
    std::vector<Partition> walls;
    divide(rng, {0, 0, width, height}, walls);
    return parameters.thick ? thick_plan(width, height, walls) : thin_plan(width, height, walls);
}

}  // namespace sightline::families
