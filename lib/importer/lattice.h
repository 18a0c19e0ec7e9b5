// SPDX-License-Identifier: GPL-3.0-or-later
// A body-centred cubic lattice of tets over a box [Molino, Bridson, Teran, Fedkiw 2003]: all tets alike, dihedral
// angles of 60 and 90 degrees, and the Delaunay tetrahedralization of its nodes.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/index.h"
#include "geometry/measures.h"
#include "mesh/tet_mesh.h"

namespace crumple::importer {

struct Lattice {
    TetMesh mesh;     // neighbours filled, shell_vertex_count 0
    double cell = 0;  // metres, edge of a cube
};

// Covers the box with at least one cube to spare on every side. `cells` cubes along its longest side. Nodes are whole
// multiples of half a cell, exact as floats. Throws Error(bad_input) for a box too far from the origin for that.
[[nodiscard]] Lattice make_lattice(const Box& box, std::uint32_t cells);

}
