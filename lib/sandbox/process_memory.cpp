// SPDX-License-Identifier: GPL-3.0-or-later
#include "sandbox/process_memory.h"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace crumple::sandbox {

ProcessMemory memory_of(pid_t process) {
    std::FILE* statm = std::fopen(("/proc/" + std::to_string(process) + "/statm").c_str(), "r");
    if (!statm) return {};
    unsigned long total = 0;
    unsigned long resident = 0;
    unsigned long shared = 0;
    const int read = std::fscanf(statm, "%lu %lu %lu", &total, &resident, &shared);
    std::fclose(statm);
    if (read != 3) return {};
    const auto page = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    return {total * page, resident * page, shared * page};
}

}
