// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace sightline::detail {

// One function a part of the library, in the order in which types are needed.
void bind_scene(pybind11::module_& module);
void bind_info(pybind11::module_& module);
void bind_families(pybind11::module_& module);
void bind_graph(pybind11::module_& module);
void bind_view(pybind11::module_& module);
void bind_path(pybind11::module_& module);
void bind_space(pybind11::module_& module);

}  // namespace sightline::detail
