// SPDX-License-Identifier: GPL-3.0-or-later
// Takes flat tets off the surface: those that lie under two faces of it like a bandage, with the two other faces
// inside. Without them the surface runs along the tet's other two faces, which is hardly another place.
#pragma once
#include <cstdint>

#include "core/context.h"
#include "finish/surface_guard.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

struct PeelLimits {
    double angle_deg = 12;        // a tet with no smaller dihedral angle is not flat
    double share_of_edge = 0.05;  // largest height over the mean edge
    double volume = 0;            // that may go in all, cubic metres; tets outside the shell do not count
};

struct PeelReport {
    std::uint64_t removed = 0;
    std::uint64_t restored = 0;  // of those: their inner faces are the shell's, so they lay outside it
    double volume = 0;           // of the tets removed, cubic metres
    double spent = 0;            // of that, what the limit counts
};

// Worst shapes first. A removal never makes the surface touch itself, leaves a node without tets, or takes away an edge
// that is sharp, painted or parts components.
[[nodiscard]] PeelReport peel_flat_tets(WorkMesh& mesh, const SurfaceGuard& guard, const PeelLimits& limits,
                                        const Context& context);

}
