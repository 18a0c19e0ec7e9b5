// SPDX-License-Identifier: GPL-3.0-or-later
// How the vertices of a visual mesh hang on the tets. V vertices.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/index.h"

namespace crumple {

struct VisualBinding {
    std::string name;                                // of the VisualMesh
    std::vector<Index> tet;                          // V: index into TetMesh::tets
    std::vector<std::array<double, 4>> barycentric;  // V: weights of the tet's corners, sum 1, never clamped
    std::vector<std::uint8_t> inside;                // V: 1 when the tet contains the vertex
    std::vector<double> distance;                    // V: metres to the tet, 0 inside
};

using Bindings = std::vector<VisualBinding>;

}
