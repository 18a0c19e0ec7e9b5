// SPDX-License-Identifier: GPL-3.0-or-later
// Small shells, tet meshes and point sets made in code, so that a test shows its input. Positions are
// float-representable, shells closed, wound outwards, unlocked, one solid component unless said otherwise.
#pragma once
#include <string_view>

#include "mesh/point_set.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"

namespace crumple::shapes {

// Corners (0,0,0), (1,0,0), (0,1,0), (0,0,1) times size: 4 vertices, 4 triangles, volume size^3 / 6.
[[nodiscard]] Shell tetrahedron(double size = 1);

// 8 vertices, 12 triangles.
[[nodiscard]] Shell box(Vec3 low = {0, 0, 0}, Vec3 high = {1, 1, 1});

// Each face cut into cells x cells squares of two triangles. cells >= 1.
[[nodiscard]] Shell subdivided_box(int cells, Vec3 low = {0, 0, 0}, Vec3 high = {1, 1, 1});

// A subdivided box 1 x thickness x 1.
[[nodiscard]] Shell thin_plate(double thickness = 0.02, int cells = 6);

// An icosahedron split `levels` times, vertices on the sphere to float precision: 10 4^levels + 2 vertices.
[[nodiscard]] Shell icosphere(double radius = 1, int levels = 2, Vec3 centre = {0, 0, 0});

// Around the y axis; `around` x `across` vertices, both >= 3.
[[nodiscard]] Shell torus(double major_radius = 1, double minor_radius = 0.4, int around = 16, int across = 8);

// Box [0,3]^3 with a box [1,2]^3 inside, both wound outwards; component 1 has the given role.
[[nodiscard]] Shell nested_boxes(Role inner = Role::cavity);

// One shell of both; b's components come after a's. A name that is taken gets its number appended.
[[nodiscard]] Shell joined(Shell a, const Shell& b);

// The same surface wound the other way round.
[[nodiscard]] Shell inverted(Shell shell);

// The same shell without one triangle: open.
[[nodiscard]] Shell without_triangle(Shell shell, Index triangle = 0);

// Every position through p -> p * scale + offset, rounded to float.
[[nodiscard]] Shell moved(Shell shell, Vec3 offset, double scale = 1);

// Integer coordinates 0..per_axis-1 on each axis, x slowest: every cell is cospherical.
[[nodiscard]] PointSet grid_points(int per_axis);

// The shell's vertices and no interior points.
[[nodiscard]] PointSet points_of(const Shell& shell);

// A box cut into cells^3 cubes of six positive tets each (all share the cube's long diagonal), neighbours filled; the
// nodes are a grid, x slowest, and shell_vertex_count is 0.
[[nodiscard]] TetMesh tet_grid(int cells, Vec3 low = {0, 0, 0}, Vec3 high = {1, 1, 1});

}
