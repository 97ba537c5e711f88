// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/draw_list.hpp"

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>

#include "viz/pictures.hpp"

namespace sightline::viz {
namespace {

using testing::ElementsAre;
using testing::Field;

TEST(DrawList, LayersArePaintedByOrderAndThenInTheOrderOfAdding) {
    DrawList list;
    list.add({.name = "front", .order = 5});
    list.add({.name = "back", .order = 1});
    list.add({.name = "back too", .order = 1});
    EXPECT_THAT(list.layers,
                ElementsAre(Field(&Layer::name, "back"), Field(&Layer::name, "back too"),
                            Field(&Layer::name, "front")));
    EXPECT_EQ(list.find("back too"), &list.layers[1]);
    EXPECT_EQ(list.find("side"), nullptr);
}

TEST(DrawList, LegendNamesEachLayerWithItsCountAndKind) {
    const auto entries = legend(small_picture());
    ASSERT_EQ(entries.size(), 4u);
    EXPECT_EQ(entries[0].text, "bodies (1)");
    EXPECT_EQ(entries[0].sample, LegendSample::area);
    EXPECT_EQ(entries[1].text, "sightlines (2)");
    EXPECT_EQ(entries[1].sample, LegendSample::line);
    EXPECT_EQ(entries[2].text, "path");
    EXPECT_EQ(entries[3].sample, LegendSample::marker);
    EXPECT_EQ(entries[3].style.colour, Palette::green);
}

TEST(DrawList, LayerWithoutLegendTextStaysOutOfTheLegend) {
    DrawList list = small_picture();
    list.layers[1].legend.clear();
    EXPECT_EQ(legend(list).size(), 3u);
}

TEST(DrawList, BoundsContainEveryKindOfThing) {
    DrawList list;
    EXPECT_TRUE(bounds(list).is_empty());
    list.add({.polygons = {{{{0, 0}, {1, 0}, {0, 1}}, {}, 0}}});
    EXPECT_EQ(bounds(list), (Box{{0, 0, 0}, {1, 1, 0}}));
    list.add({.polylines = {{{{-1, 0}, {0, 0}}, 0}}});
    list.add({.segments = {{0, -2}, {0, 0}}});
    list.add({.points = {{3, 0}}});
    list.add({.labels = {{{0, 4}, "here"}}});
    EXPECT_EQ(bounds(list), (Box{{-1, -2, 0}, {3, 4, 0}}));
}

TEST(DrawList, WindowHasAMarginAndNoExtremeShape) {
    const Box square = window_around({{0, 0, 0}, {10, 10, 0}});
    EXPECT_LT(square.low.x, 0);
    EXPECT_GT(square.high.y, 10);
    const Box flat = window_around({{0, 5, 0}, {30, 5, 0}});
    EXPECT_LE(flat.high.x - flat.low.x, 3 * (flat.high.y - flat.low.y));
    EXPECT_EQ((flat.low.y + flat.high.y) / 2, 5);
}

TEST(DrawList, WindowOfExtremeBoxesIsFiniteAndNotEmpty) {
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    for (const Box& box :
         {Box{}, Box{{3, 4, 0}, {3, 4, 0}}, Box{{-largest, -largest, 0}, {largest, largest, 0}},
          Box{{1e150, 0, 0}, {2e150, 1, 0}}, Box{{0, 0, 0}, {1e-310, 1e-310, 0}},
          Box{{0, 0, 0}, {least, 0, 0}}}) {
        const Box window = window_around(box);
        EXPECT_TRUE(std::isfinite(window.high.x - window.low.x));
        EXPECT_LT(window.low.x, window.high.x);
        EXPECT_LT(window.low.y, window.high.y);
    }
}

TEST(DrawList, CountsAreGroupedByThousands) {
    EXPECT_EQ(with_thousands(0), "0");
    EXPECT_EQ(with_thousands(999), "999");
    EXPECT_EQ(with_thousands(1000), "1,000");
    EXPECT_EQ(with_thousands(12345678), "12,345,678");
}

TEST(DrawList, PrintsOneElementALine) {
    std::ostringstream out;
    out << small_picture();
    EXPECT_EQ(out.str(), R"(title "A body & its <hole>"
view 0 0, 10 10
layer bodies order 1 count 1 legend "bodies"
  style colour #484f59 width 1 opacity 1 fill #c4c8ce 1 marker none 6
  polygon 7: 2 2, 8 2, 8 8, 2 8
  hole: 4 4, 6 4, 5 6
layer edges order 2 count 2 legend "sightlines"
  style colour #0072b2 width 0.5 opacity 0.5 fill #000000 0 marker none 6
  segment 0: 1 1, 9 1
  segment 1: 9 1, 9 9
layer path order 3 count 0 legend "path"
  style colour #d55e00 width 3 opacity 1 fill #000000 0 marker none 6
  polyline 0: 1 9, 1 1, 5 1
layer ends order 4 count 0 legend "ends"
  style colour #009e73 width 0 opacity 1 fill #000000 0 marker disc 10
  point 0: 1 9
  point 1: 5 1
  label 1 9: from
  label 5 1: to
)");
}

TEST(DrawList, EqualityReadsEveryField) {
    const DrawList list = small_picture();
    DrawList other = list;
    EXPECT_EQ(list, other);
    other.layers[1].segments[0].x += 1;
    EXPECT_NE(list, other);
}

}  // namespace
}  // namespace sightline::viz
