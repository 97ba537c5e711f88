// SPDX-License-Identifier: GPL-3.0-or-later
#include "viz/space_vtk.hpp"

#include <vtkActor.h>
#include <vtkCameraPass.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDefaultPass.h>
#include <vtkGlyph3DMapper.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "viz/vector_math.hpp"

namespace sightline::viz::detail {
namespace {

/// Triangles and lines with a colour each.
struct Mesh {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkCellArray> polys;
    vtkNew<vtkUnsignedCharArray> colours;

    Mesh() { colours->SetNumberOfComponents(4); }
    vtkIdType point(const Position& p) { return points->InsertNextPoint(p.x, p.y, p.z); }
    void polygon(std::span<const Position> corners, const Colour& colour, double opacity) {
        polys->InsertNextCell(static_cast<int>(corners.size()));
        for (const Position& p : corners) polys->InsertCellPoint(point(p));
        paint(colour, opacity);
    }
    void line(const Position& a, const Position& b, const Colour& colour, double opacity) {
        lines->InsertNextCell(2);
        lines->InsertCellPoint(point(a));
        lines->InsertCellPoint(point(b));
        paint(colour, opacity);
    }

private:
    void paint(const Colour& colour, double opacity) {
        colours->InsertNextTuple4(colour.red, colour.green, colour.blue, std::round(255 * opacity));
    }
};

/// A small triangle of something translucent.
struct Pane {
    std::array<Position, 3> corners;
    Colour colour;
    double opacity;

    [[nodiscard]] double depth() const { return corners[0].z + corners[1].z + corners[2].z; }
};

/// Translucent things are mixed rightly when they are painted from back to front; small triangles can
/// be sorted by their centres.
class Panes {
public:
    void add(std::span<const Position> convex, const Colour& colour, double opacity) {
        for (std::size_t i = 2; i < convex.size(); ++i) {
            split({{convex[0], convex[i - 1], convex[i]}, colour, opacity});
        }
    }
    void paint(Mesh& mesh) {
        std::ranges::stable_sort(panes_, {}, &Pane::depth);
        for (const Pane& pane : panes_) mesh.polygon(pane.corners, pane.colour, pane.opacity);
    }

private:
    static constexpr double largest_side = 32;  // pixels

    void split(const Pane& pane) {
        const auto& [a, b, c] = pane.corners;
        const std::array sides{dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)};
        const auto longest =
            static_cast<std::size_t>(std::ranges::max_element(sides) - sides.begin());
        if (!(sides[longest] > largest_side * largest_side) || panes_.size() > largest_number) {
            panes_.push_back(pane);
            return;
        }
        const std::size_t next = (longest + 1) % 3;
        const Position middle = 0.5 * (pane.corners[longest] + pane.corners[next]);
        Pane first = pane;
        Pane second = pane;
        first.corners[next] = middle;
        second.corners[longest] = middle;
        split(first);
        split(second);
    }

    static constexpr std::size_t largest_number = 2'000'000;
    std::vector<Pane> panes_;
};

Colour scaled(const Colour& colour, double by) {
    const auto channel = [by](std::uint8_t c) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(c * by, 0.0, 255.0)));
    };
    return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

/// Adds one layer after the other.
class Space {
public:
    Space(vtkRenderer* renderer, const std::function<Position(const Position&)>& to_world,
          const SpaceOptions& options)
        : renderer_(renderer), to_world_(to_world), options_(options) {}

    void add(const Layer& layer) {
        lift_ += 0.2;  // of two lines at one place the later layer's is seen
        add_polygons(layer);
        add_lines(layer);
        add_balls(layer);
    }
    void finish() {
        Mesh mesh;
        panes_.paint(mesh);
        add_actor(mesh, 1, true, true);
    }
    [[nodiscard]] double farthest() const { return farthest_; }

private:
    [[nodiscard]] Position at(const Position& p) {
        const Position w = to_world_(p);
        farthest_ = std::max(farthest_, std::abs(w.z) + 20);
        return w;
    }

    void add_polygons(const Layer& layer) {
        if (layer.style.fill_opacity <= 0) return;
        Mesh mesh;
        std::vector<Position> corners;
        for (const Polygon& polygon : layer.polygons) {
            corners.clear();
            for (const Position& p : polygon.outer) corners.push_back(at(p));
            if (corners.size() < 3) continue;
            const Position normal =
                unit(cross(corners[1] - corners[0], corners.back() - corners[0]));
            add_area(mesh, corners, scaled(layer.style.fill, 0.62 + 0.42 * brightness(normal)),
                     layer.style.fill_opacity);
        }
        // Lines in a face would be half hidden by it.
        add_actor(mesh, 1, true, layer.style.fill_opacity < 1);
    }

    void add_area(Mesh& mesh, std::span<const Position> corners, const Colour& colour,
                  double opacity) {
        if (opacity < 1 && !options_.zoomable) {
            panes_.add(corners, colour, opacity);
        } else {
            mesh.polygon(corners, colour, opacity);
        }
    }

    void add_lines(const Layer& layer) {
        const Style& style = layer.style;
        if (style.width <= 0) return;
        Mesh mesh;
        const auto line = [&](const Position& a, const Position& b) {
            add_line(mesh, at(a), at(b), style);
        };
        for (const Polygon& polygon : layer.polygons) {
            for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
                line(polygon.outer[i], polygon.outer[(i + 1) % polygon.outer.size()]);
            }
        }
        for (const Polyline& chain : layer.polylines) {
            for (std::size_t i = 1; i < chain.points.size(); ++i) {
                line(chain.points[i - 1], chain.points[i]);
            }
        }
        for (std::size_t i = 0; i + 1 < layer.segments.size(); i += 2) {
            line(layer.segments[i], layer.segments[i + 1]);
        }
        add_actor(mesh, std::max(1.0, style.width * options_.scale), false, style.opacity < 1);
    }

    void add_line(Mesh& mesh, Position a, Position b, const Style& style) {
        if (options_.zoomable) return mesh.line(a, b, style.colour, style.opacity);
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (length == 0) return;
        const double half = style.width / 2;
        const double x = (b.x - a.x) / length * half;
        const double y = (b.y - a.y) / length * half;
        for (Position* p : {&a, &b}) p->z += lift_ + half;
        const double end = std::min(half, 1.0) / half;  // square ends close the corners
        a = a - Position{x * end, y * end, 0};
        b = b + Position{x * end, y * end, 0};
        const Position corners[] = {{a.x - y, a.y + x, a.z},
                                    {a.x + y, a.y - x, a.z},
                                    {b.x + y, b.y - x, b.z},
                                    {b.x - y, b.y + x, b.z}};
        add_area(mesh, corners, style.colour, style.opacity);
    }

    void add_balls(const Layer& layer) {
        if (layer.points.empty() || layer.style.marker == Marker::none) return;
        vtkNew<vtkPoints> points;
        for (const Position& p : layer.points) {
            const Position w = at(p);
            points->InsertNextPoint(w.x, w.y, w.z + lift_ + layer.style.marker_size / 4);
        }
        vtkNew<vtkPolyData> data;
        data->SetPoints(points);
        vtkNew<vtkSphereSource> ball;
        ball->SetRadius(layer.style.marker_size / 2);
        ball->SetThetaResolution(32);
        ball->SetPhiResolution(16);
        vtkNew<vtkGlyph3DMapper> mapper;
        mapper->SetInputData(data);
        mapper->SetSourceConnection(ball->GetOutputPort());
        mapper->ScalingOff();
        mapper->OrientOff();
        mapper->ScalarVisibilityOff();
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        const Colour& c = layer.style.colour;
        actor->GetProperty()->SetColor(c.red / 255.0, c.green / 255.0, c.blue / 255.0);
        actor->GetProperty()->LightingOff();
        renderer_->AddActor(actor);
    }

    void add_actor(const Mesh& mesh, double line_width, bool behind_lines, bool translucent) {
        if (mesh.points->GetNumberOfPoints() == 0) return;
        vtkNew<vtkPolyData> data;
        data->SetPoints(mesh.points);
        if (mesh.lines->GetNumberOfCells() > 0) data->SetLines(mesh.lines);
        if (mesh.polys->GetNumberOfCells() > 0) data->SetPolys(mesh.polys);
        data->GetCellData()->SetScalars(mesh.colours);
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(data);
        mapper->SetScalarModeToUseCellData();
        mapper->SetColorModeToDirectScalars();
        if (behind_lines) {
            mapper->SetResolveCoincidentTopologyToPolygonOffset();
            // Translucent things in an opaque face are seen.
            const double factor = translucent ? 1 : 3;
            mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(factor * options_.scale,
                                                                         translucent ? 1 : 4);
        }
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        if (translucent) {
            actor->ForceTranslucentOn();
        } else {
            actor->ForceOpaqueOn();
        }
        actor->GetProperty()->SetLineWidth(static_cast<float>(line_width));
        actor->GetProperty()->LightingOff();
        renderer_->AddActor(actor);
    }

    Panes panes_;
    vtkRenderer* renderer_;
    const std::function<Position(const Position&)>& to_world_;
    SpaceOptions options_;
    double lift_ = 0;
    double farthest_ = 0;
};

}  // namespace

double brightness(const Position& normal) {
    const Position light = unit({-0.28, 0.45, 0.85});
    const Position towards_eye = normal.z < 0 ? -1.0 * normal : normal;
    return std::max(0.0, dot(towards_eye, light));
}

double add_space(vtkRenderer* renderer, const DrawList& list,
                 const std::function<Position(const Position&)>& to_world,
                 const SpaceOptions& options) {
    if (options.zoomable) {
        // What is behind changes as the camera turns.
        renderer->SetUseDepthPeeling(1);
        renderer->SetMaximumNumberOfPeels(8);
        renderer->SetOcclusionRatio(0.001);
    } else {
        vtkNew<vtkDefaultPass> in_order;
        vtkNew<vtkCameraPass> pass;
        pass->SetDelegatePass(in_order);
        renderer->SetPass(pass);
    }
    Space space(renderer, to_world, options);
    for (const Layer& layer : list.layers) space.add(layer);
    space.finish();
    return space.farthest();
}

}  // namespace sightline::viz::detail
