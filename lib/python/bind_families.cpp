// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <vector>

#include "bind.hpp"
#include "convert.hpp"
#include "sightline/scene/families.hpp"

namespace sightline::detail {
namespace {

py::list family_rows() {
    py::list out;
    for (const families::FamilyInfo& family : families::all2()) {
        py::list parameters;
        for (const families::FamilyParameter& p : family.parameters) {
            parameters.append(
                py::make_tuple(std::string(p.name), p.default_value, p.least, p.greatest));
        }
        out.append(py::make_tuple(std::string(family.name), std::string(family.description),
                                  parameters, family.degenerate));
    }
    return out;
}

ScenePointer generated(const std::string& name, const std::vector<std::string>& parameters,
                       std::uint64_t seed) {
    return scene_made_from(unwrap(families::generate2(name, parameters, seed)));
}

}  // namespace

void bind_families(py::module_& module) {
    module.def("_families", &family_rows);
    module.def("_generate", &generated, py::arg("name"), py::arg("parameters"), py::arg("seed"));
}

}  // namespace sightline::detail
