// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include "sightline/scene/scene2.hpp"
using namespace sightline;
TEST(Smoke, One) {
    SceneInput2 in;
    in.elements.push_back(Polygon2{{{0,0},{1,0},{0,1}}, {}});
    auto s = Scene2::make(in);
    ASSERT_TRUE(s) << s.error().message;
}
