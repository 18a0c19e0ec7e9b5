// SPDX-License-Identifier: GPL-3.0-or-later
// Points without topology: the shell's vertices first, at their shell index, then interior points.
#pragma once
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

struct PointSet {
    std::vector<Vec3> positions;  // float-representable
    Index shell_vertex_count = 0; // positions [0, shell_vertex_count) are the shell's
};

}
