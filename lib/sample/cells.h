// SPDX-License-Identifier: GPL-3.0-or-later
// The places that may take points, as cubes of an octree: refined until each is either free of the shell or small
// against the element size there. They give the automatic number of points and let candidates be drawn where they will
// be accepted.
#pragma once
#include <vector>

#include "core/context.h"
#include "core/vec3.h"
#include "sample/space.h"

namespace crumple::sample {

struct Cell {
    Vec3 centre;
    double half = 0;               // half of the cube's edge
    double size = 0;               // h at the centre
    double distance = 0;           // from the centre to the shell
    bool is_one_material = false;  // all of it is fillable, though parts may be too near the shell
    bool is_clear = false;         // and no part of it is too near: all of it may take points
    double share = 0;              // about how much of its volume is fillable and 0.35 h away from the shell

    [[nodiscard]] double radius() const { return half * 1.7320508075688772; }
    // Bounds of h within the cell.
    [[nodiscard]] double least_size() const { return size - size_growth * radius(); }
    [[nodiscard]] double volume() const { return 8 * half * half * half; }
};

// So far from the shell, in h, begins the space for which points are counted.
inline constexpr double counted_clearance = 0.35;

// Cells where points at least clearance * h (or counted_clearance * h) from the shell may lie.
[[nodiscard]] std::vector<Cell> find_cells(const Space& space, const SizingField& field, double clearance,
                                           const Context& context);

}
