// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/shell_figures.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "cull/cull.h"
#include "cull/fidelity.h"
#include "cull/shell_solid.h"
#include "geometry/measures.h"
#include "mesh/boundary.h"
#include "report/json.h"

namespace crumple::pipeline {

namespace {

double number_in(const report::Json& json, const char* key) {
    const report::Json* value = json.find(key);
    return value ? value->number() : 0;
}

ShellFigures stored_figures(const Workspace& work) {
    const auto cull =
        std::find_if(work.records.begin(), work.records.end(), [](const auto& r) { return r.name == "cull"; });
    if (cull == work.records.end()) return {};
    const report::Json json = report::parse_json(cull->report.text, "stored report", {.kind = ErrorKind::bad_input});
    return {Source::stored, number_in(json, "volume_error"), number_in(json, "hausdorff_out"),
            number_in(json, "hausdorff_in")};
}

double volume_of(const TetMesh& mesh) {
    double volume = 0;
    for (const auto& [a, b, c, d] : mesh.tets) {
        volume += signed_volume(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]);
    }
    return volume;
}

void measure(const Shell& shell, const TetMesh& mesh, ShellFigures& figures) {
    const ShellInterior interior(shell);
    const cull::ShellSolid solid = cull::study_solid(shell, interior);
    const std::vector<Triangle> faces = boundary_of(mesh).faces;
    const cull::Fidelity fidelity =
        cull::measure_fidelity(shell, interior, mesh.positions, faces, cull::Params().hausdorff_samples, {});
    if (fidelity.diagonal > 0) {
        figures.hausdorff_out = fidelity.out.distance / fidelity.diagonal;
        figures.hausdorff_in = fidelity.in.distance / fidelity.diagonal;
    }
    if (solid.is_exact() && solid.volume > 0) {
        figures.volume_error = std::fabs(volume_of(mesh) - solid.volume) / solid.volume;
    }
    figures.source = Source::measured;
}

}

ShellFigures shell_figures(const Workspace& work) {
    ShellFigures figures = stored_figures(work);
    const bool is_culled = work.tets && !work.tets->region.empty();
    if (work.asset && is_culled) measure(work.asset->shell, *work.tets, figures);
    return figures;
}

}
