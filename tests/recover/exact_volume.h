// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes as whole numbers: equal means equal.
#pragma once
#include <string>

#include "mesh/tet_mesh.h"

namespace crumple::recover {

// Six times the sum over the tets, in cubes of the smallest float, hexadecimal. REQUIRES: positions are floats.
[[nodiscard]] std::string exact_six_volumes(const TetMesh& mesh);

}
