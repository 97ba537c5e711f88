// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>

#include <functional>

#include "sightline/viz/render.hpp"
#include "viz/scene_vtk.hpp"

namespace sightline::viz::detail {

/// The window of `show`.
class Window {
public:
    /// `display`: of Xlib; it must outlive the window.
    Window(const DrawList& list, const ShowOptions& options, void* display);
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window();

    /// Opens the window and handles what the user does until it is closed; `each_turn`, when set,
    /// is called once a round.
    void run(const std::function<void()>& each_turn = {});

    [[nodiscard]] vtkRenderWindowInteractor* interactor() const { return interactor_; }
    [[nodiscard]] vtkRenderWindow* window() const { return window_; }
    [[nodiscard]] const VtkPage& page() const noexcept { return page_; }

private:
    void close() { closed_ = true; }
    void fit_to_size();
    void zoomed();

    const DrawList& list_;
    VtkPage page_;
    vtkSmartPointer<vtkRenderWindow> window_;
    vtkSmartPointer<vtkRenderWindowInteractor> interactor_;
    double first_scale_;
    bool closed_ = false;
};

}  // namespace sightline::viz::detail
