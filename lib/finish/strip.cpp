// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/strip.h"

#include <algorithm>

#include "finish/shape.h"
#include "finish/tet_selection.h"
#include "geometry/measures.h"

namespace crumple::finish {

namespace {

bool has_no_thickness(const TetMesh& mesh, Index tet, double diagonal) {
    const auto& [a, b, c, d] = mesh.tets[tet];
    const auto& p = mesh.positions;
    if (!(shape_of(p[a], p[b], p[c], p[d]) < no_shape)) return false;
    double largest = 0;  // twice the area of a face
    for (const auto& face : tet_face_corners) {
        const Tet& t = mesh.tets[tet];
        largest = std::max(largest, length(area_vector(p[t[face[0]]], p[t[face[1]]], p[t[face[2]]])));
    }
    return 6 * signed_volume(p[a], p[b], p[c], p[d]) <= no_thickness * diagonal * largest;
}

// A tet with one face on the surface is no flap: local operations mend it.
bool is_flap(const TetSelection& tets, Index tet) {
    int exposed = 0;
    for (int corner = 0; corner < 4; ++corner) exposed += tets.neighbour(tet, corner) == none;
    return exposed >= 2;
}

bool may_go(const TetSelection& tets, const SurfaceGuard& guard, Index tet) {
    const Tet& corners = tets.mesh().tets[tet];
    for (const auto& edge : tet_edge_corners) {
        if (guard.is_marked(corners[edge[0]], corners[edge[1]])) return false;
    }
    return std::all_of(corners.begin(), corners.end(),
                       [&](Index v) { return v >= tets.mesh().shell_vertex_count || tets.tets_at(v).size() > 1; });
}

}

std::uint64_t strip_flat_tets(TetMesh& mesh, const SurfaceGuard& guard, const Context& context) {
    std::vector<Index> flat;
    for (Index t = 0; t < mesh.tets.size(); ++t) {
        if (has_no_thickness(mesh, t, guard.diagonal())) flat.push_back(t);
    }
    if (flat.empty()) return 0;
    TetSelection tets(std::move(mesh));
    std::uint64_t stripped = 0;
    for (bool has_stripped = true; has_stripped;) {
        context.stop_if_cancelled();
        has_stripped = false;
        for (const Index t : flat) {
            if (!tets.is_there(t) || !is_flap(tets, t) || !may_go(tets, guard, t)) continue;
            SurfaceChange change;
            change.gone.push_back(t);
            tets.put(change);
            ++stripped;
            has_stripped = true;
        }
    }
    mesh = std::move(tets).take();
    return stripped;
}

}
