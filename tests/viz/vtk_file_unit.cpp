// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/vtk_file.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "viz/pictures.hpp"
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

}  // namespace
}  // namespace sightline::viz
