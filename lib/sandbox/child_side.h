// SPDX-License-Identifier: GPL-3.0-or-later
// What happens in the child after the fork, and the frame in which it answers.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "sandbox/sandbox.h"

namespace crumple::sandbox {

// An address-space limit and the sanitizers' huge shadow mappings exclude each other.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool has_sanitizer = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
inline constexpr bool has_sanitizer = true;
#else
inline constexpr bool has_sanitizer = false;
#endif
#else
inline constexpr bool has_sanitizer = false;
#endif

// Comes first on the pipe; size bytes follow: the answer (ok) or a message.
struct FrameHeader {
    std::uint32_t magic = frame_magic;
    std::uint32_t ending = 0;  // ok, refused or out_of_memory
    std::uint32_t error_kind = 0;
    std::uint32_t reserved = 0;
    std::uint64_t size = 0;

    static constexpr std::uint32_t frame_magic = 0x6b316663;
};

// Limits itself, runs the function, writes one frame to the pipe and ends the process.
[[noreturn]] void be_the_child(int pipe_fd, int parent_pid, const std::function<std::vector<std::byte>()>& function,
                               const Limits& limits) noexcept;

}
