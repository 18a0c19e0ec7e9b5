// SPDX-License-Identifier: GPL-3.0-or-later
// A detailed mesh that only follows the tets: never simulated. V vertices in the order a game will see them.
#pragma once
#include <string>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

struct VisualMesh {
    std::string name;                 // unique within the asset; the bundle's visual/<name>
    std::vector<Vec3> positions;      // V, metres, float-representable
    std::vector<Triangle> triangles;  // F; may be empty (a point cloud binds as well)
    std::vector<Index> source_vertex; // V: vertex number in the source file
    std::string shell_component;      // the component that owns it, empty: whichever contains a vertex
};

}
