// SPDX-License-Identifier: GPL-3.0-or-later
// A tool of a studio's own that uses one stage: the corners of a cube become tets.
#include <cstdio>

#include "delaunay/delaunay.h"

int main() {
    crumple::PointSet points;
    for (int corner = 0; corner < 8; ++corner) {
        points.positions.push_back({double(corner & 1), double(corner >> 1 & 1), double(corner >> 2)});
    }
    const auto result = crumple::delaunay::tetrahedralize(points);
    std::printf("%zu tets\n", result.mesh.tets.size());
    return result.mesh.tets.size() >= 5 ? 0 : 1;
}
