// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <tl/expected.hpp>

namespace sightline {

/// What went wrong, for programs; `Error::message` says it for people.
enum class Errc : std::uint8_t {
    // reading
    cannot_open,
    syntax,
    unsupported,
    cannot_write,
    // validation of scenes
    not_finite,
    too_few_vertices,
    repeated_vertex,
    zero_length,
    spike,
    self_intersection,
    body_overlap,
    hole_outside,
    wrong_nesting,
    outside_world,
    wall_crosses_body,
    point_in_body,
    coordinate_too_large,
    empty_scene,
    // validation of meshes
    unknown_vertex,
    degenerate_face,
    non_planar,
    open_surface,
    non_manifold,
    wrong_orientation,
    duplicate_vertex,
    sheet_crosses,
    // questions without an answer
    inside_body,
    outside_of_world,
    unreachable,
    // limits
    limit_reached,
    cancelled,
    // parameters
    bad_parameter,
};

/// Name of an error code, as used in JSON and tests: `repeated_vertex`.
[[nodiscard]] const char* name_of(Errc code) noexcept;

/// A failure: code, and one line for people that names the place (file, line, body, ring, vertex),
/// says what is wrong and what would mend it.
struct Error {
    Errc code{};
    std::string message;

    friend bool operator==(const Error&, const Error&) = default;
};

template <typename T>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> fail(Errc code, std::string message) {
    return tl::unexpected<Error>(Error{code, std::move(message)});
}

/// Bounds on long or large work.
struct Limits {
    /// The work ends with Errc::limit_reached when it would store more elements than this.
    std::size_t max_elements = static_cast<std::size_t>(-1);
    /// Asked now and then, from one thread at a time; returning true ends the work with Errc::cancelled
    /// (or limit_reached when the caller's reason is a limit: the caller knows).
    std::function<bool()> stop;
    /// Told now and then how much of the work is done, from 0 to 1.
    std::function<void(double)> progress;
};

/// A caller's bug. Thrown by SIGHTLINE_EXPECT in every build.
class ContractViolation : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

namespace detail {
[[noreturn]] void contract_violated(const char* condition, const char* file, int line);
}

}  // namespace sightline

#define SIGHTLINE_EXPECT(cond)     \
    ((cond) ? static_cast<void>(0) \
            : ::sightline::detail::contract_violated(#cond, __FILE__, __LINE__))

#ifdef SIGHTLINE_AUDITS
#define SIGHTLINE_AUDIT(cond) SIGHTLINE_EXPECT(cond)
#else
#define SIGHTLINE_AUDIT(cond) static_cast<void>(0)
#endif
