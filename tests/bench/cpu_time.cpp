// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/cpu_time.h"

#include <ctime>

namespace crumple::bench {

double cpu_seconds() {
    std::timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}
