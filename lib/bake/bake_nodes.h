// SPDX-License-Identifier: GPL-3.0-or-later
// Which nodes of the mesh the bundle keeps, in which order, and that none of them lost a lock.
#pragma once
#include "bake/bake.h"

namespace crumple::bake {

// Fills rest_positions, locked, node_to_mesh, mesh_to_node and, in the report, what was dropped.
// Kept are nodes a tet uses and locked shell vertices, used or not.
void bake_nodes(const Shell& shell, const TetMesh& mesh, NodeOrder how, Bundle& bundle, Report& report);

// Fills locked_positions. Throws Error(bad_input) when a painted position has no locked node or a locked node was not
// painted. Locked nodes that no tet uses become a finding.
void bake_locks(const Asset& asset, const TetMesh& mesh, Bundle& bundle, Report& report);

}
