// SPDX-License-Identifier: GPL-3.0-or-later
// Refuses to compile when a public header lets another library's headers through.
// all_headers.hpp is generated: one #include a public header (the opt-in boost_graph.hpp left out).
#include "all_headers.hpp"

#ifdef SIGHTLINE_HYGIENE_LEAK
#include SIGHTLINE_HYGIENE_LEAK
#endif

#if defined(CGAL_VERSION) || defined(CGAL_CONFIG_H) || defined(CGAL_VERSION_H)
#error "leak: CGAL"
#endif
#if defined(BOOST_VERSION) || defined(BOOST_CONFIG_HPP) || defined(BOOST_COMPILER)
#error "leak: Boost"
#endif
#if defined(VTK_MAJOR_VERSION) || defined(VTKABI_H) || defined(vtkSystemIncludes_h) || \
    defined(vtkConfigure_h)
#error "leak: VTK"
#endif
#if defined(TBB_VERSION_MAJOR) || defined(__TBB_version_H)
#error "leak: TBB"
#endif
#if defined(FMT_VERSION)
#error "leak: fmt"
#endif
#if defined(NLOHMANN_JSON_VERSION_MAJOR)
#error "leak: nlohmann-json"
#endif
#if defined(CLI11_VERSION)
#error "leak: CLI11"
#endif

int main() { return 0; }
