// SPDX-License-Identifier: GPL-3.0-or-later
// What a piece of work cost: time by the wall, time on processors (children that were waited for included), and the
// most memory that this process, or one of those children, held meanwhile.
#pragma once
#include <chrono>
#include <cstdint>

#include "core/fields.h"

namespace crumple::pipeline {

struct Usage {
    double wall_s = 0;
    double cpu_s = 0;
    double peak_memory_mb = 0;  // 1e6 bytes, resident
};

template <class Visitor, FieldsOf<Usage> U>
void describe(Visitor& visit, U& u) {
    visit.field("wall_s", u.wall_s, "seconds by the wall");
    visit.field("cpu_s", u.cpu_s, "seconds on processors, children included");
    visit.field("peak_memory_mb", u.peak_memory_mb, "most resident memory of one process, the file reader's included, million bytes");
}

// Measures from its construction on. One at a time knows its own peak; around it, an outer one sees at least that.
class UsageMeter {
public:
    UsageMeter();
    [[nodiscard]] Usage read() const;

private:
    std::chrono::steady_clock::time_point start_;
    double cpu_start_s_;
    std::uint64_t children_peak_start_bytes_;
};

// The most resident memory this process has held since the last UsageMeter began, bytes; never less than now.
[[nodiscard]] std::uint64_t peak_memory_bytes();

}
