// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkGlyph3DMapper.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <span>
#include <vector>

#include "viz/layout.hpp"

/// A draw list as VTK renderers: one for the drawing, cut off at its frame, and one behind it for
/// title, legend and frame. World coordinates are the pixels of the layout with y upwards.
namespace sightline::viz::detail {

class VtkPage {
public:
    /// `scale` pixels of the window are one of the layout.
    VtkPage(const DrawList& list, Layout layout, double scale);

    [[nodiscard]] vtkRenderer* page() const { return page_; }
    [[nodiscard]] vtkRenderer* drawing() const { return drawing_; }
    [[nodiscard]] const Layout& layout() const noexcept { return layout_; }

    /// Sizes markers for a drawing magnified so many times.
    void magnify(double factor);
    /// Puts title, legend and frame where another window size wants them; the drawing's things
    /// stay.
    void rearrange(Layout layout);
    /// The whole drawing, as large as fits.
    void reset_camera();

private:
    [[nodiscard]] Pixel upwards(Pixel p) const noexcept { return {p.x, height_ - p.y}; }
    void fill_page();
    void fill_drawing(const DrawList& list);
    void place_drawing();

    Layout layout_;
    double scale_;
    double height_;   ///< of the layout that the drawing's coordinates come from
    Rectangle data_;  ///< of that layout
    vtkSmartPointer<vtkRenderer> page_;
    vtkSmartPointer<vtkRenderer> drawing_;
    std::vector<std::pair<vtkSmartPointer<vtkGlyph3DMapper>, double>>
        markers_;  ///< with their sizes
};

}  // namespace sightline::viz::detail
