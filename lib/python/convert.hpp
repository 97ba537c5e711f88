// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How numbers, points, ids and failures cross the border between Python and C++.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/rational.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/geom/point.hpp"
#include "sightline/scene/id.hpp"
#include "sightline/scene/result.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::detail {

namespace py = pybind11;

/// How Python holds a scene.
using ScenePointer = std::shared_ptr<Scene2>;

/// A library error on its way to becoming sightline.SightlineError.
struct Failure {
    Error error;
};

/// The value, or a Python exception.
template <typename T>
T unwrap(Result<T>&& result) {
    if (!result) throw Failure{std::move(result).error()};
    return std::move(result).value();
}

/// Exactly the number that a Python object is: float, int, Fraction, Decimal, numpy scalar, or text
/// ("0.1", "1/3"). Raises ValueError or OverflowError for NaN and infinity, TypeError for what is
/// no number.
Rational to_rational(py::handle number);

/// The scene, or SightlineError. With `mend`, repaired first; each change is a RepairWarning.
ScenePointer scene_made_from(const SceneInput2& input, bool mend = false);

/// fractions.Fraction, whatever the size.
py::object to_fraction(const Rational& number);

/// A pair of numbers.
RationalPoint2 to_point(py::handle pair);

/// (Fraction, Fraction)
py::tuple to_pair(const RationalPoint2& point);

/// The arithmetic that a word names; ValueError for other words.
Arithmetic arithmetic_from(const std::string& word);

/// {predicate: {calls, filter, interval, exact, undecided}}, predicates that were called only.
py::dict to_dict(const Tally& tally);

/// Numbers of ids.
template <typename IdType>
py::array_t<std::uint32_t> to_array(const std::vector<IdType>& ids) {
    py::array_t<std::uint32_t> out(static_cast<py::ssize_t>(ids.size()));
    std::uint32_t* next = out.mutable_data();
    for (const IdType id : ids) *next++ = id.value;
    return out;
}

/// A read-only (n, 2) array that shares the memory of a C++ sequence of pairs; `owner` keeps it
/// alive.
template <typename Number>
py::array_t<Number> view_of_pairs(const void* data, std::size_t n, py::handle owner) {
    py::array_t<Number> view({static_cast<py::ssize_t>(n), py::ssize_t{2}},
                             static_cast<const Number*>(data), owner);
    view.attr("flags").attr("writeable") = false;
    return view;
}

/// Runs `work(limits)` on a thread of its own without the GIL, while this thread looks out for
/// Ctrl-C: then `limits.stop` says so, and KeyboardInterrupt is raised when the work has ended.
/// Python runs signal handlers on its main thread only, so the work can't look out itself.
template <typename Work>
auto interruptible(Work work) {
    std::atomic<bool> stop = false;
    Limits limits;
    limits.stop = [&stop] { return stop.load(std::memory_order_relaxed); };
    bool interrupted = false;
    auto result = [&] {
        const py::gil_scoped_release release;
        auto future = std::async(std::launch::async, [&] { return work(limits); });
        while (future.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready) {
            if (interrupted) continue;
            const py::gil_scoped_acquire acquire;
            if (PyErr_CheckSignals() != 0) {
                interrupted = true;
                stop = true;
            }
        }
        return future.get();
    }();
    if (interrupted) throw py::error_already_set();
    return result;
}

}  // namespace sightline::detail
