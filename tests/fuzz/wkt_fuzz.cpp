// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/scene_fuzz.hpp"
#include "sightline/scene/wkt.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    return sightline::fuzz::read_make_write_read(
        text, sightline::SceneFormat2::wkt,
        [](std::string_view t, const sightline::ReadOptions& o) {
            return sightline::read_wkt(t, o);
        });
}
