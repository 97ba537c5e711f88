// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <exception>

#include "bind.hpp"
#include "convert.hpp"

namespace py = pybind11;

namespace sightline::detail {
namespace {

// Errors are Python classes of our own, so that code and message can be read: sightline/_types.py.
void translate_errors(std::exception_ptr pointer) {
    try {
        if (pointer) std::rethrow_exception(pointer);
    } catch (const Failure& failure) {
        const py::object type = py::module_::import("sightline._types").attr("SightlineError");
        const py::object error = type(name_of(failure.error.code), failure.error.message);
        PyErr_SetObject(type.ptr(), error.ptr());
    } catch (const ContractViolation& violation) {
        const py::object type = py::module_::import("sightline._types").attr("ContractViolation");
        PyErr_SetString(type.ptr(), violation.what());
    }
}

}  // namespace
}  // namespace sightline::detail

PYBIND11_MODULE(_core, module) {
    module.doc() = "Bindings of the C++ library; use them through `sightline`.";
    module.attr("__version__") = SIGHTLINE_VERSION;
    py::register_exception_translator(&sightline::detail::translate_errors);
    sightline::detail::bind_scene(module);
    sightline::detail::bind_info(module);
    sightline::detail::bind_families(module);
    sightline::detail::bind_graph(module);
    sightline::detail::bind_view(module);
    sightline::detail::bind_path(module);
    sightline::detail::bind_space(module);
}
