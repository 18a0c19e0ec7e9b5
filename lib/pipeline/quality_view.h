// SPDX-License-Identifier: GPL-3.0-or-later
// The quality of tets and embedding as arrays that ParaView colours the mesh with.
#pragma once
#include "pipeline/workspace.h"
#include "store/view_fields.h"

namespace crumple::pipeline {

// In the order of what the file shows: the bundle's nodes and tets, or, without a bundle, those of the tet mesh. Cells:
// min_dihedral_deg, volume_lrms3, element_step_ratio, and where they are known shell_limit (quality::ShellLimit),
// visual_vertices, visual_distance and visual_weight (of the visual vertices hung on it, the largest). Points:
// min_dihedral_deg and element_step_ratio (of the tets at it, the least), component. Visual meshes: "<name>.position",
// ".distance", ".weight", ".bound_wrongly", one row a visual vertex.
[[nodiscard]] store::ViewFields quality_view(const Workspace& workspace);

}
