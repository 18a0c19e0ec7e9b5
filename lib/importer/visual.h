// SPDX-License-Identifier: GPL-3.0-or-later
// A visual mesh as a game sees it: the file's own vertices, not welded.
#pragma once
#include <string>
#include <vector>

#include "importer/surface.h"
#include "mesh/visual_mesh.h"

namespace crumple::importer {

// With a vertex list (OBJ) the mesh's vertices are that list, used or not; else those of the surface as they come.
[[nodiscard]] VisualMesh make_visual(const std::string& name, const Surface& surface, std::vector<Vec3> vertex_list);

}
