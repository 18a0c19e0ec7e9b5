// SPDX-License-Identifier: GPL-3.0-or-later
// What make and ninja read to know when to cook again.
#pragma once
#include <string>
#include <vector>

namespace crumple::cli {

// One rule, "output: input input". Throws Error(usage) for a path that make and ninja do not both read back, such as one
// with a line break or '='.
[[nodiscard]] std::string depfile_text(const std::string& output, const std::vector<std::string>& inputs);

}
