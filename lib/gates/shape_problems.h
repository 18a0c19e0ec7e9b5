// SPDX-License-Identifier: GPL-3.0-or-later
// What is told of tets that have not come to a bundle yet: nobody has asked for a gate.
#pragma once
#include <vector>

#include "core/finding.h"
#include "mesh/tet_mesh.h"
#include "quality/quality.h"

namespace crumple::gates {

// QUALITY_INVERTED, QUALITY_MIN_DIHEDRAL, QUALITY_MAX_DIHEDRAL, QUALITY_BELOW_10_DEG, QUALITY_P5_DIHEDRAL,
// QUALITY_FLAT_TET, QUALITY_RADIUS_RATIO, QUALITY_ELEMENT_STEP, QUALITY_STIFFNESS_RATIO: whatever is out of bounds.
[[nodiscard]] std::vector<Finding> find_problems(const TetMesh& mesh, const quality::Summary& summary);

}
