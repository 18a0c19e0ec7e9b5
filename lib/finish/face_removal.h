// SPDX-License-Identifier: GPL-3.0-or-later
// Takes a face, or several that lie between the same two nodes, out of the mesh and joins the two nodes by an edge: the
// reverse of edge removal. One face is the 2-3 flip [Shewchuk 2002, "Two discrete optimization algorithms for the
// topological improvement of tetrahedral meshes", multi-face removal].
#pragma once
#include "finish/work_mesh.h"

namespace crumple::finish {

// An exchange whose every tet has a better shape than `floor`, exactly positive. False when there is none.
[[nodiscard]] bool plan_face_removal(const WorkMesh& mesh, Index tet, int corner, double floor, Exchange& exchange);

}
