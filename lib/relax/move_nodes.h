// SPDX-License-Identifier: GPL-3.0-or-later
// One sweep's moves: every interior node towards its target, no node out of its material, no two onto one place.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/context.h"
#include "mesh/shell_interior.h"
#include "mesh/tet_mesh.h"
#include "relax/method.h"
#include "relax/stars.h"

namespace crumple::relax {

struct Moves {
    std::vector<Vec3> places;  // N interior nodes: where each goes
    double max_move = 0;       // farthest any goes, in mean edges at the node
    std::uint32_t held = 0;    // nodes that go less far than their target, or nowhere
};

// materials: N, the shell component that fills each interior node's place. A node without one, or in no tet inside,
// stays.
[[nodiscard]] Moves choose_moves(const TetMesh& mesh, const Stars& stars, std::span<const Index> materials,
                                 TargetFunction target, const ShellInterior& interior, const Context& context);

}
