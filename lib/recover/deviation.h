// SPDX-License-Identifier: GPL-3.0-or-later
// How far a missing part of the shell is from what the tets have in its place. Measured in floating point.
#pragma once
#include <span>

#include "core/vec3.h"
#include "mesh/tet_complex.h"
#include "recover/crossings.h"

namespace crumple::recover {

// Where a crossing lies on a segment, as a share of its length.
[[nodiscard]] double crossing_share(const TetComplex& complex, const Edge& segment, const Crossing& crossing);

// Where an edge goes through a facet.
[[nodiscard]] Vec3 piercing_place(const TetComplex& complex, const Triangle& facet, const Edge& edge);

// Exact: whether faces of the tets lie along the whole segment and cover its facets, and the shape lacks nothing.
[[nodiscard]] bool is_covered(const TetComplex& complex, const Edge& segment, std::span<const Index> apexes);
[[nodiscard]] bool is_covered(const TetComplex& complex, const Triangle& facet);

// How far the tets' own edges and faces run from a missing segment, metres: what it passes through, measured by the
// nearer side, from the planes of its two facets. 0: it runs along faces. Infinite at a fold of the shell that is to be
// seen and where other than two facets meet: there is no plane to stay in.
[[nodiscard]] double deviation_of_segment(const TetComplex& complex, const Edge& segment,
                                          std::span<const Index> apexes);

// Of the edges that pierce a facet, the farthest that the nearer end is from the facet's plane, metres. 0: faces cover
// it but for strips along its edges, which are the segments' affair.
[[nodiscard]] double deviation_of_facet(const TetComplex& complex, const Triangle& facet);

}
