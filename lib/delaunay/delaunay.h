// SPDX-License-Identifier: GPL-3.0-or-later
// Exact Delaunay tetrahedralization: the lower convex hull of the points lifted to (p, |p|^2) in 4D, by quickhull
// [Barber, Dobkin, Huhdanpaa 1996] with a vertex at infinity. Cospherical ties break by coordinates, never by index, so
// the result is one and the same for any order of the points and equals CGAL's Delaunay_triangulation_3.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/point_set.h"
#include "mesh/tet_mesh.h"

namespace crumple::delaunay {

inline constexpr int version = 1;

struct Params {};
struct Report {};

struct Result {
    TetMesh mesh;  // the whole convex hull; every node of the points at its index; tets in a canonical order
    Report report;
};

[[nodiscard]] Result tetrahedralize(const PointSet& points, const Params& params = {}, const Context& context = {});

}
