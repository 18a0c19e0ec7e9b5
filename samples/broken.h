// SPDX-License-Identifier: MIT
// Shells with one fault each, for what the tool says about them. Every one is a cube-like blob but for its fault.
#pragma once
#include <span>
#include <string_view>

#include "samples/model.h"

namespace crumple::samples {

struct BrokenShell {
    std::string_view name;     // open
    std::string_view finding;  // the code that import must report, empty where the fault is in numbers only
    Model (*make)();
};

[[nodiscard]] std::span<const BrokenShell> broken_shells();

}
