// SPDX-License-Identifier: GPL-3.0-or-later
#include "convert.hpp"

#include <gmp.h>

#include <cmath>
#include <string>
#include <utility>

#include "sightline/scene/repair2.hpp"

namespace sightline::detail {
namespace {

// Python's int and GMP's both read and write base 16 in linear time and without a limit on the
// length; decimal text has one in Python.
Rational integer_from(py::handle number) {
    const auto text = py::cast<std::string>(py::str("{:x}").format(number));
    Rational out;
    const bool negative = text.front() == '-';
    const Rational word = Rational(std::uint64_t{1} << 60);
    const std::size_t digits = text.size() - (negative ? 1 : 0);
    for (std::size_t at = negative ? 1 : 0; at < text.size();) {
        const std::size_t count = at == (negative ? 1U : 0U) && digits % 15 != 0 ? digits % 15 : 15;
        out = out * word + Rational(std::stoull(text.substr(at, count), nullptr, 16));
        at += count;
    }
    return negative ? -out : out;
}

py::object integer_to_python(mpz_srcptr number) {
    std::string text(mpz_sizeinbase(number, 16) + 2, '\0');
    mpz_get_str(text.data(), 16, number);
    return py::reinterpret_steal<py::object>(PyLong_FromString(text.c_str(), nullptr, 16));
}

py::object fraction_class() { return py::module_::import("fractions").attr("Fraction"); }

}  // namespace

Rational to_rational(py::handle number) {
    if (PyFloat_Check(number.ptr())) {
        const double value = PyFloat_AsDouble(number.ptr());
        if (!std::isfinite(value)) throw py::value_error("a coordinate has to be finite");
        return Rational(value);
    }
    if (py::isinstance<py::str>(number)) {
        auto parsed = Rational::parse(py::cast<std::string>(number));
        if (!parsed)
            throw py::value_error("not a number such as \"0.1\" or \"-7/3\": " +
                                  py::cast<std::string>(py::repr(number)));
        return *std::move(parsed);
    }
    // float's kin and Decimal have as_integer_ratio; integers of numpy and others are
    // numbers.Rational.
    py::object ratio = py::isinstance<py::bool_>(number)
                           ? py::none()
                           : py::getattr(number, "as_integer_ratio", py::none());
    if (!ratio.is_none()) {
        const py::tuple parts = ratio();
        return integer_from(parts[0]) / integer_from(parts[1]);
    }
    if (!py::hasattr(number, "numerator") || py::isinstance<py::bool_>(number)) {
        throw py::type_error("a coordinate has to be a number, not " +
                             py::cast<std::string>(py::repr(py::type::of(number))));
    }
    return integer_from(number.attr("numerator")) / integer_from(number.attr("denominator"));
}

py::object to_fraction(const Rational& number) {
    return fraction_class()(integer_to_python(mpq_numref(number.mpq())),
                            integer_to_python(mpq_denref(number.mpq())));
}

RationalPoint2 to_point(py::handle pair) {
    if (!py::isinstance<py::iterable>(pair) || py::isinstance<py::str>(pair) ||
        py::len(pair) != 2) {
        throw py::type_error("a point has to be a pair of numbers");
    }
    const py::tuple xy = py::tuple(py::reinterpret_borrow<py::object>(pair));
    return {to_rational(xy[0]), to_rational(xy[1])};
}

py::tuple to_pair(const RationalPoint2& point) {
    return py::make_tuple(to_fraction(point.x), to_fraction(point.y));
}

ScenePointer scene_made_from(const SceneInput2& input, bool mend) {
    if (!mend) {
        auto scene = [&] {
            const py::gil_scoped_release release;
            return Scene2::make(input);
        }();
        return std::make_shared<Scene2>(unwrap(std::move(scene)));
    }
    auto repaired = [&] {
        const py::gil_scoped_release release;
        return repair(input);
    }();
    RepairedScene2 result = unwrap(std::move(repaired));
    const py::object category = py::module_::import("sightline._types").attr("RepairWarning");
    for (const std::string& change : result.changes) {
        if (PyErr_WarnEx(category.ptr(), change.c_str(), 1) != 0) throw py::error_already_set();
    }
    return std::make_shared<Scene2>(std::move(result.scene));
}

Arithmetic arithmetic_from(const std::string& word) {
    if (word == "filtered") return Arithmetic::filtered;
    if (word == "exact") return Arithmetic::exact;
    if (word == "interval") return Arithmetic::interval;
    if (word == "double") return Arithmetic::double_;
    throw py::value_error(
        "arithmetic is \"filtered\", \"exact\", \"interval\" or \"double\", not \"" + word + "\"");
}

py::dict to_dict(const Tally& tally) {
    py::dict out;
    for (std::size_t i = 0; i < static_cast<std::size_t>(Predicate::count_); ++i) {
        const auto predicate = static_cast<Predicate>(i);
        const TierCounts& counts = tally[predicate];
        if (counts.calls == 0) continue;
        py::dict row;
        row["calls"] = counts.calls;
        row["filter"] = counts.filter;
        row["interval"] = counts.interval;
        row["exact"] = counts.exact;
        row["undecided"] = counts.undecided;
        out[py::str(std::string(name_of(predicate)))] = row;
    }
    return out;
}

}  // namespace sightline::detail
