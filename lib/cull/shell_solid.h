// SPDX-License-Identifier: GPL-3.0-or-later
// What the shell's components make together: is the solid well defined by its surfaces, how large is it, in how many
// pieces.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "mesh/shell.h"
#include "mesh/shell_interior.h"

namespace crumple::cull {

struct ShellSolid {
    std::vector<std::uint8_t> is_closed;  // C: every edge is run through as often one way as the other
    bool all_closed = true;
    bool has_meetings = false;  // triangles cross or touch, within a component or between two
    double volume = 0;          // exact when all_closed and not has_meetings
    Index pieces = 0;           // components that touch or lie in each other's material count as one

    [[nodiscard]] bool is_exact() const { return all_closed && !has_meetings; }
};

[[nodiscard]] ShellSolid study_solid(const Shell& shell, const ShellInterior& interior, const Context& context = {});

}
