// SPDX-License-Identifier: GPL-3.0-or-later
#include "viz/x_display.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

extern char** environ;  // NOLINT: posix_spawn's way

namespace sightline::viz::detail {
namespace {

constexpr const char* advice =
    "install xvfb (apt-get install xvfb), set DISPLAY to a running X server, or write SVG";

/// A pipe whose ends close themselves and are not inherited.
struct Pipe {
    std::array<int, 2> ends{-1, -1};

    Pipe() { [[maybe_unused]] const int failed = ::pipe2(ends.data(), O_CLOEXEC); }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        close(0);
        close(1);
    }
    void close(std::size_t end) {
        if (ends[end] >= 0) ::close(std::exchange(ends[end], -1));
    }
};

/// Starts Xvfb, which will write the number of its display to `out`. Returns an errno.
int spawn(int out, pid_t& process) {
    constexpr int reported_on = 3;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, out, reported_on);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);

    // Its own process group: Ctrl-C is for us, and it must outlive our cleaning up. An ignored
    // SIGUSR1 would make it signal us.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigset_t standard;
    sigemptyset(&none);
    sigemptyset(&standard);
    for (const int signal : {SIGUSR1, SIGTERM, SIGINT, SIGHUP}) sigaddset(&standard, signal);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &standard);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(
        &attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);

    // -terminate: it ends by itself when our connection does, should we be killed.
    std::array<const char*, 11> arguments{"Xvfb",       "-displayfd",   "3",         "-screen",
                                          "0",          "1280x1024x24", "-nolisten", "tcp",
                                          "-terminate", nullptr,        nullptr};
    const int error = posix_spawnp(&process, "Xvfb", &actions, &attributes,
                                   const_cast<char* const*>(arguments.data()), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

/// What comes out of `in` up to the first line break; empty when it ends before or nothing comes
/// for long.
std::string read_line(int in) {
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::seconds(30);
    std::string line;
    while (true) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
        pollfd wanted{in, POLLIN, 0};
        const int ready =
            left.count() <= 0 ? 0 : ::poll(&wanted, 1, static_cast<int>(left.count()));
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) return {};
        char c = 0;
        const ssize_t got = ::read(in, &c, 1);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return {};
        if (c == '\n') return line;
        line += c;
    }
}

void end(pid_t process) {
    ::kill(process, SIGTERM);
    while (::waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
}

/// Xlib, which VTK brings along, without its headers and their macros.
class Xlib {
public:
    static const Xlib& get() {
        static const Xlib library;
        return library;
    }
    void* (*open)(const char*) = nullptr;
    int (*close)(void*) = nullptr;
    int (*query_extension)(void*, const char*, int*, int*, int*) = nullptr;

private:
    Xlib() {
        void* library = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
        if (library == nullptr) return;
        open = reinterpret_cast<decltype(open)>(::dlsym(library, "XOpenDisplay"));
        close = reinterpret_cast<decltype(close)>(::dlsym(library, "XCloseDisplay"));
        query_extension =
            reinterpret_cast<decltype(query_extension)>(::dlsym(library, "XQueryExtension"));
    }
};

}  // namespace

Result<Xvfb> Xvfb::start() {
    Pipe pipe;
    pid_t process = -1;
    if (pipe.ends[0] < 0) {
        return fail(Errc::unsupported, std::string("cannot start Xvfb: ") + std::strerror(errno));
    }
    if (const int error = spawn(pipe.ends[1], process); error != 0) {
        return fail(Errc::unsupported, std::string("no display, and Xvfb does not start (") +
                                           std::strerror(error) + "): " + advice);
    }
    pipe.close(1);
    const std::string number = read_line(pipe.ends[0]);
    if (number.empty()) {
        end(process);
        return fail(Errc::unsupported,
                    std::string("no display, and Xvfb ended at once: ") + advice);
    }
    return Xvfb(process, ":" + number);
}

Xvfb::Xvfb(Xvfb&& other) noexcept
    : process_(std::exchange(other.process_, -1)), name_(std::move(other.name_)) {}

Xvfb::~Xvfb() {
    if (process_ > 0) end(process_);
}

Result<XConnection> XConnection::open(const std::string& name) {
    const char* wanted = name.empty() ? std::getenv("DISPLAY") : name.c_str();
    if (wanted == nullptr || *wanted == '\0') {
        return fail(Errc::unsupported,
                    "no display: DISPLAY is not set; run in a graphical session");
    }
    const Xlib& x = Xlib::get();
    if (x.open == nullptr || x.close == nullptr || x.query_extension == nullptr) {
        return fail(Errc::unsupported, "libX11.so.6 is missing; install libx11-6");
    }
    void* handle = x.open(wanted);
    if (handle == nullptr) {
        return fail(Errc::unsupported, std::string("cannot connect to display ") + wanted +
                                           "; check DISPLAY and the access rights");
    }
    XConnection connection(handle);
    int unused = 0;
    if (x.query_extension(handle, "GLX", &unused, &unused, &unused) == 0) {
        return fail(Errc::unsupported, std::string("display ") + wanted + " has no OpenGL (GLX)");
    }
    return connection;
}

XConnection::XConnection(XConnection&& other) noexcept
    : handle_(std::exchange(other.handle_, nullptr)) {}

XConnection::~XConnection() {
    if (handle_ != nullptr) Xlib::get().close(handle_);
}

}  // namespace sightline::viz::detail
