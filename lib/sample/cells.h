// SPDX-License-Identifier: GPL-3.0-or-later
// The places that may take points, as cubes of an octree: refined until each is either free of the shell or small
// against the element size there. They give the automatic number of points and let candidates be drawn where they will
// be accepted.
#pragma once
#include <vector>

#include "core/context.h"
#include "core/index.h"
#include "core/vec3.h"
#include "sample/space.h"

namespace crumple::sample {

struct Cell {
    Vec3 centre;
    double half = 0;               // half of the cube's edge
    double reach = 0;              // no place of the cube, rounded to float, is farther from the centre
    double size = 0;               // h at the centre
    double distance = 0;           // from the centre to the shell
    Index nearest = none;          // triangle to the centre
    Index sized_by = none;         // the vertex whose term gives h at the centre
    bool is_fillable = false;      // at the centre
    bool is_clear = false;         // every place of it is fillable and far enough from the shell
    double share = 0;              // about how much of its volume is fillable and 0.35 h away from the shell
    std::vector<Index> vertices;   // that may give h somewhere in the cell
    std::vector<Index> triangles;  // that may be nearest to some place of it; none kept for a clear cell

    [[nodiscard]] double volume() const { return 8 * half * half * half; }
    // Bounds of h so far from the centre.
    [[nodiscard]] double least_size(double away) const { return size - size_growth * away; }
    [[nodiscard]] double largest_size(double away) const { return size + size_growth * away; }
};

// So far from the shell, in h, begins the space for which points are counted.
inline constexpr double counted_clearance = 0.35;

// Cells where points at least clearance * h (or counted_clearance * h) from the shell may lie.
[[nodiscard]] std::vector<Cell> find_cells(const Space& space, double clearance, const Context& context);

// h, and the distance to the shell, at a place within the cell's reach.
[[nodiscard]] double size_at(const Space& space, const Cell& cell, Vec3 p);
[[nodiscard]] double distance_at(const Space& space, const Cell& cell, Vec3 p);

}
