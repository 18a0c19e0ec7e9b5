// SPDX-License-Identifier: GPL-3.0-or-later
// A node put into tets that stay Delaunay around it as far as the shell allows.
#pragma once
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"
#include "mesh/tet_complex.h"
#include "recover/constraints.h"

namespace crumple::recover {

// Of the candidates the tets that hold the place in their inside or on their surface.
[[nodiscard]] std::vector<Index> holders_of(const TetComplex& complex, std::span<const Index> candidates, Vec3 place);

// Puts `place` into the tets: they must hold it, in their inside or on a face or edge that they share. Takes away
// further tets around it so that few circumspheres hold it, none of them across a facet. Tells the new node, or none
// when not every tet around it would be positive.
Index insert_node(TetComplex& complex, const Constraints& constraints, Vec3 place, std::vector<Index> holders);

}
