// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/random.h"
#include "mesh/shapes.h"

namespace crumple {

// A grid of tets whose nodes are shaken by up to `share` of a cell along each axis; up to 0.2 no tet turns over.
inline TetMesh uneven_grid(int cells, double share = 0.15, std::uint64_t seed = 7) {
    TetMesh mesh = shapes::tet_grid(cells);
    Rng rng(seed);
    for (Vec3& p : mesh.positions) {
        for (int axis = 0; axis < 3; ++axis) p[axis] += (2 * rng.next_unit() - 1) * share / cells;
        p = round_to_float(p);
    }
    return mesh;
}

}
