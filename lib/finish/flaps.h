// SPDX-License-Identifier: GPL-3.0-or-later
// Takes flaps off the surface: flat tets that hang on the mesh by one face only. The node at the tip goes with them,
// but a vertex of the shell is seated on the surface beside, where it lies anyway.
#pragma once
#include "finish/peel.h"

namespace crumple::finish {

// Until no more can go. A shell vertex never loses its last tet.
[[nodiscard]] PeelReport clip_flaps(WorkMesh& mesh, const SurfaceGuard& guard, const PeelLimits& limits,
                                    const Context& context);

// What puts a node that only the tet `flap` has on a face or an edge of the surface, within `reach` of it, and takes
// the flap away: of all ways the best worst tet. False when there is none, exactly positive, that turns no face over.
[[nodiscard]] bool plan_seat(const WorkMesh& mesh, const SurfaceGuard& guard, Index flap, Index node, double reach,
                             Exchange& exchange);

}
