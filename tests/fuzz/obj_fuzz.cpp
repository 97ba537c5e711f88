// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/mesh_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    return sightline::fuzz::read_make_write_read_mesh(
        text, [](std::string_view t, const sightline::MeshReadOptions& o) {
            return sightline::read_obj(t, o);
        });
}
