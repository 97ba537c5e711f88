// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkInteractorStyle.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "viz/window_vtk.hpp"
#include "viz/x_display.hpp"

namespace sightline::viz {
namespace detail {
namespace {

/// Moves and zooms a drawing of the plane.
class PlaneStyle : public vtkInteractorStyle {
public:
    static PlaneStyle* New();
    vtkTypeMacro(PlaneStyle, vtkInteractorStyle)

        vtkRenderer* drawing = nullptr;
    std::function<void()> reset;
    std::function<void()> zoomed;

    void OnLeftButtonDown() override { StartPan(); }
    void OnLeftButtonUp() override { EndPan(); }
    void OnMiddleButtonDown() override { StartPan(); }
    void OnMiddleButtonUp() override { EndPan(); }
    void OnMouseMove() override {
        if (State == VTKIS_PAN) pan();
    }
    void OnMouseWheelForward() override { zoom(1.2); }
    void OnMouseWheelBackward() override { zoom(1 / 1.2); }
    void OnChar() override {
        switch (Interactor->GetKeyCode()) {
            case 'q':
            case 'Q':
                Interactor->ExitCallback();
                break;
            case '+':
                zoom(1.2);
                break;
            case '-':
                zoom(1 / 1.2);
                break;
            case 'r':
            case 'R':
                reset();
                Interactor->Render();
                break;
            default:
                break;
        }
    }

private:
    /// World units a pixel.
    [[nodiscard]] double resolution() const {
        return 2 * drawing->GetActiveCamera()->GetParallelScale() /
               std::max(1, drawing->GetSize()[1]);
    }
    void move_by(double dx, double dy) {
        vtkCamera* camera = drawing->GetActiveCamera();
        double p[3];
        camera->GetFocalPoint(p);
        camera->SetFocalPoint(p[0] + dx, p[1] + dy, p[2]);
        camera->GetPosition(p);
        camera->SetPosition(p[0] + dx, p[1] + dy, p[2]);
    }
    void pan() {
        const int* now = Interactor->GetEventPosition();
        const int* last = Interactor->GetLastEventPosition();
        move_by(-(now[0] - last[0]) * resolution(), -(now[1] - last[1]) * resolution());
        Interactor->Render();
    }
    /// Keeps what is under the mouse where it is.
    void zoom(double factor) {
        vtkCamera* camera = drawing->GetActiveCamera();
        const double scale = camera->GetParallelScale() / factor;
        if (!(scale > 1e-6 && scale < 1e7)) return;
        const int* at = Interactor->GetEventPosition();
        const int* origin = drawing->GetOrigin();
        const int* size = drawing->GetSize();
        const double moved = resolution() * (1 - 1 / factor);
        move_by((at[0] - origin[0] - size[0] / 2.0) * moved,
                (at[1] - origin[1] - size[1] / 2.0) * moved);
        camera->SetParallelScale(scale);
        zoomed();
        Interactor->Render();
    }
};
vtkStandardNewMacro(PlaneStyle);

/// Turns, moves and zooms a drawing of space.
class SpaceStyle : public vtkInteractorStyleTrackballCamera {
public:
    static SpaceStyle* New();
    vtkTypeMacro(SpaceStyle, vtkInteractorStyleTrackballCamera)

        std::function<void()> reset;

    void OnChar() override {
        switch (Interactor->GetKeyCode()) {
            case 'q':
            case 'Q':
                Interactor->ExitCallback();
                break;
            case 'r':
            case 'R':
                reset();
                Interactor->Render();
                break;
            default:
                break;
        }
    }
};
vtkStandardNewMacro(SpaceStyle);

template <typename Action>
void observe(vtkObject* object, unsigned long event, Action& action) {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&action);
    command->SetCallback(
        [](vtkObject*, unsigned long, void* data, void*) { (*static_cast<Action*>(data))(); });
    object->AddObserver(event, command);
}

Layout layout_for(const DrawList& list, int width, int height, double magnification) {
    return make_layout(list, {.width = static_cast<double>(std::max(width, 200)),
                              .height = static_cast<double>(std::max(height, 200)),
                              .magnification = magnification});
}

}  // namespace

struct Window::Parts {
    Parts(const DrawList& shown, const ShowOptions& options)
        : list(shown),
          page(shown,
               layout_for(shown, static_cast<int>(options.width), static_cast<int>(options.height),
                          1),
               1, true),
          first_scale(camera()->GetParallelScale()) {}

    [[nodiscard]] vtkCamera* camera() const { return page.drawing()->GetActiveCamera(); }
    void arrange() {
        const int* size = window->GetSize();
        page.rearrange(
            layout_for(list, size[0], size[1], first_scale / camera()->GetParallelScale()));
    }
    void reset() {
        page.reset_camera();
        arrange();
    }

    const DrawList& list;
    VtkPage page;
    double first_scale;
    vtkNew<vtkRenderWindow> window;
    vtkNew<vtkRenderWindowInteractor> interactor;
    bool closed = false;
};

Window::Window(const DrawList& list, const ShowOptions& options, void* display)
    : parts_(std::make_unique<Parts>(list, options)) {
    vtkRenderWindow* window = parts_->window;
    window->SetDisplayId(display);
    window->SetMultiSamples(0);
    window->SetAlphaBitPlanes(1);
    window->SetSize(static_cast<int>(options.width), static_cast<int>(options.height));
    window->SetWindowName(list.title.empty() ? "sightline" : list.title.c_str());
    window->AddRenderer(parts_->page.page());
    window->AddRenderer(parts_->page.drawing());
    parts_->interactor->SetRenderWindow(window);
    if (list.camera) {
        vtkNew<SpaceStyle> style;
        style->SetDefaultRenderer(parts_->page.drawing());
        style->reset = [this] { parts_->reset(); };
        parts_->interactor->SetInteractorStyle(style);
        return;
    }
    vtkNew<PlaneStyle> style;
    style->drawing = parts_->page.drawing();
    style->SetDefaultRenderer(style->drawing);
    style->reset = [this] { parts_->reset(); };
    style->zoomed = [this] { parts_->arrange(); };
    parts_->interactor->SetInteractorStyle(style);
}

Window::~Window() = default;

vtkRenderWindowInteractor* Window::interactor() const { return parts_->interactor; }
vtkRenderWindow* Window::window() const { return parts_->window; }
const VtkPage& Window::page() const { return parts_->page; }

void Window::run(const std::function<void()>& each_turn) {
    Parts& parts = *parts_;
    std::function<void()> closing = [&] { parts.closed = true; };
    std::function<void()> resizing = [&] { parts.arrange(); };
    std::function<void()> drawing = [&] {
        const double shown = 2 * parts.camera()->GetParallelScale();
        parts.page.magnify(parts.page.layout().data.height / shown);
    };
    observe(parts.interactor, vtkCommand::ExitEvent, closing);
    observe(parts.interactor, vtkCommand::ConfigureEvent, resizing);
    observe(parts.page.drawing(), vtkCommand::StartEvent, drawing);
    parts.interactor->Initialize();
    parts.window->Render();
    // Not Start(): in VTK 9.1 its end destroys what is still in use. The flag is all that closing does.
    while (!parts.closed) {
        parts.interactor->ProcessEvents();
        if (each_turn) each_turn();
        if (!parts.closed) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    parts.interactor->RemoveAllObservers();
    parts.page.drawing()->RemoveAllObservers();
}

}  // namespace detail

Result<void> show(const DrawList& list, const ShowOptions& options) {
    auto connection = detail::XConnection::open("");
    if (!connection) return tl::unexpected(connection.error());
    const DrawList shown = projected(list);
    detail::Window(shown, options, connection->handle()).run();
    return {};
}

}  // namespace sightline::viz
