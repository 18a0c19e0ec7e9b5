// SPDX-License-Identifier: GPL-3.0-or-later
// Which material fills a place, asked as rarely as possible: inside a ball that holds nothing of a watertight shell it
// is the same everywhere, and a distance is cheaper than a winding number.
#pragma once
#include "core/index.h"
#include "core/vec3.h"
#include "geometry/surface_distance.h"
#include "mesh/shell.h"
#include "mesh/shell_interior.h"

namespace crumple::relax {

// A place whose material is known.
struct Spot {
    Vec3 position;
    Index material = none;  // shell component that fills it; none outside and in cavities
    double clear = 0;       // metres to the shell; 0 where that is of no use
    Index nearest = none;   // triangle
};

class MaterialSpace {
public:
    explicit MaterialSpace(const Shell& shell);

    [[nodiscard]] Spot look_at(Vec3 p) const;
    // The same, with a known spot nearby to learn from.
    [[nodiscard]] Spot look_at(Vec3 p, const Spot& known) const;
    // Only the material, faster still.
    [[nodiscard]] Index material_at(Vec3 p, const Spot& known) const;
    [[nodiscard]] Index material_at(Vec3 p) const { return interior_.material_at(p); }

private:
    [[nodiscard]] bool is_same(const Spot& known, Vec3 p, double clear) const {
        return is_watertight_ && length(p - known.position) < (known.clear + clear) * (1 - 1e-9);
    }

    ShellInterior interior_;
    SurfaceDistance surface_;
    bool is_watertight_;
};

}
