// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <map>
#include <sstream>

#include "sightline/scene/mesh_io.hpp"

namespace sightline {
namespace {

using Place = CGAL::Simple_cartesian<double>::Point_3;

struct Soup {
    std::vector<Place> points;
    std::vector<std::vector<std::size_t>> polygons;
};

tl::unexpected<Error> refused(const MeshReadOptions& options, const char* format) {
    return fail(Errc::syntax,
                (options.file.empty() ? "" : options.file + ": ") + "cannot be read as " + format +
                    " (the library tells no more); check the file, or convert it to OFF");
}

Result<MeshInput3> to_mesh(const Soup& soup, const MeshReadOptions& options, const char* format) {
    if (soup.points.size() > options.max_elements || soup.polygons.size() > options.max_elements) {
        return fail(Errc::limit_reached, (options.file.empty() ? "" : options.file + ": ") +
                                             "the mesh is larger than the limit; split it");
    }
    MeshInput3 mesh;
    mesh.kind = options.kind;
    mesh.file = options.file;
    for (const Place& p : soup.points) mesh.vertices.push_back({p.x(), p.y(), p.z()});
    for (const auto& polygon : soup.polygons) {
        auto& face = mesh.faces.emplace_back();
        for (const std::size_t v : polygon) {
            if (v >= soup.points.size()) return refused(options, format);
            face.push_back(static_cast<std::uint32_t>(v));
        }
    }
    return mesh;
}

/// One vertex a place.
Soup merged(const Soup& soup) {
    Soup result;
    std::map<Place, std::size_t> number;
    std::vector<std::size_t> new_number;
    for (const Place& p : soup.points) {
        const auto [known, is_new] = number.emplace(p, result.points.size());
        if (is_new) result.points.push_back(p);
        new_number.push_back(known->second);
    }
    for (const auto& polygon : soup.polygons) {
        auto& face = result.polygons.emplace_back();
        for (const std::size_t v : polygon) face.push_back(new_number.at(v));
    }
    return result;
}

template <typename Read>
Result<Soup> read_soup(std::string_view bytes, const MeshReadOptions& options, const char* format,
                       const Read& read) {
    std::istringstream in{std::string(bytes)};
    Soup soup;
    try {
        if (read(in, soup)) return soup;
    } catch (const std::exception&) {
        // Counts that no file has make the library ask for memory that no machine has.
    }
    return refused(options, format);
}

}  // namespace

Result<MeshInput3> read_ply(std::string_view bytes, const MeshReadOptions& options) {
    const Result<Soup> soup = read_soup(bytes, options, "PLY", [](std::istream& in, Soup& into) {
        return CGAL::IO::read_PLY(in, into.points, into.polygons, CGAL::parameters::verbose(false));
    });
    if (!soup) return tl::unexpected(soup.error());
    return to_mesh(*soup, options, "PLY");
}

Result<MeshInput3> read_stl(std::string_view bytes, const MeshReadOptions& options) {
    const Result<Soup> soup = read_soup(bytes, options, "STL", [](std::istream& in, Soup& into) {
        return CGAL::IO::read_STL(in, into.points, into.polygons, CGAL::parameters::verbose(false));
    });
    if (!soup) return tl::unexpected(soup.error());
    // The library merges only vertices of neighbours.
    try {
        return to_mesh(merged(*soup), options, "STL");
    } catch (const std::out_of_range&) {
        return refused(options, "STL");
    }
}

}  // namespace sightline
