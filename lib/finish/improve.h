// SPDX-License-Identifier: GPL-3.0-or-later
// Raises the shapes of the worst tets by local operations, one tet at a time, worst first: takes edges and faces out,
// moves and merges interior nodes. Every change makes the worst of the tets it touches better, so no mesh gets
// worse.
#pragma once
#include <cstdint>

#include "core/context.h"
#include "finish/surface_guard.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

struct ImproveLimits {
    double target_deg = 40;     // tets whose shape is that of this smallest angle are left alone
    double slide = 0;           // how far a shell vertex may go, in its shortest edges; 0: never
    std::uint32_t rounds = 10;  // over all tets below the target whose surroundings changed
    std::uint64_t budget = 0;   // operations tried at most
};

struct ImproveReport {
    std::uint64_t edge_removals = 0;
    std::uint64_t surface_flips = 0;
    std::uint64_t face_removals = 0;
    std::uint64_t moves = 0;
    std::uint64_t contractions = 0;
    std::uint64_t slides = 0;
    std::uint32_t rounds = 0;
    std::uint64_t tried = 0;  // operations, whether they led to a change or not
    bool is_out_of_budget = false;
};

[[nodiscard]] ImproveReport improve_shapes(WorkMesh& mesh, const SurfaceGuard& guard, const ImproveLimits& limits,
                                           const Context& context);

}
