// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/vtk_file.hpp"

#include <fmt/format.h>

#include <cstring>
#include <iterator>
#include <ostream>
#include <span>
#include <unordered_map>

#include "viz/text.hpp"
#include "viz/triangulate.hpp"

namespace sightline::viz {
namespace {

struct PositionHash {
    std::size_t operator()(const Position& p) const noexcept {
        std::size_t h = 0;
        for (const double x : {p.x, p.y, p.z})
            h = (h ^ std::hash<double>{}(x)) * 0x9E3779B97F4A7C15U;
        return h ^ (h >> 32U);
    }
};

/// Cells of one kind: verts, lines or polys.
struct Cells {
    std::vector<std::uint32_t> connectivity;
    std::vector<std::size_t> offsets;
    std::vector<std::size_t> layers;
    std::vector<std::size_t> ids;
};

class PolyData {
public:
    explicit PolyData(const DrawList& list) : in_space_(list.camera.has_value()) {
        for (std::size_t i = 0; i < list.layers.size(); ++i) add(list.layers[i], i);
    }

    std::vector<Position> points;
    Cells verts;
    Cells lines;
    Cells polys;

private:
    std::uint32_t index(const Position& p) {
        const auto [found, is_new] =
            places_.try_emplace(p, static_cast<std::uint32_t>(points.size()));
        if (is_new) points.push_back(p);
        return found->second;
    }

    void add_cell(Cells& cells, std::span<const Position> corners, std::size_t layer,
                  std::size_t id, bool closed = false) {
        if (corners.empty()) return;
        for (const Position& p : corners) cells.connectivity.push_back(index(p));
        if (closed) cells.connectivity.push_back(index(corners.front()));
        cells.offsets.push_back(cells.connectivity.size());
        cells.layers.push_back(layer);
        cells.ids.push_back(id);
    }

    void add(const Layer& layer, std::size_t number) {
        for (std::size_t i = 0; i < layer.points.size(); ++i) {
            add_cell(verts, std::span(layer.points).subspan(i, 1), number, i);
        }
        for (std::size_t i = 0; 2 * i + 1 < layer.segments.size(); ++i) {
            add_cell(lines, std::span(layer.segments).subspan(2 * i, 2), number, i);
        }
        for (const Polyline& line : layer.polylines) add_cell(lines, line.points, number, line.id);
        for (const Polygon& polygon : layer.polygons) {
            if (layer.style.width > 0) {
                add_cell(lines, polygon.outer, number, polygon.id, true);
                for (const auto& hole : polygon.holes)
                    add_cell(lines, hole, number, polygon.id, true);
            }
            if (layer.style.fill_opacity > 0) add_triangles(polygon, number);
        }
    }

    void add_triangles(const Polygon& polygon, std::size_t number) {
        if (in_space_) return add_fan(polygon, number);
        const detail::Triangles filled = detail::triangulate(polygon);
        for (const auto& [a, b, c] : filled.triangles) {
            const Position corners[] = {filled.points[a], filled.points[b], filled.points[c]};
            add_cell(polys, corners, number, polygon.id);
        }
    }

    /// Of a convex polygon.
    void add_fan(const Polygon& polygon, std::size_t number) {
        const auto& p = polygon.outer;
        for (std::size_t i = 2; i < p.size(); ++i) {
            const Position corners[] = {p[0], p[i - 1], p[i]};
            add_cell(polys, corners, number, polygon.id);
        }
    }

    bool in_space_;
    std::unordered_map<Position, std::uint32_t, PositionHash> places_;
};

template <typename... Ranges>
void write_array(std::ostream& out, const char* attributes, const Ranges&... numbers) {
    out << "<DataArray " << attributes << " format=\"ascii\">\n";
    fmt::memory_buffer text;
    std::size_t on_line = 0;
    const auto write = [&](const auto& range) {
        for (const auto& n : range) {
            fmt::format_to(std::back_inserter(text), "{}{}", n, ++on_line % 12 == 0 ? '\n' : ' ');
        }
    };
    (write(numbers), ...);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out << "\n</DataArray>\n";
}

void write_cells(std::ostream& out, const char* name, const Cells& cells) {
    out << '<' << name << ">\n";
    write_array(out, R"(type="Int64" Name="connectivity")", cells.connectivity);
    write_array(out, R"(type="Int64" Name="offsets")", cells.offsets);
    out << "</" << name << ">\n";
}

/// Names as the format wants strings: the codes of their bytes, each name ended by a zero.
void write_names(std::ostream& out, const DrawList& list) {
    out << "<FieldData>\n<Array type=\"String\" Name=\"layers\" NumberOfTuples=\""
        << list.layers.size() << "\" format=\"ascii\">\n";
    for (const Layer& layer : list.layers) {
        for (const char c : layer.name)
            out << static_cast<int>(static_cast<unsigned char>(c)) << ' ';
        out << "0\n";
    }
    out << "</Array>\n</FieldData>\n";
}

/// The list with one of its layers only.
DrawList only(const DrawList& list, const Layer& layer) {
    DrawList part;
    part.camera = list.camera;
    part.layers.push_back(layer);
    return part;
}

}  // namespace

std::vector<std::string> vtm_parts(const DrawList& list, const std::string& stem) {
    std::vector<std::string> names;
    for (const Layer& layer : list.layers) {
        std::string name = layer.name;
        for (char& c : name) {
            const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                                  (c >= '0' && c <= '9') || c == '-';
            if (!is_plain) c = '_';
        }
        names.push_back(fmt::format("{}_{}_{}.vtp", stem, names.size(), name));
    }
    return names;
}

void write_vtm(const DrawList& list, const std::string& stem, std::ostream& out) {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\" "
           "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<vtkMultiBlockDataSet>\n";
    const std::vector<std::string> parts = vtm_parts(list, stem);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        out << fmt::format("<DataSet index=\"{}\" name=\"{}\" file=\"{}\"/>\n", i,
                           detail::xml_text(list.layers[i].name), detail::xml_text(parts[i]));
    }
    out << "</vtkMultiBlockDataSet>\n</VTKFile>\n";
}

void write_vtm_part(const DrawList& list, std::size_t part, std::ostream& out) {
    write_vtp(only(list, list.layers.at(part)), out);
}

void write_vtp(const DrawList& list, std::ostream& out) {
    const PolyData data(list);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
           "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n";
    write_names(out, list);
    out << fmt::format(
        "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
        "NumberOfStrips=\"0\" "
        "NumberOfPolys=\"{}\">\n",
        data.points.size(), data.verts.offsets.size(), data.lines.offsets.size(),
        data.polys.offsets.size());
    std::vector<double> coordinates;
    coordinates.reserve(3 * data.points.size());
    for (const Position& p : data.points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
    out << "<Points>\n";
    write_array(out, R"(type="Float64" Name="Points" NumberOfComponents="3")", coordinates);
    out << "</Points>\n<CellData Scalars=\"layer\">\n";
    write_array(out, R"(type="Int64" Name="layer")", data.verts.layers, data.lines.layers,
                data.polys.layers);
    write_array(out, R"(type="Int64" Name="id")", data.verts.ids, data.lines.ids, data.polys.ids);
    out << "</CellData>\n";
    write_cells(out, "Verts", data.verts);
    write_cells(out, "Lines", data.lines);
    write_cells(out, "Polys", data.polys);
    out << "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace sightline::viz
