// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "viz/layout.hpp"

class vtkRenderer;

/// A draw list as VTK renderers: one for the drawing, cut off at its frame, and one behind it for
/// title, legend and frame. World coordinates are the pixels of the layout with y upwards.
namespace sightline::viz::detail {

class VtkPage {
public:
    /// `scale` pixels of the window are one of the layout. When `zoomable`, lines keep their width.
    VtkPage(const DrawList& list, Layout layout, double scale, bool zoomable);
    VtkPage(const VtkPage&) = delete;
    VtkPage& operator=(const VtkPage&) = delete;
    ~VtkPage();

    [[nodiscard]] vtkRenderer* page() const;
    [[nodiscard]] vtkRenderer* drawing() const;
    [[nodiscard]] const Layout& layout() const noexcept;

    /// Sizes markers for a drawing magnified so many times.
    void magnify(double factor);
    /// Puts title, legend and frame where another window size wants them; the drawing's things stay.
    void rearrange(Layout layout);
    /// The whole drawing, as large as fits.
    void reset_camera();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace sightline::viz::detail
