// SPDX-License-Identifier: MIT
// The unit sphere in nearly equilateral triangles.
#pragma once
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple::samples {

struct Icosphere {
    std::vector<Vec3> directions;     // 10 * 4^level + 2 unit vectors
    std::vector<Triangle> triangles;  // 20 * 4^level, counter-clockwise from outside
};

// An icosahedron whose triangles are cut in four `level` times.
[[nodiscard]] Icosphere icosphere(int level);

}
