// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>

#include "fuzz/scene_fuzz.hpp"
#include "sightline/scene/mesh_io.hpp"
#include "sightline/scene/off.hpp"

namespace sightline::fuzz {

/// Whatever the bytes: reading ends in an error of one line, or in a mesh that makes a scene or not; a mesh,
/// written as OFF and read again, is the same mesh.
template <typename Read>
int read_make_write_read_mesh(std::string_view text, const Read& read) {
    MeshReadOptions options;
    options.max_elements = 1U << 20;
    if (!text.empty() && text.back() == '\n') options.kind = SurfaceKind::sheet;
    const Result<MeshInput3> mesh = read(text, options);
    if (!mesh) {
        check_error(mesh.error());
        return 0;
    }
    SceneInput3 input;
    input.meshes = {*mesh};
    const Result<Scene3> scene = Scene3::make(input);
    if (!scene) {
        check_error(scene.error());
        return 0;
    }
    std::ostringstream out;
    write_off(out, input);
    const Result<MeshInput3> again = read_off(out.str());
    if (!again) complain(again.error().message.c_str(), out.str());
    if (again->vertices != mesh->vertices || again->faces != mesh->faces)
        complain("another mesh was read back", out.str());
    return 0;
}

}  // namespace sightline::fuzz
