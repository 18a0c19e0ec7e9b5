// SPDX-License-Identifier: MIT
// Where the solver's matrix has blocks, and who writes them. Derived from the tets alone.
#pragma once
#include "bundle/bundle.h"

namespace crumple {

// Fills row_start, column, diagonal, element_slots, edges, edge_slots, edge_start, edge_tet and edge_corners.
// REQUIRES: rest_positions has its final size, tets index into it, solver_tet_count <= tets.size().
// Throws Error(budget) when an index would not fit in 32 bits.
void build_matrix_pattern(Bundle& bundle);

}
