// SPDX-License-Identifier: GPL-3.0-or-later
// How far a missing part of the shell is from what the tets have in its place. Measured in floating point.
#pragma once
#include "core/vec3.h"
#include "mesh/tet_complex.h"
#include "recover/crossings.h"

namespace crumple::recover {

// Where a crossing lies on a segment, as a share of its length.
[[nodiscard]] double crossing_share(const TetComplex& complex, const Edge& segment, const Crossing& crossing);

// Where an edge goes through a facet.
[[nodiscard]] Vec3 piercing_place(const TetComplex& complex, const Triangle& facet, const Edge& edge);

// Farthest that the segment passes from the edges of the faces it pierces, in its lengths. 0: it runs along faces.
[[nodiscard]] double deviation_of_segment(const TetComplex& complex, const Edge& segment);

// Of the edges that pierce a facet, the farthest that the nearer end is from the facet's plane, in its longest edge. 0:
// faces cover it, or its edges are not all there.
[[nodiscard]] double deviation_of_facet(const TetComplex& complex, const Triangle& facet);

}
