// SPDX-License-Identifier: GPL-3.0-or-later
// Takes away a node of the surface that is none of the shell's, by merging it into a neighbour on the surface: what
// recovery put on an edge or triangle of the shell may go again where the surface hardly changes by it.
#pragma once
#include "finish/surface_guard.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

// The star of a surplus node without it, every face opposite it joined to `target`. False unless every new tet is
// better than `floor` and exactly positive, the surface stays a manifold and keeps to the guard's limits.
[[nodiscard]] bool plan_surface_contraction(const WorkMesh& mesh, const SurfaceGuard& guard, Index node,
                                            std::span<const Index> star, Index target, double floor,
                                            Exchange& exchange);

}
