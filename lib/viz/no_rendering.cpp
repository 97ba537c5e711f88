// SPDX-License-Identifier: GPL-3.0-or-later
// What render.hpp promises where VTK was not found.
#ifndef SIGHTLINE_HAS_VTK

#include "sightline/viz/render.hpp"

namespace sightline::viz {
namespace {

tl::unexpected<Error> unavailable(const char* what) {
    return fail(Errc::unsupported, std::string("this build of sightline has no VTK and cannot ") +
                                       what +
                                       "; install libvtk9-dev and build again, or write SVG");
}

}  // namespace

bool has_rendering() noexcept { return false; }

Result<void> render_png(const DrawList& /*list*/, const std::string& /*path*/,
                        const RenderOptions& /*options*/) {
    return unavailable("write PNG");
}

Result<void> show(const DrawList& /*list*/, const ShowOptions& /*options*/) {
    return unavailable("open windows");
}

}  // namespace sightline::viz

#endif
