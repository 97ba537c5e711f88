// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/render.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "viz/pictures.hpp"

namespace sightline::viz {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Render, BuildsWithoutVtkSayWhatIsMissing) {
    if (has_rendering()) GTEST_SKIP() << "built with VTK";
    for (const Result<void>& answer :
         {render_png(small_picture(), "x.png"), show(small_picture())}) {
        ASSERT_FALSE(answer);
        EXPECT_EQ(answer.error().code, Errc::unsupported);
        EXPECT_THAT(answer.error().message, HasSubstr("libvtk9-dev"));
        EXPECT_THAT(answer.error().message, Not(HasSubstr("\n")));
    }
    EXPECT_FALSE(std::filesystem::exists("x.png"));
}

}  // namespace
}  // namespace sightline::viz
