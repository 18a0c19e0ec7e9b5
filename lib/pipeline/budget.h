// SPDX-License-Identifier: GPL-3.0-or-later
// Time and memory a whole cook may take. The work runs in a child process that is ended when it takes more, so nothing
// inside it has to look at a clock; and since a file is put in place by one rename, it is there whole or not at all.
#pragma once
#include <functional>
#include <string>

namespace crumple::pipeline {

struct Budget {
    double time_s = 0;     // by the wall; 0: as long as it takes
    double memory_mb = 0;  // resident, million bytes, children included; 0: as much as there is

    [[nodiscard]] bool is_limited() const { return time_s > 0 || memory_mb > 0; }
};

// To be called by the work right before it puts its result in place: from then on it may finish. Throws Error(budget)
// when it is too late or `peak_mb` is too much; `where` is what took the most.
using Permission = std::function<void(double peak_mb, const std::string& where)>;

// Runs work, in a child process when the budget is limited, and returns what it returned. stdout and stderr are shared.
// Throws Error(budget) when the work was ended, Error(internal) when it crashed.
// REQUIRES: no other thread of this process is running.
[[nodiscard]] int run_within(const Budget& budget, const std::function<int(const Permission&)>& work);

}
