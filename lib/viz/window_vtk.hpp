// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "sightline/viz/render.hpp"
#include "viz/scene_vtk.hpp"

class vtkRenderWindow;
class vtkRenderWindowInteractor;

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

    [[nodiscard]] vtkRenderWindowInteractor* interactor() const;
    [[nodiscard]] vtkRenderWindow* window() const;
    [[nodiscard]] const VtkPage& page() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace sightline::viz::detail
