// SPDX-License-Identifier: GPL-3.0-or-later
// What can be done with a node of the surface. One that is none of the shell's merges into a neighbour: what recovery
// put on an edge or triangle of the shell may go again where the surface hardly changes by it. One of the shell's may
// slide along a smooth part of it, if that is asked for.
#pragma once
#include <optional>

#include "finish/smoothing.h"
#include "finish/surface_guard.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

// Exposed faces at a node as the edges opposite it, so that (node, from, to) is counter-clockwise from outside.
[[nodiscard]] std::vector<Edge> surface_link(const WorkMesh& mesh, Index node, std::span<const Index> star);

// The star of a surplus node without it, every face opposite it joined to `target`. False unless every new tet is
// better than `floor` and exactly positive, the surface stays a manifold and keeps to the guard's limits.
[[nodiscard]] bool plan_surface_operations(const WorkMesh& mesh, const SurfaceGuard& guard, Index node,
                                           std::span<const Index> star, Index target, double floor, Exchange& exchange);

// Where along the surface to put a node so that the worst tet of its star gets better than `floor`: no farther than
// `reach` from `home`, where it came from, and within the guard's limits. Exactly positive.
[[nodiscard]] std::optional<BetterPlace> plan_slide(const WorkMesh& mesh, const SurfaceGuard& guard, Index node,
                                                    std::span<const Index> star, Vec3 home, double reach, double floor);

}
