// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/scene/scene3.hpp"

namespace sightline {

/// The formats of meshes.
enum class MeshFormat : std::uint8_t { off, obj, ply, stl };

/// How meshes are read.
struct MeshReadOptions {
    SurfaceKind kind = SurfaceKind::solid;
    /// Named in error messages; the functions that open a file fill it in.
    std::string file = {};
    /// More vertices, faces or corners of faces are refused with Errc::limit_reached.
    std::size_t max_elements = std::size_t{1} << 30;
};

/// The format that a file's name (.off, .obj, .ply, .stl) tells; empty for other names.
[[nodiscard]] std::optional<MeshFormat> mesh_format(std::string_view path);

/// Reads an OFF file. A first word OFF, COFF, NOFF, STOFF and their mixtures; `#` comments; counts of vertices, faces
/// and, possibly, edges; a vertex a line, of which colours, normals and texture coordinates are skipped; a face a
/// line, of any size, what follows its vertices is skipped. Coordinates are the nearest doubles.
///
/// Nothing is checked beyond the syntax and that faces name vertices that exist. Errors (`file:line:column: …`):
/// syntax, unknown_vertex, coordinate_too_large, limit_reached; unsupported for binary files and other dimensions.
[[nodiscard]] Result<MeshInput3> read_off(std::string_view text,
                                          const MeshReadOptions& options = {});

/// Reads an OBJ file: lines `v x y z` and `f …` with corners `v`, `v/vt`, `v//vn` or `v/vt/vn`, negative numbers
/// counting back from the last vertex; a backslash at the end continues a line; all other lines are skipped, so that
/// groups and materials make no difference. Errors as read_off.
[[nodiscard]] Result<MeshInput3> read_obj(std::string_view text,
                                          const MeshReadOptions& options = {});

/// Reads a PLY file, text or binary, through CGAL, which tells no more of an error than that there is one.
/// Numbers of the type `float` have its precision.
[[nodiscard]] Result<MeshInput3> read_ply(std::string_view bytes,
                                          const MeshReadOptions& options = {});

/// Reads an STL file, text or binary, through CGAL; corners at one place become one vertex, in the order in which
/// they come.
[[nodiscard]] Result<MeshInput3> read_stl(std::string_view bytes,
                                          const MeshReadOptions& options = {});

[[nodiscard]] Result<MeshInput3> read_mesh(std::string_view bytes, MeshFormat format,
                                           const MeshReadOptions& options = {});

/// Reads a mesh in the format that the file's name tells, or else its first characters (OFF, ply, solid). Fails with
/// cannot_open or as the reader of the format does.
[[nodiscard]] Result<MeshInput3> read_mesh(const std::string& path,
                                           const MeshReadOptions& options = {});

}  // namespace sightline
