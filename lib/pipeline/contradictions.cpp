// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/contradictions.h"

#include <algorithm>
#include <cmath>

namespace crumple::pipeline {

namespace {

using Found = std::optional<Contradiction>;

// Points that never belonged to a shell may be any doubles. Where the artist lets vertices slide, the tets have moved
// on from the points they were made of.
Found check_points(const Workspace& work) {
    if (!work.points || !work.asset) return {};
    const PointSet& points = *work.points;
    if (points.shell_vertex_count != work.asset->shell.positions.size())
        return Contradiction{"/points/shell_vertex_count", "is not that of the shell"};
    if (!std::all_of(points.positions.begin(), points.positions.end(), is_float))
        return Contradiction{"/points/positions", "must be finite floats"};
    if (!work.tets && !begins_with_shell(points.positions, points.shell_vertex_count, work.asset->shell))
        return Contradiction{"/points/positions", "do not begin with the shell's"};
    return {};
}

Found check_tets(const Workspace& work) {
    if (!work.tets || !work.asset) return {};
    const Shell& shell = work.asset->shell;
    if (!begins_with_shell(work.tets->positions, work.tets->shell_vertex_count, shell))
        return Contradiction{"/tets", "does not fit the shell"};
    for (const Index region : work.tets->region) {
        if (region >= shell.components.size()) return Contradiction{"/tets/region", "an index is out of range"};
    }
    return {};
}

Found check_binding(const VisualBinding& binding, const VisualMesh& visual, std::size_t tet_count) {
    if (binding.tet.size() != visual.positions.size())
        return Contradiction{"/bindings", "does not fit the visual meshes"};
    for (std::size_t v = 0; v < binding.tet.size(); ++v) {
        if (binding.tet[v] >= tet_count) return Contradiction{"/bindings", "an index is out of range"};
        double sum = 0;
        double size = 0;
        for (const double w : binding.barycentric[v]) {
            sum += w;
            size += std::fabs(w);
        }
        constexpr double rounding = 1e-6;
        if (!(std::fabs(sum - 1) <= rounding * size)) return Contradiction{"/bindings", "weights do not sum to 1"};
        if (!(binding.distance[v] >= 0) || (binding.inside[v] && binding.distance[v] != 0))
            return Contradiction{"/bindings", "a vertex is inside at a distance, or at a negative one"};
    }
    return {};
}

Found check_bindings(const Workspace& work) {
    if (!work.bindings) return {};
    if (!work.tets || !work.asset) return Contradiction{"/bindings", "there are no tets to bind to"};
    const std::vector<VisualMesh>& visuals = work.asset->visuals;
    if (work.bindings->size() != visuals.size()) return Contradiction{"/bindings", "does not fit the visual meshes"};
    for (std::size_t i = 0; i < visuals.size(); ++i) {
        if (Found found = check_binding((*work.bindings)[i], visuals[i], work.tets->tets.size())) return found;
    }
    return {};
}

}

bool begins_with_shell(const std::vector<Vec3>& positions, Index shell_vertex_count, const Shell& shell) {
    return shell_vertex_count == shell.positions.size() && positions.size() >= shell.positions.size() &&
           std::equal(shell.positions.begin(), shell.positions.end(), positions.begin());
}

Found find_contradiction(const Workspace& work) {
    if (Found found = check_points(work)) return found;
    if (Found found = check_tets(work)) return found;
    return check_bindings(work);
}

}
