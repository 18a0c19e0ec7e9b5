// SPDX-License-Identifier: GPL-3.0-or-later
// What the system says a process holds.
#pragma once
#include <sys/types.h>

#include <cstdint>

namespace crumple::sandbox {

struct ProcessMemory {
    std::uint64_t address_space = 0;  // bytes, as the rest
    std::uint64_t resident = 0;
    std::uint64_t shared = 0;  // of the resident: with files and other processes
};

// All 0 for a process that is gone, or where there is no /proc.
[[nodiscard]] ProcessMemory memory_of(pid_t process);

}
