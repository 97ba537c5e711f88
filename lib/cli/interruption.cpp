// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interruption.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <utility>

namespace sightline::detail {
namespace {

// A signal handler may use lock-free atomics, unlink and _exit, and hardly anything else.
std::array<std::atomic<const char*>, 64> doomed{};
std::atomic<bool> is_committing{false};

[[noreturn]] void remove_and_exit(int status) {
    for (const std::atomic<const char*>& slot : doomed) {
        if (const char* path = slot.load(); path != nullptr) ::unlink(path);
    }
    ::_exit(status);
}

void on_signal(int /*signal*/) {
    if (!is_committing.load()) remove_and_exit(static_cast<int>(ExitStatus::interrupted));
}

}  // namespace

void handle_interruptions() {
    struct sigaction action{};
    action.sa_handler = on_signal;
    sigfillset(&action.sa_mask);
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
    action.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &action, nullptr);
}

DoomedFile::DoomedFile(std::string path) : path_(std::move(path)) {
    for (std::size_t i = 0; i < doomed.size(); ++i) {
        const char* empty = nullptr;
        if (doomed[i].compare_exchange_strong(empty, path_.c_str())) {
            slot_ = static_cast<int>(i);
            return;
        }
    }
    SIGHTLINE_EXPECT(!"more than 64 files are being written");
}

DoomedFile::DoomedFile(DoomedFile&& other) noexcept {
    // A short path lives inside the string, so the slot must follow it.
    path_ = other.path_;
    slot_ = std::exchange(other.slot_, -1);
    if (slot_ >= 0) doomed[static_cast<std::size_t>(slot_)].store(path_.c_str());
}

DoomedFile::~DoomedFile() {
    if (slot_ >= 0) doomed[static_cast<std::size_t>(slot_)].store(nullptr);
}

void begin_commit() { is_committing.store(true); }

void end_program(ExitStatus status, const std::string& line) {
    if (is_committing.load()) return;
    const std::string text = line + "\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    remove_and_exit(static_cast<int>(status));
}

}  // namespace sightline::detail
