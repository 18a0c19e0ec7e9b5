// SPDX-License-Identifier: GPL-3.0-or-later
#include "gates/fidelity.h"

#include "cull/fidelity.h"
#include "cull/shell_solid.h"
#include "geometry/measures.h"
#include "mesh/boundary.h"

namespace crumple::gates {

namespace {

double volume_of(const TetMesh& mesh) {
    double volume = 0;
    for (const auto& [a, b, c, d] : mesh.tets) {
        volume += signed_volume(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]);
    }
    return volume;
}

}

Measured measure_fidelity(const Shell& shell, const TetMesh& mesh, const Solid& solid, std::uint32_t samples,
                          const Context& context) {
    const ShellInterior interior(shell);
    const cull::ShellSolid study = cull::study_solid(shell, interior, context);
    const std::vector<Triangle> faces = boundary_of(mesh).faces;
    const cull::Fidelity distances = cull::measure_fidelity(shell, interior, mesh.positions, faces, samples, context);
    const double volume = study.is_exact() ? study.volume : solid.volume;

    Measured measured;
    measured.shell_pieces = study.is_exact() ? study.pieces : solid.pieces;
    quality::Fidelity& fidelity = measured.fidelity;
    fidelity.is_known = true;
    fidelity.is_closed = study.all_closed;
    fidelity.leak_share = solid.leak_share;
    if (volume > 0) fidelity.volume_error = (volume_of(mesh) - volume) / volume;
    if (distances.diagonal > 0) {
        fidelity.hausdorff_out = distances.out.distance / distances.diagonal;
        fidelity.hausdorff_in = distances.in.distance / distances.diagonal;
    }
    fidelity.farthest_out = distances.out.sample.position;
    fidelity.farthest_in = distances.in.sample.position;
    return measured;
}

}
