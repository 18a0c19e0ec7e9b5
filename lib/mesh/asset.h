// SPDX-License-Identifier: GPL-3.0-or-later
// Everything import hands to the stages: one shell, any number of visual meshes, and what the file painted.
#pragma once
#include <vector>

#include "mesh/shell.h"
#include "mesh/visual_mesh.h"

namespace crumple {

struct Asset {
    Shell shell;
    std::vector<VisualMesh> visuals;
    // Every distinct painted position as the file states it (after unit scale and node transform, rounded to float),
    // in lexicographic order. Kept beside Shell::locked so that `check` can prove that no lock was lost on the way.
    std::vector<Vec3> locked_positions;
};

}
