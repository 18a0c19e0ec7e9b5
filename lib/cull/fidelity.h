// SPDX-License-Identifier: GPL-3.0-or-later
// How far the surface of the tets and the surface of the shell's solid stray from each other.
#pragma once
#include <span>

#include "core/context.h"
#include "geometry/hausdorff.h"
#include "mesh/shell.h"
#include "mesh/shell_interior.h"

namespace crumple::cull {

struct Fidelity {
    Farthest out;         // of the tets' surface from the shell, metres
    Farthest in;          // of the solid's surface from the tets'; shell triangles within material do not count
    double diagonal = 0;  // of the shell's box, metres
};

// faces: the boundary of the tets over `positions`.
[[nodiscard]] Fidelity measure_fidelity(const Shell& shell, const ShellInterior& interior,
                                        std::span<const Vec3> positions, std::span<const Triangle> faces,
                                        std::size_t samples, const Context& context);

}
