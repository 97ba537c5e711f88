// SPDX-License-Identifier: GPL-3.0-or-later
#include "viz/scene_vtk.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkDefaultPass.h>
#include <vtkGlyph3DMapper.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "viz/space_vtk.hpp"
#include "viz/triangulate.hpp"

namespace sightline::viz::detail {
namespace {

/// Polydata under construction, in pixels with y upwards.
class Mesh {
public:
    /// With a width, lines become areas: OpenGL's own wide lines are thinner when they are slanted.
    explicit Mesh(double z, double line_width = 0) : z_(z), line_width_(line_width) {}

    vtkIdType point(Pixel p) { return points_->InsertNextPoint(p.x, p.y, z_); }
    void line(std::span<const Pixel> chain, bool closed) {
        if (line_width_ > 0) {
            for (std::size_t i = 1; i < chain.size(); ++i) bar(chain[i - 1], chain[i]);
            if (closed) bar(chain.back(), chain.front());
            return;
        }
        const vtkIdType first = points_->GetNumberOfPoints();
        lines_->InsertNextCell(static_cast<int>(chain.size()) + (closed ? 1 : 0));
        for (const Pixel& p : chain) lines_->InsertCellPoint(point(p));
        if (closed) lines_->InsertCellPoint(first);
    }
    void triangle(vtkIdType a, vtkIdType b, vtkIdType c) {
        const vtkIdType corners[] = {a, b, c};
        polys_->InsertNextCell(3, corners);
    }
    void convex(std::span<const Pixel> corners) {
        polys_->InsertNextCell(static_cast<int>(corners.size()));
        for (const Pixel& p : corners) polys_->InsertCellPoint(point(p));
    }
    [[nodiscard]] bool is_empty() const { return points_->GetNumberOfPoints() == 0; }
    [[nodiscard]] vtkSmartPointer<vtkPolyData> data() const {
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points_);
        if (lines_->GetNumberOfCells() > 0) data->SetLines(lines_);
        if (polys_->GetNumberOfCells() > 0) data->SetPolys(polys_);
        return data;
    }

private:
    void bar(Pixel a, Pixel b) {
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (length == 0) return;
        const double x = (b.x - a.x) / length * line_width_ / 2;
        const double y = (b.y - a.y) / length * line_width_ / 2;
        const Pixel corners[] = {
            {a.x - y, a.y + x}, {a.x + y, a.y - x}, {b.x + y, b.y - x}, {b.x - y, b.y + x}};
        convex(corners);
    }

    double z_;
    double line_width_;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> lines_;
    vtkNew<vtkCellArray> polys_;
};

void set_colour(vtkProperty* property, const Colour& c, double opacity) {
    property->SetColor(c.red / 255.0, c.green / 255.0, c.blue / 255.0);
    property->SetOpacity(opacity);
    property->LightingOff();
}

/// Adds what the mapper draws. Everything counts as translucent: then VTK paints in the order of
/// adding and nothing hides what is painted later.
void add_actor(vtkRenderer* renderer, vtkMapper* mapper, const Colour& colour, double opacity,
               double line_width) {
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->ForceTranslucentOn();
    set_colour(actor->GetProperty(), colour, opacity);
    actor->GetProperty()->SetLineWidth(static_cast<float>(line_width));
    renderer->AddActor(actor);
}

/// Lines thinner than a pixel of the window are drawn as one pixel, as much paler.
void add_lines(vtkRenderer* renderer, const Mesh& mesh, const Style& style, double scale) {
    if (mesh.is_empty() || style.width == 0) return;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh.data());
    const double width = style.width * scale;
    add_actor(renderer, mapper, style.colour, style.opacity * std::min(1.0, width),
              std::max(1.0, width));
}

void add_areas(vtkRenderer* renderer, const Mesh& mesh, const Colour& colour, double opacity) {
    if (mesh.is_empty() || opacity == 0) return;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh.data());
    add_actor(renderer, mapper, colour, opacity, 1);
}

/// A marker of size 1 round the origin.
vtkSmartPointer<vtkPolyData> marker_shape(Marker marker) {
    constexpr int corners = 48;
    constexpr double ring_inside = 0.6;
    Mesh mesh(0);
    const auto on_circle = [](int i, double radius) {
        const double angle = 2 * std::numbers::pi * i / corners;
        return Pixel{radius * std::cos(angle), radius * std::sin(angle)};
    };
    const auto bar = [&](double x, double y) {  // one stroke of the cross, from (-x, -y) to (x, y)
        const double w = 0.1;
        mesh.convex(std::vector<Pixel>{{-x - w * y / 0.5, -y + w * x / 0.5},
                                       {-x + w * y / 0.5, -y - w * x / 0.5},
                                       {x + w * y / 0.5, y - w * x / 0.5},
                                       {x - w * y / 0.5, y + w * x / 0.5}});
    };
    switch (marker) {
        case Marker::none:
            break;
        case Marker::square:
            mesh.convex(std::vector<Pixel>{{-.5, -.5}, {.5, -.5}, {.5, .5}, {-.5, .5}});
            break;
        case Marker::diamond:
            mesh.convex(std::vector<Pixel>{{-.5, 0}, {0, -.5}, {.5, 0}, {0, .5}});
            break;
        case Marker::cross:
            bar(0.5, 0.5);
            bar(0.5, -0.5);
            break;
        case Marker::disc: {
            std::vector<Pixel> circle;
            for (int i = 0; i < corners; ++i) circle.push_back(on_circle(i, 0.5));
            mesh.convex(circle);
            break;
        }
        case Marker::ring:
            for (int i = 0; i < corners; ++i) {
                mesh.convex(std::vector<Pixel>{on_circle(i, 0.5 * ring_inside), on_circle(i, 0.5),
                                               on_circle(i + 1, 0.5),
                                               on_circle(i + 1, 0.5 * ring_inside)});
            }
            break;
    }
    return mesh.data();
}

vtkSmartPointer<vtkGlyph3DMapper> add_markers(vtkRenderer* renderer, std::span<const Pixel> places,
                                              double z, Marker marker, double size,
                                              const Colour& colour, double opacity) {
    vtkNew<vtkPoints> points;
    for (const Pixel& p : places) points->InsertNextPoint(p.x, p.y, z);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
    mapper->SetInputData(data);
    mapper->SetSourceData(marker_shape(marker));
    mapper->ScalingOn();
    mapper->SetScaleModeToNoDataScaling();
    mapper->OrientOff();
    mapper->SetScaleFactor(size);
    add_actor(renderer, mapper, colour, opacity, 1);
    return mapper;
}

/// A text whose base line starts at `at`; relative to `anchor` (world coordinates) when there is
/// one.
void add_text(vtkRenderer* renderer, const PlacedText& text, Pixel at, double scale,
              const Pixel* anchor, double depth = 0) {
    constexpr double below_base_line = 0.22;  // of the font size, in the box that VTK aligns
    vtkNew<vtkTextActor> actor;
    actor->SetInput(text.text.c_str());
    vtkTextProperty* property = actor->GetTextProperty();
    property->SetFontFamilyToArial();
    property->SetBold(text.bold ? 1 : 0);
    property->SetFontSize(std::max(1, static_cast<int>(std::lround(text.size * scale))));
    property->SetColor(text.colour.red / 255.0, text.colour.green / 255.0,
                       text.colour.blue / 255.0);
    property->SetJustificationToLeft();
    property->SetVerticalJustificationToBottom();
    vtkCoordinate* position = actor->GetPositionCoordinate();
    position->SetCoordinateSystemToViewport();
    if (anchor != nullptr) {
        property->SetBackgroundColor(1, 1, 1);
        property->SetBackgroundOpacity(0.7);
        vtkNew<vtkCoordinate> world;
        world->SetCoordinateSystemToWorld();
        world->SetValue(anchor->x, anchor->y, depth);
        position->SetReferenceCoordinate(world);
    }
    position->SetValue(at.x * scale, (at.y - below_base_line * text.size) * scale, 0);
    renderer->AddActor2D(actor);
}

std::vector<Pixel> corners_of(const Rectangle& r, double height) {
    return {{r.x, height - r.y - r.height},
            {r.x + r.width, height - r.y - r.height},
            {r.x + r.width, height - r.y},
            {r.x, height - r.y}};
}

void add_sample(vtkRenderer* renderer, const LegendRow& row, double height, double scale) {
    const double middle = height - row.box.y - row.box.height / 2;
    Style style = row.style;
    Mesh line(0);
    if (row.sample == LegendSample::area) {
        Mesh area(0);
        area.convex(corners_of(row.box, height));
        add_areas(renderer, area, style.fill, style.fill_opacity);
        line.line(corners_of(row.box, height), true);
    } else if (row.sample == LegendSample::line) {
        // A nearly invisible line would explain nothing.
        style.opacity = std::max(style.opacity, 0.7);
        style.width = std::max(style.width, 1.0);
        line.line(std::vector<Pixel>{{row.box.x, middle}, {row.box.x + row.box.width, middle}},
                  false);
    }
    add_lines(renderer, line, style, scale);
    if (style.marker != Marker::none) {
        const Pixel at{row.box.x + row.box.width / 2, middle};
        add_markers(renderer, std::span(&at, 1), 0, style.marker, style.marker_size, style.colour,
                    1);
    }
}

/// Looks straight down at a rectangle of the plane.
void look_at(vtkRenderer* renderer, Pixel centre, double height, double depth = 1000) {
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(centre.x, centre.y, 0);
    camera->SetPosition(centre.x, centre.y, depth + 1);
    camera->SetViewUp(0, 1, 0);
    camera->SetParallelScale(height / 2);
    camera->SetClippingRange(1, 2 * depth + 1);
}

}  // namespace

struct VtkPage::Parts {
    Parts(Layout arranged, double pixels_a_unit, bool for_zooming)
        : layout(std::move(arranged)),
          zoomable(for_zooming),
          scale(pixels_a_unit),
          height(layout.height),
          data(layout.data) {}

    Layout layout;
    bool zoomable;
    double scale;
    double height;        ///< of the layout that the drawing's coordinates come from
    Rectangle data;       ///< of that layout
    double depth = 1000;  ///< of everything, before and behind the plane of the picture
    vtkNew<vtkRenderer> page;
    vtkNew<vtkRenderer> drawing;
    std::vector<std::pair<vtkSmartPointer<vtkGlyph3DMapper>, double>>
        markers;  ///< with their sizes

    [[nodiscard]] Pixel upwards(Pixel p) const noexcept { return {p.x, height - p.y}; }
    [[nodiscard]] std::vector<Pixel> pixels(std::span<const Position> points) const {
        std::vector<Pixel> result;
        for (const Position& p : points) result.push_back(upwards(layout.to_pixel(p)));
        return result;
    }
    void fill_page();
    void add_layer(const Layer& layer, double z);
    void add_space(const DrawList& list);
    void add_filled(Mesh& areas, const Polygon& polygon) const;
    void add_labels();
    void place_drawing();
};

void VtkPage::Parts::place_drawing() {
    const auto& [x, y, width, down] = layout.data;
    drawing->SetViewport(x / layout.width, 1 - (y + down) / layout.height,
                         (x + width) / layout.width, 1 - y / layout.height);
}

void VtkPage::Parts::fill_page() {
    const double top = layout.height;
    look_at(page, {layout.width / 2, top / 2}, top);
    Rectangle around = layout.data;
    around = {around.x - 1, around.y - 1, around.width + 2, around.height + 2};
    Mesh frame(0);
    frame.convex(corners_of(around, top));
    add_areas(page, frame, {153, 153, 153}, 1);
    for (const LegendRow& row : layout.legend) add_sample(page, row, top, scale);
    if (layout.scale_bar) {
        const auto [left, right] = *layout.scale_bar;
        const double y = top - left.y;
        Mesh bar(0);
        bar.line(std::vector<Pixel>{{left.x, y}, {right.x, y}}, false);
        for (const double x : {left.x, right.x})
            bar.line(std::vector<Pixel>{{x, y - 4}, {x, y + 4}}, false);
        add_lines(page, bar, {.colour = {40, 40, 40}, .width = 1.5}, scale);
    }
    for (const PlacedText& text : layout.texts) {
        add_text(page, text, {text.at.x, top - text.at.y}, scale, nullptr);
    }
}

void VtkPage::Parts::add_filled(Mesh& areas, const Polygon& polygon) const {
    const Triangles filled = triangulate(polygon);
    std::vector<vtkIdType> corner;
    for (const Pixel& p : pixels(filled.points)) corner.push_back(areas.point(p));
    for (const auto& [a, b, c] : filled.triangles) areas.triangle(corner[a], corner[b], corner[c]);
}

void VtkPage::Parts::add_layer(const Layer& layer, double z) {
    const Style& style = layer.style;
    Mesh areas(z);
    Mesh lines(z, !zoomable && style.width * scale >= 2 ? style.width : 0);
    std::vector<Pixel> joints;
    for (const Polygon& polygon : layer.polygons) {
        if (style.fill_opacity > 0) add_filled(areas, polygon);
        lines.line(pixels(polygon.outer), true);
        for (const auto& hole : polygon.holes) lines.line(pixels(hole), true);
    }
    for (const Polyline& line : layer.polylines) {
        const std::vector<Pixel> chain = pixels(line.points);
        lines.line(chain, false);
        joints.insert(joints.end(), chain.begin(), chain.end());
    }
    for (std::size_t i = 0; i + 1 < layer.segments.size(); i += 2) {
        lines.line(pixels(std::span(layer.segments).subspan(i, 2)), false);
    }
    add_areas(drawing, areas, style.fill, style.fill_opacity);
    add_lines(drawing, lines, style, scale);
    const auto mark = [&](std::span<const Pixel> places, Marker marker, double size) {
        markers.emplace_back(
            add_markers(drawing, places, z, marker, size, style.colour, style.opacity), size);
    };
    // Round joints and ends: wide lines of OpenGL have gaps at turns.
    if (!joints.empty() && style.width >= 2 && style.opacity == 1)
        mark(joints, Marker::disc, style.width);
    if (!layer.points.empty() && style.marker != Marker::none) {
        mark(pixels(layer.points), style.marker, style.marker_size);
    }
}

void VtkPage::Parts::add_space(const DrawList& list) {
    const auto to_world = [this](const Position& p) {
        const Pixel at = upwards(layout.to_pixel(p));
        return Position{at.x, at.y, layout.depth(p)};
    };
    depth = std::max(1.0, detail::add_space(drawing, list, to_world, {scale, zoomable}));
}

void VtkPage::Parts::add_labels() {
    for (const PlacedText& label : layout.labels) {
        const Pixel anchor = upwards(label.anchor);
        const Pixel at = upwards(label.at);
        add_text(drawing, label, {at.x - anchor.x, at.y - anchor.y}, scale, &anchor,
                 label.anchor_depth);
    }
}

VtkPage::VtkPage(const DrawList& list, Layout layout, double scale, bool zoomable)
    : parts_(std::make_unique<Parts>(std::move(layout), scale, zoomable)) {
    for (vtkRenderer* renderer : {page(), drawing()}) {
        renderer->SetBackground(1, 1, 1);
        if (list.camera && renderer == drawing()) continue;
        // VTK's own way with translucent things mixes their colours without an order.
        vtkNew<vtkDefaultPass> in_order;
        vtkNew<vtkCameraPass> pass;
        pass->SetDelegatePass(in_order);
        renderer->SetPass(pass);
    }
    parts_->fill_page();
    if (list.camera) {
        parts_->add_space(list);
    } else {
        double z = 0;
        for (const Layer& layer : list.layers) parts_->add_layer(layer, z++);
    }
    parts_->add_labels();
    parts_->place_drawing();
    reset_camera();
}

VtkPage::~VtkPage() = default;

vtkRenderer* VtkPage::page() const { return parts_->page; }
vtkRenderer* VtkPage::drawing() const { return parts_->drawing; }
const Layout& VtkPage::layout() const noexcept { return parts_->layout; }

void VtkPage::magnify(double factor) {
    for (const auto& [mapper, size] : parts_->markers) mapper->SetScaleFactor(size / factor);
}

void VtkPage::rearrange(Layout layout) {
    parts_->layout = std::move(layout);
    parts_->page->RemoveAllViewProps();
    parts_->fill_page();
    parts_->place_drawing();
}

void VtkPage::reset_camera() {
    const Rectangle& data = parts_->data;
    look_at(drawing(), parts_->upwards({data.x + data.width / 2, data.y + data.height / 2}),
            data.height, parts_->depth);
    magnify(1);
}

}  // namespace sightline::viz::detail
