// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/vtk_file.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "viz/pictures.hpp"
#include "viz/spaces.hpp"
#include "viz/xml_check.hpp"

namespace sightline::viz {
namespace {

using testing::HasSubstr;

std::string vtp(const DrawList& list) {
    std::ostringstream out;
    write_vtp(list, out);
    return out.str();
}

TEST(VtkFile, IsWellFormedAndCountsItsCells) {
    const std::string text = vtp(small_picture());
    EXPECT_EQ(XmlCheck::fault(text), "");
    // Four corners of the body, three of its hole; (1,1), (9,1), (9,9), (1,9) and (5,1).
    EXPECT_THAT(text, HasSubstr("NumberOfPoints=\"12\" NumberOfVerts=\"2\" NumberOfLines=\"5\" "
                                "NumberOfStrips=\"0\" NumberOfPolys=\"7\""));
}

TEST(VtkFile, CoordinatesReadBackAsTheSameDoubles) {
    DrawList list;
    const double third = 1.0 / 3;
    list.add({.name = "p", .points = {{third, 1e-310, 1e150}}});
    const std::string text = vtp(list);
    const std::size_t at = text.find("NumberOfComponents=\"3\" format=\"ascii\">\n");
    ASSERT_NE(at, std::string::npos);
    const char* from = text.c_str() + text.find('\n', at);
    char* end = nullptr;
    EXPECT_EQ(std::strtod(from, &end), third);
    EXPECT_EQ(std::strtod(end, &end), 1e-310);
    EXPECT_EQ(std::strtod(end, &end), 1e150);
}

TEST(VtkFile, EmptyListIsAFile) { EXPECT_EQ(XmlCheck::fault(vtp({})), ""); }

TEST(VtkFile, PolygonsInSpaceAreFansOfTriangles) {
    DrawList list;
    list.camera = Camera{};
    add_box(list, "box", {0, 0, 0}, {1, 1, 1}, Palette::solid, 1);
    EXPECT_THAT(vtp(list), HasSubstr("NumberOfPoints=\"8\" NumberOfVerts=\"0\" "
                                     "NumberOfLines=\"12\" NumberOfStrips=\"0\" "
                                     "NumberOfPolys=\"12\""));
}

TEST(VtmFile, NamesOneFileALayer) {
    DrawList list = small_space();
    list.layers[0].name = "a/\"b\" c";
    EXPECT_EQ(vtm_parts(list, "x").at(0), "x_0_a__b__c.vtp") << "no name leads out of the folder";
    EXPECT_EQ(vtm_parts(list, "x").size(), list.layers.size());
    std::ostringstream out;
    write_vtm(list, "x", out);
    EXPECT_EQ(XmlCheck::fault(out.str()), "");
    EXPECT_THAT(out.str(), HasSubstr("<DataSet index=\"4\" name=\"glass\" "
                                     "file=\"x_4_glass.vtp\"/>"));
}

}  // namespace
}  // namespace sightline::viz
