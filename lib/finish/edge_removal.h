// SPDX-License-Identifier: GPL-3.0-or-later
// Takes an edge out of the mesh: the tets around it give way to the best tets between the nodes of its ring. Holds the
// 3-2 and 4-4 flips as its smallest cases.
#pragma once
#include "finish/surface_guard.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

enum class RemovalResult { none, interior, surface };

// An exchange whose every tet has a better shape than `floor`. An edge on the surface is only taken out where the guard
// lets the surface change; `guard` may be null: then never. Exactly positive.
[[nodiscard]] RemovalResult plan_edge_removal(const WorkMesh& mesh, const SurfaceGuard* guard, const TetRing& ring,
                                              Index a, Index b, double floor, Exchange& exchange);

}
