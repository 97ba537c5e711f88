// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <string>

#include "sightline/scene/result.hpp"

namespace sightline::viz::detail {

/// An X server of our own without a screen (Xvfb), as long as the object lives.
class Xvfb {
public:
    /// Returns when the server accepts connections. Fails with `unsupported` when there is none.
    [[nodiscard]] static Result<Xvfb> start();
    Xvfb(Xvfb&& other) noexcept;
    Xvfb& operator=(Xvfb&& other) = delete;
    /// Ends the server and waits for its end.
    ~Xvfb();

    /// As in DISPLAY: ":99".
    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    [[nodiscard]] pid_t process() const noexcept { return process_; }

private:
    Xvfb(pid_t process, std::string name) : process_(process), name_(std::move(name)) {}

    pid_t process_;
    std::string name_;
};

/// A connection to an X server that can draw with OpenGL.
class XConnection {
public:
    /// Empty name: what DISPLAY says. Fails with `unsupported` when nobody answers there.
    [[nodiscard]] static Result<XConnection> open(const std::string& name);
    XConnection(XConnection&& other) noexcept;
    XConnection& operator=(XConnection&& other) = delete;
    ~XConnection();

    /// The `Display*` of Xlib.
    [[nodiscard]] void* handle() const noexcept { return handle_; }

private:
    explicit XConnection(void* handle) : handle_(handle) {}

    void* handle_;
};

}  // namespace sightline::viz::detail
