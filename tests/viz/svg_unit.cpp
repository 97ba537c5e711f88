// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/svg.hpp"

#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

#include <gmock/gmock.h>

#include "viz/layout.hpp"
#include "viz/pictures.hpp"
#include "viz/text.hpp"
#include "viz/xml_check.hpp"

namespace sightline::viz {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string svg(const DrawList& list, const SvgOptions& options = {}) {
    std::ostringstream out;
    write_svg(list, out, options);
    return out.str();
}

/// A picture with n random segments.
DrawList crowd(std::size_t n, std::uint64_t seed, std::size_t places) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> coordinate(0, 100);
    std::vector<Position> points(places);
    for (Position& p : points) p = {coordinate(random), coordinate(random)};
    Layer layer{
        .name = "edges", .legend = "visibility edges", .count = n, .style = {.opacity = 0.2}};
    for (std::size_t i = 0; i < 2 * n; ++i) layer.segments.push_back(points[random() % places]);
    DrawList list;
    list.add(std::move(layer));
    return list;
}

std::size_t occurrences(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++n;
    return n;
}

TEST(SvgGolden, SmallPicture) {
    const std::string file = SIGHTLINE_TESTS_DIR "/golden/viz/small.svg";
    const std::string got = svg(small_picture(), {.width = 600});
    if (std::getenv("SIGHTLINE_BLESS") != nullptr) std::ofstream(file) << got;
    std::ifstream in(file);
    std::ostringstream wanted;
    wanted << in.rdbuf();
    EXPECT_EQ(got, wanted.str());
}

TEST(Svg, IsWellFormedXmlWhateverTheTextsAre) {
    DrawList list = small_picture();
    list.title = "a < b & \"c\" > 'd' \x01 \xff \xc3\xa9 ]]>";
    list.layers[0].name = "\"><script>";
    list.layers[3].labels[0].text = "</text>&amp;";
    list.notes = {"5 < 6 & 7"};
    const std::string text = svg(list);
    EXPECT_EQ(XmlCheck::fault(text), "");
    EXPECT_THAT(text, HasSubstr("\xc3\xa9"));
    EXPECT_THAT(text, HasSubstr("&lt;/text&gt;&amp;amp;"));
    EXPECT_THAT(text, Not(HasSubstr("<script>")));
}

TEST(Svg, CheckOfWellFormednessFindsFaults) {
    EXPECT_EQ(XmlCheck::fault("<a b=\"1\">x<c/></a>"), "");
    for (const char* bad :
         {"<a>", "<a></b>", "<a b=1/>", "<a b=\"1\" b=\"2\"/>", "<a>&</a>", "x", "<a/><b/>"}) {
        EXPECT_NE(XmlCheck::fault(bad), "") << bad;
    }
}

TEST(Svg, EmptyListIsAPicture) {
    const std::string text = svg({});
    EXPECT_EQ(XmlCheck::fault(text), "");
    EXPECT_THAT(text, HasSubstr("width=\"1000\""));
}

TEST(Svg, PointsUpwardsAreHigherInThePicture) {
    DrawList list = small_picture();
    const detail::Layout layout = detail::make_layout(list, {.width = 500});
    const auto low = layout.to_pixel({0, 0});
    const auto high = layout.to_pixel({10, 10});
    EXPECT_LT(high.y, low.y);
    EXPECT_LT(low.x, high.x);
    EXPECT_NEAR(high.y, layout.data.y, 1e-9);
}

TEST(Svg, LegendStandsOutsideTheDrawingAndInsideThePicture) {
    DrawList list = small_picture();
    list.layers[0].legend =
        "a legend text that is much too long to stand on a single line of the legend";
    for (const double height : {0.0, 300.0, 900.0}) {
        const detail::Layout layout = detail::make_layout(list, {.width = 700, .height = height});
        ASSERT_EQ(layout.legend.size(), 4u);
        for (const auto& row : layout.legend) {
            EXPECT_FALSE(row.box.meets(layout.data));
            EXPECT_LE(row.box.y + row.box.height, layout.height);
        }
        for (const auto& text : layout.texts) {
            EXPECT_LE(text.at.x + detail::estimated_width(text.text, text.size), layout.width)
                << text.text;
        }
    }
}

TEST(Svg, LabelsDoNotCoverEachOtherAndStayInside) {
    DrawList list = small_picture();
    list.layers[3].labels = {{{11, 5}, "outside"},
                             {{0.1, 9.9}, "one"},
                             {{9.9, 0.1}, "two"},
                             {{0.1, 9.9}, "three"},
                             {{5, 5}, "four"}};
    const detail::Layout layout = detail::make_layout(list, {.width = 500});
    EXPECT_EQ(layout.labels.size(), 4u) << "what is outside of the picture has no label";
    std::vector<detail::Rectangle> boxes;
    for (const auto& l : layout.labels) {
        boxes.push_back({l.at.x, l.at.y - l.size, detail::estimated_width(l.text, l.size), l.size});
        EXPECT_TRUE(layout.data.contains(boxes.back())) << l.text;
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(boxes[i].meets(boxes[j])) << i << " " << j;
    }
}

TEST(Svg, ThreeHundredThousandEdgesStayBelowTenBytesAnEdge) {
    constexpr std::size_t n = 300'000;
    const std::string text = svg(crowd(n, 7, 2000));
    EXPECT_LT(text.size(), 10 * n);
    EXPECT_LE(occurrences(text, "<path"), 100u);
}

TEST(Svg, SelectionOfSegmentsIsDeclaredInTheLegend) {
    const DrawList list = crowd(1000, 8, 100);
    const std::string all = svg(list, {.max_segments = 1000});
    const std::string some = svg(list, {.max_segments = 100});
    EXPECT_THAT(all, Not(HasSubstr("Drawn:")));
    EXPECT_THAT(some, HasSubstr("Drawn: 100 of the"));
    EXPECT_THAT(some, HasSubstr("(1,000)"));
    EXPECT_LT(some.size(), all.size() / 2);
}

TEST(Svg, SameListGivesTheSameBytes) { EXPECT_EQ(svg(crowd(500, 9, 60)), svg(crowd(500, 9, 60))); }

TEST(Svg, ExtremeCoordinatesGiveFiniteNumbers) {
    DrawList list;
    list.add({.name = "far", .segments = {{-1e308, -1e308}, {1e308, 1e308}}});
    for (const double scale : {1e308, 1e150, 1e-150, 5e-324}) {
        list.layers[0].segments = {{0, 0}, {scale, scale}, {scale, 0}, {-scale, scale}};
        const std::string text = svg(list);
        EXPECT_THAT(text, Not(HasSubstr("nan"))) << scale;
        EXPECT_THAT(text, Not(HasSubstr("inf"))) << scale;
        EXPECT_EQ(XmlCheck::fault(text), "") << scale;
    }
}

}  // namespace
}  // namespace sightline::viz
