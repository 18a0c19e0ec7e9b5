// SPDX-License-Identifier: GPL-3.0-or-later
// Merges nodes that are none of the shell's and lie next to another node compared with the edges around them: no move
// helps the tets between them, and merged they are gone.
#pragma once
#include <cstdint>

#include "core/context.h"
#include "finish/surface_guard.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

// An edge shorter than this share of the longest one at its node is too short.
inline constexpr double crowded_share = 0.01;

// How many went. Tets may get a little worse where they were flat to a thousandth anyway.
[[nodiscard]] std::uint64_t merge_crowded_nodes(WorkMesh& mesh, const SurfaceGuard& guard, const Context& context);

}
