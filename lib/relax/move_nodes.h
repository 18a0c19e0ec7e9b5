// SPDX-License-Identifier: GPL-3.0-or-later
// One sweep's moves: every interior node towards its target, no node out of its material, no two onto one place.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "mesh/tet_mesh.h"
#include "relax/material_space.h"
#include "relax/method.h"
#include "relax/stars.h"

namespace crumple::relax {

struct Moves {
    std::vector<Spot> spots;  // N interior nodes: where each goes
    double max_move = 0;      // farthest any goes, in mean edges at the node
    std::uint32_t held = 0;   // nodes that go less far than their target, or nowhere
};

// spots: where the interior nodes are. A node that lies in no material or in no tet inside stays.
[[nodiscard]] Moves choose_moves(const TetMesh& mesh, const Stars& stars, const std::vector<Spot>& spots,
                                 TargetFunction target, const MaterialSpace& space, const Context& context);

}
