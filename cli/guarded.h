// SPDX-License-Identifier: GPL-3.0-or-later
// The outermost place where an Error becomes words and an exit code: of the program, and of a child that cooks.
#pragma once
#include <functional>

#include "cli/console.h"

namespace crumple::cli {

// What the work returns, or the exit code of what it throws, which is told on the console.
[[nodiscard]] int run_guarded(const Console& console, const std::function<int()>& work);

}
