// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <new>
#include <span>

#include "cli/session.hpp"

/// Work in processes of their own, which may crash or go round in circles, as doubles may lead anything
/// astray.
namespace sightline::detail {

/// Memory that child processes share with us, for plain data.
template <typename Case>
class SharedMemory {
public:
    explicit SharedMemory(std::size_t n) : size_(n) {
        void* memory = ::mmap(nullptr, n * sizeof(Case), PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) throw std::bad_alloc();
        cases_ = std::uninitialized_value_construct_n(static_cast<Case*>(memory), n) - n;
    }
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;
    ~SharedMemory() { ::munmap(cases_, size_ * sizeof(Case)); }
    [[nodiscard]] std::span<Case> all() const { return {cases_, size_}; }

private:
    Case* cases_;
    std::size_t size_;
};

/// Calls work(i) for i < n, each in a process that is ended after five minutes; as many at a time as there are
/// threads. Returns how many came to their end before the time was over.
[[nodiscard]] std::size_t run_forked(std::size_t n, Session& session,
                                     const std::function<void(std::size_t)>& work);

}  // namespace sightline::detail
