// SPDX-License-Identifier: GPL-3.0-or-later
#include "viz/space_vtk.hpp"

#include <gmock/gmock.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <optional>

#include "sightline/viz/render.hpp"
#include "viz/layout.hpp"
#include "viz/spaces.hpp"
#include "viz/window_vtk.hpp"
#include "viz/x_display.hpp"

namespace sightline::viz {
namespace {

/// The picture of a list, as VTK reads it.
class SpacePicture {
public:
    explicit SpacePicture(const DrawList& list)
        : layout_(detail::make_layout(projected(list), {.width = 500})) {
        const std::string path =
            (std::filesystem::path(testing::TempDir()) / "sightline-space.png").string();
        const auto drawn = render_png(list, path, {.width = 500, .supersampling = 2});
        if (!drawn) throw std::runtime_error(drawn.error().message);
        vtkNew<vtkPNGReader> reader;
        reader->SetFileName(path.c_str());
        reader->Update();
        image_ = reader->GetOutput();
        std::filesystem::remove(path);
    }
    /// At a place of the projected list.
    [[nodiscard]] Colour at(double x, double y) const {
        const detail::Pixel p = layout_.to_pixel({x, y});
        const auto* c = static_cast<const unsigned char*>(image_->GetScalarPointer(
            static_cast<int>(p.x), image_->GetDimensions()[1] - 1 - static_cast<int>(p.y), 0));
        return {c[0], c[1], c[2]};
    }

private:
    detail::Layout layout_;
    vtkSmartPointer<vtkImageData> image_;
};

class Space : public testing::Test {
protected:
    void SetUp() override {
        auto started = detail::Xvfb::start();
        if (!started) GTEST_SKIP() << started.error().message;
    }
};

/// Whether two colours differ by their brightness only, as sides of one thing do.
bool same_hue(const Colour& a, const Colour& b) {
    const auto share = [](const Colour& c, int channel) {
        return static_cast<double>(channel) / (1 + c.red + c.green + c.blue);
    };
    return std::abs(share(a, a.red) - share(b, b.red)) < 0.05 &&
           std::abs(share(a, a.green) - share(b, b.green)) < 0.05;
}

constexpr Colour white{255, 255, 255};

TEST_F(Space, NearThingsHideFarOnesWhateverTheirLayers) {
    const SpacePicture picture(small_space());
    EXPECT_TRUE(same_hue(picture.at(2, -1), Palette::vermilion))
        << "not blue, though painted later";
    EXPECT_TRUE(same_hue(picture.at(6, -1), Palette::blue)) << "beside the red box";
    EXPECT_EQ(picture.at(6, -6), white);
}

TEST_F(Space, LinesAreHiddenBehindAndSeenBeforeFaces) {
    const SpacePicture picture(small_space());
    EXPECT_EQ(picture.at(2, 1), Palette::black);
    EXPECT_EQ(picture.at(6, 1), Palette::black);
    EXPECT_NE(picture.at(-2, 1), Palette::black);
    EXPECT_NE(picture.at(-6, 1), Palette::black);
    EXPECT_EQ(picture.at(9, 1), Palette::purple) << "the ball";
}

TEST_F(Space, WhatIsBehindGlassShinesThrough) {
    const SpacePicture picture(small_space());
    const Colour red = picture.at(2, -1);
    const Colour behind = picture.at(-2, -1);
    EXPECT_LT(behind.red, red.red);
    EXPECT_GT(behind.green, red.green);
    EXPECT_GT(behind.red, picture.at(-6, -1).red) << "glass before blue";
}

TEST_F(Space, GlassBehindThingsChangesNothing) {
    DrawList list = small_space();
    for (Layer& layer : list.layers) {
        if (layer.name != "glass") continue;
        for (Position& p : layer.polygons[0].outer) p.z = -4.5;
    }
    const SpacePicture picture(list);
    EXPECT_TRUE(same_hue(picture.at(-2, -1), Palette::vermilion));
    EXPECT_TRUE(same_hue(picture.at(-6, -1), Palette::blue));
    EXPECT_NE(picture.at(-6, -6), white);
}

TEST_F(Space, TwoPanesMixInTheOrderOfDepthNotOfLayers) {
    const auto panes = [](double first, double second) {
        DrawList list;
        list.camera = Camera{.from = {0, 0, 1}, .up = {0, 1, 0}};
        list.view = {{-5, -5, -5}, {5, 5, 5}};
        for (const auto& [colour, z] :
             {std::pair{Palette::vermilion, first}, {Palette::blue, second}}) {
            Layer pane{.name = "pane", .style = {.width = 0, .fill = colour, .fill_opacity = 0.5}};
            pane.polygons = {{{{-4, -4, z}, {4, -4, z}, {4, 4, z}, {-4, 4, z}}, {}, 0}};
            list.add(std::move(pane));
        }
        return SpacePicture(list).at(0, 0);
    };
    const Colour blue_over_red = panes(0, 1);
    const Colour red_over_blue = panes(1, 0);
    EXPECT_GT(red_over_blue.red, blue_over_red.red + 20);
    EXPECT_GT(blue_over_red.blue, red_over_blue.blue + 20);
}

TEST_F(Space, SidesOfABoxDifferInBrightness) {
    DrawList list;
    list.camera = Camera{.from = {1, -2, 1.5}};
    add_box(list, "box", {0, 0, 0}, {1, 1, 1}, Palette::solid, 1);
    const SpacePicture picture(list);
    // Middles of the three sides that are seen.
    DrawList middles;
    middles.camera = list.camera;
    middles.add({.name = "middles", .points = {{0.5, 0.5, 1}, {0.5, 0, 0.5}, {1, 0.5, 0.5}}});
    const auto at = projected(middles).layers[0].points;
    const int top = picture.at(at[0].x, at[0].y).red;
    const int front = picture.at(at[1].x, at[1].y).red;
    const int side = picture.at(at[2].x, at[2].y).red;
    EXPECT_GT(top, front + 8);
    EXPECT_GT(front, side + 8);
}

TEST(Brightness, IsThatOfEitherSideAndLeastEdgeOn) {
    EXPECT_EQ(detail::brightness({0.6, 0, 0.8}), detail::brightness({-0.6, 0, -0.8}));
    EXPECT_GT(detail::brightness({0, 0, 1}), detail::brightness({1, 0, 0}));
    EXPECT_GT(detail::brightness({0, 0.6, 0.8}), detail::brightness({0, -0.6, 0.8}));
}

TEST_F(Space, WindowTurnsWhenDraggedAndComesBackOnR) {
    auto server = detail::Xvfb::start();
    ASSERT_TRUE(server);
    auto connection = detail::XConnection::open(server->name());
    ASSERT_TRUE(connection);
    const DrawList list = projected(small_space());
    detail::Window window(list, {.width = 400, .height = 300}, connection->handle());
    vtkCamera* camera = window.page().drawing()->GetActiveCamera();
    double before[3];
    double turned[3];
    double again[3];
    int turns = 0;
    const auto mouse = [&](int x, int y, unsigned long event) {
        window.interactor()->SetEventInformation(x, y);
        window.interactor()->InvokeEvent(event);
    };
    window.run([&] {
        switch (++turns) {
            case 1:
                camera->GetDirectionOfProjection(before);
                mouse(100, 150, vtkCommand::MouseMoveEvent);
                mouse(100, 150, vtkCommand::LeftButtonPressEvent);
                mouse(160, 150, vtkCommand::MouseMoveEvent);
                mouse(160, 150, vtkCommand::LeftButtonReleaseEvent);
                camera->GetDirectionOfProjection(turned);
                break;
            case 2:
                window.interactor()->SetKeyCode('r');
                window.interactor()->InvokeEvent(vtkCommand::CharEvent);
                camera->GetDirectionOfProjection(again);
                window.interactor()->SetKeyCode('q');
                window.interactor()->InvokeEvent(vtkCommand::CharEvent);
                break;
            default:
                break;
        }
    });
    EXPECT_GT(std::abs(turned[0] - before[0]), 0.05);
    EXPECT_THAT(again, testing::ElementsAreArray(before));
}

}  // namespace
}  // namespace sightline::viz
