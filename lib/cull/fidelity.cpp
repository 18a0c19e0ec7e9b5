// SPDX-License-Identifier: GPL-3.0-or-later
#include "cull/fidelity.h"

#include "geometry/measures.h"

namespace crumple::cull {

namespace {

// How far to either side of a shell triangle the material is asked for, in box diagonals: well above the rounding of a
// float, well below what a Hausdorff distance is worth reporting for.
constexpr double side_step = 1e-5;

}

Fidelity measure_fidelity(const Shell& shell, const ShellInterior& interior, std::span<const Vec3> positions,
                          std::span<const Triangle> faces, std::size_t samples, const Context& context) {
    Fidelity fidelity;
    fidelity.diagonal = bounding_box(shell.positions).diagonal();
    const auto bounds_solid = [&](const SurfaceSample& sample) {
        const auto& [a, b, c] = shell.triangles[sample.triangle];
        const Vec3 normal = area_vector(shell.positions[a], shell.positions[b], shell.positions[c]);
        const double size = length(normal);
        if (!(size > 0)) return false;
        const Vec3 step = normal * (side_step * fidelity.diagonal / size);
        return (interior.material_at(sample.position + step) == none) !=
               (interior.material_at(sample.position - step) == none);
    };
    const SurfaceDistance to_shell(shell.positions, shell.triangles);
    const SurfaceDistance to_tets(positions, faces);
    fidelity.out = farthest_sample(sample_surface(positions, faces, samples), to_shell, {}, context);
    fidelity.in =
        farthest_sample(sample_surface(shell.positions, shell.triangles, samples), to_tets, bounds_solid, context);
    return fidelity;
}

}
