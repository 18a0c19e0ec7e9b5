// SPDX-License-Identifier: GPL-3.0-or-later
// Which material a tet is made of: the majority of sample points, each decided by the innermost shell around it.
#pragma once
#include <array>
#include <vector>

#include "core/context.h"
#include "cull/cull.h"
#include "cull/shell_solid.h"
#include "mesh/shell_interior.h"

namespace crumple::cull {

struct Verdict {
    Index region = none;     // none: outside
    bool straddles = false;  // decided by all samples
    double inside = 0;       // share of the samples in material; meaningful only where the solid is not exact
    double winding = 0;      // at the barycentre, the largest of any component that has material
};

[[nodiscard]] std::vector<Verdict> classify_tets(const Shell& shell, const ShellInterior& interior,
                                                 const ShellSolid& solid, const TetMesh& mesh, const Params& params,
                                                 const Context& context);

// Weights of points spread evenly through a tet, the same pattern for each corner: a lattice of as many points as it
// takes to have at least `count`.
[[nodiscard]] std::vector<std::array<double, 4>> sample_pattern(std::uint32_t count);

}
