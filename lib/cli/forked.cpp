// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/forked.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <thread>

namespace sightline::detail {
namespace {

/// Starts a process for one case; its end, of whatever kind, leaves what it had found.
pid_t start(std::size_t i, const std::function<void(std::size_t)>& work) {
    const pid_t parent = ::getpid();
    const pid_t process = ::fork();
    if (process != 0) return process;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);
    constexpr unsigned patience = 300;
    ::alarm(patience);
    try {
        work(i);
    } catch (const std::exception&) {
        ::_exit(1);
    }
    ::_exit(0);
}

}  // namespace

std::size_t run_forked(std::size_t n, Session& session,
                       const std::function<void(std::size_t)>& work) {
    unsigned room = session.common().threads;
    if (room == 0) room = std::max(1U, std::thread::hardware_concurrency());
    std::size_t started = 0;
    std::size_t finished = 0;
    while (finished < n) {
        if (started < n && started - finished < room && !session.is_over()) {
            if (start(started, work) < 0) throw std::bad_alloc();
            ++started;
            continue;
        }
        if (finished == started) break;
        ::wait(nullptr);
        ++finished;
        session.progress().update(static_cast<double>(finished) / static_cast<double>(n));
    }
    return finished;
}

}  // namespace sightline::detail
