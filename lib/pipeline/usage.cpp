// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/usage.h"

#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace crumple::pipeline {

namespace {

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double cpu_seconds() {
    timespec own{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &own);
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    return static_cast<double>(own.tv_sec) + 1e-9 * static_cast<double>(own.tv_nsec) + seconds(children.ru_utime) +
           seconds(children.ru_stime);
}

// Of the largest child that ever was waited for.
std::uint64_t children_peak_bytes() {
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    return static_cast<std::uint64_t>(children.ru_maxrss) * 1024;
}

// Makes VmHWM start again from what is held now, so that each stage has a peak of its own. Best effort.
void restart_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

}

UsageMeter::UsageMeter()
    : start_(std::chrono::steady_clock::now()),
      cpu_start_s_(cpu_seconds()),
      children_peak_start_bytes_(children_peak_bytes()) {
    restart_peak();
}

Usage UsageMeter::read() const {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
    // The system tells the largest child only: one that was smaller than an earlier one goes unseen.
    std::uint64_t peak = peak_memory_bytes();
    if (children_peak_bytes() > children_peak_start_bytes_) peak = std::max(peak, children_peak_bytes());
    return {wall.count(), cpu_seconds() - cpu_start_s_, static_cast<double>(peak) * 1e-6};
}

std::uint64_t peak_memory_bytes() {
    // Not ru_maxrss: that one remembers the process that started us.
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word != "VmHWM:") continue;
        std::uint64_t kib = 0;
        status >> kib;
        return kib * 1024;
    }
    rusage own{};
    getrusage(RUSAGE_SELF, &own);
    return static_cast<std::uint64_t>(own.ru_maxrss) * 1024;
}

}
