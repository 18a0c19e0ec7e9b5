// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/recover.h"

#include <algorithm>

#include "recover/canonical.h"
#include "recover/recovery.h"

namespace crumple::recover {

Result recover_shell(TetMesh mesh, const Shell& shell, const Params& params, const Context& context) {
    Result result;
    if (params.mode == Mode::off) {
        result.mesh = std::move(mesh);
        return result;
    }
    Canonical task = canonical_task(mesh, shell);
    TetComplex complex(task.mesh);
    const auto max_splits =
        static_cast<std::size_t>(params.max_steiner * static_cast<double>(shell.positions.size())) + 4;
    Recovery recovery(complex, task.constraints, params, max_splits, context);
    Report& report = result.report;
    report.edges = task.constraints.segments().size();
    report.triangles = task.constraints.facets().size();
    report.missing_edges_before = recovery.missing_segments().size();
    report.missing_triangles_before = recovery.missing_facets().size();
    recovery.run();
    report.missing_edges = recovery.missing_segments().size();
    report.missing_triangles = recovery.missing_facets().size();
    report.exchanges = recovery.exchanges();
    report.steiner_points_tried = recovery.splits_tried();
    report.steiner_points = recovery.splits().size();
    result.mesh = original_mesh(task, complex.to_mesh(), mesh);
    report.added_nodes = result.mesh.positions.size() - mesh.positions.size();
    return result;
}

}
