// SPDX-License-Identifier: GPL-3.0-or-later
// Raises the time step of the few nodes that set it for an explicit simulation: around the worst of them, edges and
// faces are taken out, nodes inside are moved and added. Shapes may give a little for it, but no good tet becomes a bad
// one.
#pragma once
#include <cstdint>

#include "core/context.h"
#include "finish/surface_guard.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

struct StepLimits {
    double share = 0.35;       // nodes below this share of the median step count as worth it
    std::uint64_t budget = 0;  // operations tried at most
};

struct StepReport {
    std::uint64_t changes = 0;
    std::uint64_t tried = 0;  // operations, whether they led to a change or not
};

// Every change raises the least step among the nodes it touches. Ends where nothing helps the worst node.
[[nodiscard]] StepReport raise_steps(WorkMesh& mesh, const SurfaceGuard& guard, const StepLimits& limits,
                                     const Context& context);

}
