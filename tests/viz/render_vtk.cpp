// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/render.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cerrno>
#include <filesystem>

#include "viz/environment.hpp"
#include "viz/layout.hpp"
#include "viz/pictures.hpp"
#include "viz/x_display.hpp"

namespace sightline::viz {
namespace {

using testing::HasSubstr;
using testing::Not;

class RenderPng : public testing::Test {
protected:
    void SetUp() override {
        static const std::string missing = [] {
            const auto server = detail::Xvfb::start();
            return server ? std::string() : server.error().message;
        }();
        if (!missing.empty()) GTEST_SKIP() << missing;
        folder_ =
            std::filesystem::path(testing::TempDir()) / ("sightline-" + std::to_string(::getpid()));
        std::filesystem::create_directory(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    [[nodiscard]] std::string file(const char* name) const { return (folder_ / name).string(); }
    [[nodiscard]] std::ptrdiff_t files() const {
        return std::distance(std::filesystem::directory_iterator(folder_), {});
    }

private:
    std::filesystem::path folder_;
};

/// A PNG file as VTK reads it; rows counted from the top.
struct Image {
    explicit Image(const std::string& path) {
        vtkNew<vtkPNGReader> reader;
        reader->SetFileName(path.c_str());
        reader->Update();
        data = reader->GetOutput();
    }
    [[nodiscard]] Colour at(double x, double y) const {
        const auto* p = static_cast<const unsigned char*>(data->GetScalarPointer(
            static_cast<int>(x), data->GetDimensions()[1] - 1 - static_cast<int>(y), 0));
        return {p[0], p[1], p[2]};
    }
    vtkSmartPointer<vtkImageData> data;
};

::testing::AssertionResult near(const Colour& a, const Colour& b) {
    const int off =
        std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
    if (off <= 12) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << "(" << int{a.red} << ", " << int{a.green} << ", " << int{a.blue} << ") is not ("
           << int{b.red} << ", " << int{b.green} << ", " << int{b.blue} << ")";
}

constexpr Colour white{255, 255, 255};

TEST_F(RenderPng, PictureHasTheSizeAndTheColoursOfTheList) {
    const DrawList list = small_picture();
    ASSERT_TRUE(render_png(list, file("a.png"), {.width = 640}));
    const Image image(file("a.png"));
    const detail::Layout layout = detail::make_layout(list, {.width = 640});
    EXPECT_EQ(image.data->GetDimensions()[0], 640);
    EXPECT_EQ(image.data->GetDimensions()[1], static_cast<int>(layout.height));
    const auto colour_at = [&](double x, double y) {
        const auto p = layout.to_pixel({x, y});
        return image.at(p.x, p.y);
    };
    EXPECT_TRUE(near(colour_at(3, 3), Palette::solid));
    EXPECT_TRUE(near(colour_at(5, 4.5), white)) << "the hole";
    EXPECT_TRUE(near(colour_at(0.5, 5), white)) << "outside";
    EXPECT_TRUE(near(colour_at(1, 5), Palette::vermilion)) << "the path";
    EXPECT_TRUE(near(colour_at(1, 9), Palette::green)) << "an end";
    EXPECT_FALSE(near(colour_at(9, 5), white)) << "a thin pale line is there";
    EXPECT_TRUE(
        near(image.at(layout.legend[0].box.x + 8, layout.legend[0].box.y + 7), Palette::solid))
        << "the legend";
}

TEST_F(RenderPng, SizeAskedForIsTheSizeGiven) {
    ASSERT_TRUE(render_png(small_picture(), file("a.png"),
                           {.width = 500, .height = 400, .supersampling = 1}));
    const Image image(file("a.png"));
    EXPECT_EQ(image.data->GetDimensions()[0], 500);
    EXPECT_EQ(image.data->GetDimensions()[1], 400);
}

TEST_F(RenderPng, TitleIsDrawn) {
    DrawList list = small_picture();
    ASSERT_TRUE(render_png(list, file("a.png"), {.width = 400, .supersampling = 2}));
    const Image image(file("a.png"));
    bool dark = false;
    for (int x = 16; x < 150; ++x) dark = dark || image.at(x, 24).green < 100;
    EXPECT_TRUE(dark);
}

TEST_F(RenderPng, CoordinatesFarFromOneAreDrawnAlike) {
    DrawList list = small_picture();
    ASSERT_TRUE(render_png(list, file("a.png"), {.width = 400, .supersampling = 2}));
    const auto scale = [](Position& p) { p = {p.x * 0x1p500, p.y * 0x1p500, 0}; };
    scale(list.view.low);
    scale(list.view.high);
    for (Layer& layer : list.layers) {
        for (auto& polygon : layer.polygons) {
            std::ranges::for_each(polygon.outer, scale);
            for (auto& hole : polygon.holes) std::ranges::for_each(hole, scale);
        }
        for (auto& line : layer.polylines) std::ranges::for_each(line.points, scale);
        std::ranges::for_each(layer.segments, scale);
        std::ranges::for_each(layer.points, scale);
        for (auto& label : layer.labels) scale(label.at);
    }
    list.scale_bar = true;
    ASSERT_TRUE(render_png(list, file("b.png"), {.width = 400, .supersampling = 2}));
    const Image small(file("a.png"));
    const Image large(file("b.png"));
    int different = 0;
    for (int y = 50; y < 250; ++y) {
        for (int x = 20; x < 250; ++x) different += small.at(x, y) == large.at(x, y) ? 0 : 1;
    }
    EXPECT_EQ(different, 0);
}

TEST_F(RenderPng, NothingIsLeftBesideTheFile) {
    ASSERT_TRUE(render_png(small_picture(), file("a.png"), {.width = 300, .supersampling = 1}));
    ASSERT_TRUE(render_png(small_picture(), file("a.png"), {.width = 300, .supersampling = 1}))
        << "again, over the old one";
    EXPECT_EQ(files(), 1);
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "no server of ours is left";
    EXPECT_EQ(errno, ECHILD);
}

TEST_F(RenderPng, UnwritablePathIsNamedAndNothingIsWritten) {
    const auto answer =
        render_png(small_picture(), file("none/a.png"), {.width = 300, .supersampling = 1});
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, Errc::cannot_write);
    EXPECT_THAT(answer.error().message, HasSubstr("none/a.png"));
    EXPECT_EQ(files(), 0);
}

TEST_F(RenderPng, ImpossibleSizesAreRefused) {
    for (const RenderOptions& options :
         {RenderOptions{.width = 0}, RenderOptions{.width = 100000}, RenderOptions{.height = 9}}) {
        const auto answer = render_png(small_picture(), file("a.png"), options);
        ASSERT_FALSE(answer);
        EXPECT_EQ(answer.error().code, Errc::bad_parameter);
    }
    EXPECT_EQ(files(), 0);
}

TEST_F(RenderPng, DeadDisplayIsReplacedByOneOfOurOwn) {
    const Environment display("DISPLAY", ":4711");
    EXPECT_TRUE(render_png(small_picture(), file("a.png"), {.width = 300, .supersampling = 1}));
}

TEST(RenderWithoutDisplay, SaysWhatToInstall) {
    const Environment display("DISPLAY", nullptr);
    const Environment path("PATH", "/nonexistent");
    const auto answer = render_png(small_picture(), "a.png", {.width = 300, .supersampling = 1});
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, Errc::unsupported);
    EXPECT_THAT(answer.error().message, HasSubstr("xvfb"));
    EXPECT_THAT(answer.error().message, Not(HasSubstr("\n")));
    EXPECT_FALSE(std::filesystem::exists("a.png"));
}

TEST_F(RenderPng, ServersOfOurOwnHaveDifferentNamesAndEnd) {
    pid_t process = 0;
    {
        const auto one = detail::Xvfb::start();
        const auto two = detail::Xvfb::start();
        ASSERT_TRUE(one && two);
        EXPECT_NE(one->name(), two->name());
        EXPECT_TRUE(detail::XConnection::open(one->name()));
        process = two->process();
        EXPECT_EQ(::kill(process, 0), 0);
    }
    EXPECT_EQ(::kill(process, 0), -1);
}

}  // namespace
}  // namespace sightline::viz
