// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms, buildings and cities.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "scene/families3_detail.hpp"
#include "sightline/scene/families3.hpp"

namespace sightline::families {

using namespace detail;

namespace {

struct Box {
    Int3 low;
    Int3 high;
};
/// A piece of furniture that stands on z = 0 round the z axis. Lengths are quarters of a centimetre.
using Piece = std::vector<Box>;

constexpr std::int64_t cm = 4;
/// A piece turned in its cell stays within it: no piece is longer than 150 cm across.
constexpr std::int64_t cell_side = 160 * cm;
/// Coordinates are about 2^10 to the unit, so that turns of all lengths keep nearly the same scale.
constexpr std::int64_t unit = 1 << 10;

Box box_of(std::int64_t x0, std::int64_t y0, std::int64_t z0, std::int64_t x1, std::int64_t y1,
           std::int64_t z1) {
    return {{cm * x0, cm * y0, cm * z0}, {cm * x1, cm * y1, cm * z1}};
}

/// Four legs under the box of these half sides.
void add_legs(Piece& piece, std::int64_t x, std::int64_t y, std::int64_t height) {
    for (int i = 0; i < 4; ++i) {
        const std::int64_t left = (i & 1) == 0 ? -x : x - 5;
        const std::int64_t front = (i & 2) == 0 ? -y : y - 5;
        piece.push_back(box_of(left, front, 0, left + 5, front + 5, height));
    }
}

Piece table(Rng& rng) {
    const std::int64_t x = rng.between(40, 60);
    const std::int64_t y = rng.between(30, 40);
    Piece piece{box_of(-x, -y, 72, x, y, 75)};
    add_legs(piece, x, y, 72);
    return piece;
}

Piece chair(Rng& rng) {
    const std::int64_t side = rng.between(20, 24);
    Piece piece{box_of(-side, -side, 42, side, side, 46),
                box_of(-side, side - 4, 46, side, side, rng.between(80, 100))};
    add_legs(piece, side, side, 42);
    return piece;
}

/// Sides, back, bottom, top and two boards; open in front.
Piece cupboard(Rng& rng) {
    const std::int64_t x = rng.between(40, 55);
    const std::int64_t top = rng.between(150, 190);
    return {box_of(-x, -20, 0, -x + 2, 20, top),
            box_of(x - 2, -20, 0, x, 20, top),
            box_of(-x + 2, 18, 0, x - 2, 20, top),
            box_of(-x + 2, -20, 0, x - 2, 18, 2),
            box_of(-x + 2, -20, top - 2, x - 2, 18, top),
            box_of(-x + 2, -20, top / 3, x - 2, 18, top / 3 + 2),
            box_of(-x + 2, -20, top * 2 / 3, x - 2, 18, top * 2 / 3 + 2)};
}

/// Two sides, five boards and on four of these `books`, which lean on each other.
Piece shelf(Rng& rng, std::size_t books) {
    Piece piece{box_of(-45, -15, 0, -43, 15, 146), box_of(43, -15, 0, 45, 15, 146)};
    for (std::int64_t level = 0; level < 5; ++level)
        piece.push_back(box_of(-43, -15, 36 * level, 43, 15, 36 * level + 2));
    for (std::size_t i = 0; i < books; ++i) {
        const auto level = static_cast<std::int64_t>(i % 4);
        const auto before = static_cast<std::int64_t>(i / 4);
        const std::int64_t front = rng.between(-14, -2);
        piece.push_back(box_of(-43 + 5 * before, front, 36 * level + 2, -38 + 5 * before, 15,
                               36 * level + rng.between(18, 34)));
    }
    return piece;
}

Piece lamp(Rng& rng) {
    const std::int64_t height = rng.between(100, 160);
    return {box_of(-15, -15, 0, 15, 15, 3), box_of(-2, -2, 3, 2, 2, height),
            box_of(-18, -18, height, 18, 18, height + 25)};
}

Piece crate(Rng& rng) {
    const std::int64_t x = rng.between(10, 50);
    const std::int64_t y = rng.between(10, 50);
    return {box_of(-x, -y, 0, x, y, rng.between(10, 80))};
}

/// Pieces with this many boxes in all.
std::vector<Piece> furniture(Rng& rng, std::size_t boxes) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; boxes > 0; ++i) {
        Piece piece;
        switch (i % 6) {
            case 0:
                piece = table(rng);
                break;
            case 1:
            case 2:
                piece = chair(rng);
                break;
            case 3:
                piece = shelf(rng, 10 + rng.below(13));
                break;
            case 4:
                piece = cupboard(rng);
                break;
            default:
                piece = lamp(rng);
                break;
        }
        if (piece.size() > boxes) piece = crate(rng);
        boxes -= piece.size();
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// The turn by so many right angles about the z axis, times `length`.
Turn right_angles(std::uint64_t count, std::int64_t length) {
    const std::int64_t a = count % 2 == 0 ? length * (count % 4 == 0 ? 1 : -1) : 0;
    const std::int64_t b = count % 2 == 1 ? length * (count % 4 == 1 ? 1 : -1) : 0;
    return {{a, b, 0}, {-b, a, 0}, {0, 0, length}, length};
}

Turn placed(Rng& rng, bool turned) {
    if (!turned) return right_angles(rng.below(4), unit);
    Turn turn = random_upright_turn(rng);
    const std::int64_t factor = unit / turn.length;
    return {factor * turn.x, factor * turn.y, factor * turn.z, factor * turn.length};
}

}  // namespace

SceneInput3 room_with_furniture(const Room& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.polygons >= 12 && parameters.polygons <= 100'000);
    Rng rng(seed);
    std::vector<Piece> pieces = furniture(rng, parameters.polygons / 6 - 1);
    rng.shuffle(pieces);
    const std::int64_t columns = ceil_sqrt(pieces.size());
    const std::int64_t rows = (static_cast<std::int64_t>(pieces.size()) + columns - 1) / columns;
    const Int3 corner{unit * cell_side * columns, unit * cell_side * rows, unit * 280 * cm};
    MeshBuilder mesh;
    SceneInput3 scene;
    scene.world = parameters.world;
    if (parameters.world) {
        mesh.add_box({}, corner);
        scene.meshes.push_back(mesh.take());
    } else {
        mesh.add_box({0, 0, -unit * 20 * cm}, {corner.x, corner.y, 0});
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Turn turn = placed(rng, parameters.turned);
        const auto index = static_cast<std::int64_t>(i);
        const auto jitter = [&rng] { return rng.between(-4 * cm, 4 * cm); };
        const std::int64_t x = cell_side * (index % columns) + cell_side / 2 + jitter();
        const std::int64_t y = cell_side * (index / columns) + cell_side / 2 + jitter();
        const Int3 gap = parameters.lifted ? Int3{1, 1, 1} : Int3{};
        for (const Box& box : pieces[i])
            mesh.add_turned_box(turn, unit * Int3{x, y, 0}, box.low + gap, box.high - gap);
    }
    scene.meshes.push_back(mesh.take());
    return scene;
}

namespace {

constexpr std::int64_t room_side = 64;
constexpr std::int64_t room_height = 40;
constexpr std::int64_t half_wall = 2;

/// A wall from one pillar to the next, along x or along y, with a door of ten by thirty or without.
void add_wall(MeshBuilder& mesh, Rng& rng, Int3 pillar, bool along_x) {
    const Int3 u = along_x ? Int3{1, 0, 0} : Int3{0, 1, 0};
    const Int3 across = along_x ? Int3{0, 2 * half_wall, 0} : Int3{2 * half_wall, 0, 0};
    const Int3 start =
        pillar + half_wall * u - (along_x ? Int3{0, half_wall, 0} : Int3{half_wall, 0, 0});
    const auto at = [&](std::int64_t along, std::int64_t z) {
        return start + along * u + Int3{0, 0, z};
    };
    constexpr std::int64_t length = room_side - 2 * half_wall;
    if (rng.one_in(4)) {
        mesh.add_prism({at(0, 0), at(length, 0), at(length, room_height), at(0, room_height)},
                       across);
        return;
    }
    const std::int64_t door = rng.between(4, length - 16);
    mesh.add_prism({at(0, 0), at(door, 0), at(door, 30), at(door + 12, 30), at(door + 12, 0),
                    at(length, 0), at(length, room_height), at(0, room_height)},
                   across);
}

}  // namespace

SceneInput3 building(const Building& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.columns >= 1 && parameters.columns <= 100);
    SIGHTLINE_EXPECT(parameters.rows >= 1 && parameters.rows <= 100);
    Rng rng(seed);
    const auto columns = static_cast<std::int64_t>(parameters.columns);
    const auto rows = static_cast<std::int64_t>(parameters.rows);
    MeshBuilder mesh;
    SceneInput3 scene;
    scene.world = parameters.world;
    // Inside a world the outer walls are the world's; the inner ones end at it.
    const std::int64_t first = parameters.world ? 1 : 0;
    const Int3 low{-half_wall, -half_wall, 0};
    const Int3 high{room_side * columns + half_wall, room_side * rows + half_wall, 0};
    if (parameters.world) {
        mesh.add_box({half_wall, half_wall, 0},
                     {high.x - 2 * half_wall, high.y - 2 * half_wall, room_height});
        scene.meshes.push_back(mesh.take());
    } else {
        mesh.add_box(low - Int3{0, 0, 4}, high);
    }
    const auto add_pillar = [&](Int3 at) {
        mesh.add_box(at + low, at + Int3{half_wall, half_wall, room_height});
    };
    for (std::int64_t j = 0; j <= rows; ++j) {
        for (std::int64_t i = 0; i <= columns; ++i) {
            const Int3 pillar{room_side * i, room_side * j, 0};
            const bool inner_column = i >= first && i <= columns - first;
            const bool inner_row = j >= first && j <= rows - first;
            if (inner_column && inner_row) add_pillar(pillar);
            if (inner_row && i < columns) add_wall(mesh, rng, pillar, true);
            if (inner_column && j < rows) add_wall(mesh, rng, pillar, false);
        }
    }
    if (mesh.empty()) {  // one room: something to look at
        add_pillar({room_side / 2, room_side / 2, 0});
    }
    scene.meshes.push_back(mesh.take());
    return scene;
}

SceneInput3 city3(const City3& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.columns >= 1 && parameters.columns <= 200);
    SIGHTLINE_EXPECT(parameters.rows >= 1 && parameters.rows <= 200);
    Rng rng(seed);
    constexpr std::int64_t block = 64;
    MeshBuilder mesh;
    const auto columns = static_cast<std::int64_t>(parameters.columns);
    const auto rows = static_cast<std::int64_t>(parameters.rows);
    mesh.add_box({0, 0, -8}, {block * columns, block * rows, 0});
    for (std::int64_t j = 0; j < rows; ++j) {
        for (std::int64_t i = 0; i < columns; ++i) {
            const Int3 low{block * i + rng.between(4, 16), block * j + rng.between(4, 16), 0};
            const Int3 high{block * i + rng.between(44, 60), block * j + rng.between(44, 60),
                            rng.between(16, 128)};
            const std::uint64_t kind = rng.below(4);
            if (kind == 0) {  // two houses side by side
                const std::int64_t middle = rng.between(low.x + 8, high.x - 8);
                mesh.add_box(low, {middle, high.y, high.z});
                mesh.add_box({middle, low.y, 0}, {high.x, high.y, rng.between(16, 128)});
                continue;
            }
            mesh.add_box(low, high);
            if (kind != 1) continue;
            const Int3 foot{rng.between(low.x, low.x + 8), rng.between(low.y, low.y + 8), high.z};
            mesh.add_box(foot, foot + Int3{12, 12, rng.between(16, 96)});
        }
    }
    return mesh.take_scene();
}

}  // namespace sightline::families
