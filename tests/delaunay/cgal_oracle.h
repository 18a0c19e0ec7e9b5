// SPDX-License-Identifier: GPL-3.0-or-later
// What CGAL's Delaunay_triangulation_3 makes of the same points.
#pragma once
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple::oracle {

// The finite cells as corners sorted by index, the list sorted too. Of equal points the one with the lowest index is
// used. Empty when the points do not span space.
[[nodiscard]] std::vector<Tet> cgal_tets(const std::vector<Vec3>& points);

// Dimension CGAL finds: -1 to 3.
[[nodiscard]] int cgal_dimension(const std::vector<Vec3>& points);

}
