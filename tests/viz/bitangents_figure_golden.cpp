// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of docs/structures/bitangents.md. To draw it anew:
//   SIGHTLINE_BLESS=1 build/release/bin/test_viz --gtest_filter=BitangentsFigure.*
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "sightline/planar/free_bitangents.hpp"
#include "sightline/viz/draw.hpp"
#include "sightline/viz/svg.hpp"
#include "support/scenes.hpp"

namespace sightline::viz {
namespace {

Layer layer_of(const std::string& type, const char* legend, Colour colour) {
    return {.name = type,
            .legend = type + ": " + legend,
            .order = PaintOrder::graphs,
            .style = {.colour = colour, .width = 2}};
}

// The free bitangents between bodies, each once, coloured by type.
DrawList figure() {
    const Scene2 scene = sightline::testing::scene2(
        "0 0, 3 -1, 5 1, 4 4, 1 4 | 12 -1, 15 0, 15 3, 12 4, 10 2 | 6 8, 9 7, 10 9, 8 11");
    DrawList list = draw(scene, {.title = "Free bitangents of three bodies"});
    std::vector<Layer> layers{layer_of("LL", "both on the left", Palette::blue),
                              layer_of("RR", "both on the right", Palette::vermilion),
                              layer_of("LR", "from left to right", Palette::green),
                              layer_of("RL", "from right to left", Palette::purple)};
    for (const FreeBitangent& b : free_bitangents(scene, {.one_body = false})) {
        if (!b.is_canonical()) continue;
        for (Layer& layer : layers) {
            if (layer.name != b.type()) continue;
            for (const VertexId v : {b.source, b.target})
                layer.segments.push_back({scene[v].x, scene[v].y, 0});
            ++layer.count;
        }
    }
    for (Layer& layer : layers) list.add(std::move(layer));
    list.notes = {"from the lesser vertex", "to the greater"};
    return list;
}

TEST(BitangentsFigure, ShowsFourOfEachPairUnlessTheThirdBodyBlocks) {
    const DrawList list = figure();
    std::size_t lines = 0;
    for (const char* type : {"LL", "RR", "LR", "RL"}) {
        ASSERT_NE(list.find(type), nullptr);
        EXPECT_EQ(list.find(type)->count, 3U) << type;
        lines += list.find(type)->segments.size() / 2;
    }
    EXPECT_EQ(lines, 12U);
    EXPECT_EQ(legend(list).size(), 5U);
}

TEST(BitangentsFigure, IsWhatTheDocumentationShows) {
    const std::string file = SIGHTLINE_TESTS_DIR "/../docs/figures/bitangents.svg";
    std::ostringstream got;
    write_svg(figure(), got, {.width = 800});
    if (std::getenv("SIGHTLINE_BLESS") != nullptr) std::ofstream(file) << got.str();
    std::ostringstream wanted;
    wanted << std::ifstream(file).rdbuf();
    EXPECT_EQ(got.str(), wanted.str());
}

}  // namespace
}  // namespace sightline::viz
