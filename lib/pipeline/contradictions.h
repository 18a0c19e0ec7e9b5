// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of a work file must be to each other: each may be sound by itself, and the file still be of two cooks.
#pragma once
#include <optional>
#include <string>

#include "pipeline/workspace.h"

namespace crumple::pipeline {

struct Contradiction {
    std::string path;  // of the group or dataset
    std::string what;
};

// The first one. REQUIRES: every part is sound by itself (work_parts.h).
[[nodiscard]] std::optional<Contradiction> find_contradiction(const Workspace& workspace);

// The nodes begin with the shell's vertices, where they lie.
[[nodiscard]] bool begins_with_shell(const std::vector<Vec3>& positions, Index shell_vertex_count, const Shell& shell);

}
