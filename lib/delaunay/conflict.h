// SPDX-License-Identifier: GPL-3.0-or-later
// Is a point inside the circumsphere of a positive tet, with cospherical ties broken by coordinates?
//
// The heights of the lifted points are raised by infinitesimals e_1 << e_2 << ..., in lexicographic order of the
// points, so that no five are cospherical. The sign is then that of the largest raised point whose cofactor, an
// orientation, is not zero [Devillers, Teillaud 2011, "Perturbations for Delaunay and weighted Delaunay 3D
// triangulations"]: CGAL's rule.
#pragma once
#include <array>

#include "core/vec3.h"

namespace crumple::delaunay {

// REQUIRES: tet positive, point none of its corners, all five exactly cospherical. grain as in geometry/predicates.h.
[[nodiscard]] bool is_inside_after_tie(const std::array<Vec3, 4>& tet, Vec3 point, double grain);

}
