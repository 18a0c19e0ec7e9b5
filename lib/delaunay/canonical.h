// SPDX-License-Identifier: GPL-3.0-or-later
// The hull's finite facets as a tet mesh whose order follows from the geometry alone.
#pragma once
#include <vector>

#include "core/index.h"
#include "delaunay/lifted_hull.h"
#include "mesh/tet_mesh.h"

namespace crumple::delaunay {

// Fills tets and neighbours. A tet starts with its corners in Hilbert order, the last two swapped where that is needed
// to keep it positive; tets are sorted by these corners.
void write_canonical_tets(const LiftedHull& hull, TetMesh& mesh);

}
