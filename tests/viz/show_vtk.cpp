// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <optional>

#include "viz/environment.hpp"
#include "viz/pictures.hpp"
#include "viz/window_vtk.hpp"
#include "viz/x_display.hpp"

namespace sightline::viz {
namespace {

using detail::Window;
using testing::HasSubstr;

/// A window on a server of its own.
class Show : public testing::Test {
protected:
    void SetUp() override {
        auto started = detail::Xvfb::start();
        if (!started) GTEST_SKIP() << started.error().message;
        server_.emplace(std::move(*started));
        auto opened = detail::XConnection::open(server_->name());
        ASSERT_TRUE(opened) << opened.error().message;
        connection_.emplace(std::move(*opened));
        window_.emplace(list_, ShowOptions{.width = 600, .height = 500}, connection_->handle());
    }
    void TearDown() override {
        window_.reset();
        connection_.reset();
        server_.reset();
    }
    void press(char key) {
        window_->interactor()->SetKeyCode(key);
        window_->interactor()->InvokeEvent(vtkCommand::CharEvent);
    }
    void mouse(int x, int y, unsigned long event) {
        window_->interactor()->SetEventInformation(x, y);
        window_->interactor()->InvokeEvent(event);
    }
    [[nodiscard]] vtkCamera* camera() const { return window_->page().drawing()->GetActiveCamera(); }

    DrawList list_ = small_picture();
    std::optional<detail::Xvfb> server_;
    std::optional<detail::XConnection> connection_;
    std::optional<Window> window_;
};

TEST_F(Show, EndsWhenQIsPressed) {
    int turns = 0;
    window_->run([&] {
        if (++turns == 2) press('q');
    });
    EXPECT_EQ(turns, 2);
}

TEST_F(Show, EndsWhenTheWindowIsClosed) {
    int turns = 0;
    window_->run([&] {
        // What the interactor does when the window manager asks the window to close.
        if (++turns == 2) window_->interactor()->ExitCallback();
    });
    EXPECT_EQ(turns, 2);
}

TEST_F(Show, WheelZoomsRoundTheMouseAndRShowsEverythingAgain) {
    double before = 0;
    double zoomed = 0;
    double again = 0;
    int turns = 0;
    window_->run([&] {
        switch (++turns) {
            case 1:
                before = camera()->GetParallelScale();
                mouse(300, 250, vtkCommand::MouseWheelForwardEvent);
                zoomed = camera()->GetParallelScale();
                press('r');
                again = camera()->GetParallelScale();
                break;
            default:
                press('q');
        }
    });
    EXPECT_NEAR(zoomed, before / 1.2, 1e-9);
    EXPECT_EQ(again, before);
}

TEST_F(Show, ScaleBarFollowsTheZoom) {
    std::string before;
    std::string after;
    const auto text = [&] { return window_->page().layout().texts.back().text; };
    int turns = 0;
    window_->run([&] {
        if (++turns > 1) return press('q');
        before = text();
        for (int i = 0; i < 13; ++i) mouse(200, 200, vtkCommand::MouseWheelForwardEvent);
        after = text();
    });
    EXPECT_EQ(before, "2");
    EXPECT_EQ(after, "0.1") << "1.2 to the 13th is a little more than 10";
}

TEST_F(Show, DraggingMovesTheDrawingWithTheMouse) {
    std::array<double, 3> before{};
    std::array<double, 3> after{};
    int turns = 0;
    window_->run([&] {
        if (++turns > 1) return press('q');
        camera()->GetFocalPoint(before.data());
        mouse(200, 200, vtkCommand::LeftButtonPressEvent);
        mouse(230, 210, vtkCommand::MouseMoveEvent);
        mouse(230, 210, vtkCommand::LeftButtonReleaseEvent);
        mouse(290, 290, vtkCommand::MouseMoveEvent);
        camera()->GetFocalPoint(after.data());
    });
    // One unit of the drawing is one pixel as long as nobody zooms.
    EXPECT_NEAR(after[0], before[0] - 30, 0.5);
    EXPECT_NEAR(after[1], before[1] - 10, 0.5);
}

TEST_F(Show, LegendKeepsItsPlaceWhenTheWindowGrows) {
    int turns = 0;
    window_->run([&] {
        if (++turns > 1) return press('q');
        window_->window()->SetSize(900, 700);
        window_->interactor()->InvokeEvent(vtkCommand::ConfigureEvent);
    });
    EXPECT_EQ(window_->page().layout().width, 900);
    EXPECT_EQ(window_->page().layout().height, 700);
}

TEST(ShowWithoutDisplay, SaysSo) {
    const Environment display("DISPLAY", nullptr);
    const auto answer = show(small_picture());
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, Errc::unsupported);
    EXPECT_THAT(answer.error().message, HasSubstr("DISPLAY"));
}

}  // namespace
}  // namespace sightline::viz
