// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/edge_removal.h"

#include <array>

#include "finish/ring_triangulation.h"

namespace crumple::finish {

RemovalResult plan_edge_removal(const WorkMesh& mesh, const SurfaceGuard* guard, const TetRing& ring, Index a, Index b,
                                double floor, Exchange& exchange) {
    exchange.clear();
    const std::size_t n = ring.link.size();
    if (n < 3 || n > max_ring || (!ring.is_closed && guard == nullptr)) return RemovalResult::none;
    if (!is_of_one_region(mesh, ring.tets)) return RemovalResult::none;
    if (!ring.is_closed && !guard->may_flip(mesh, a, b, ring.link.front(), ring.link.back()))
        return RemovalResult::none;

    std::array<Vec3, max_ring> places;
    for (std::size_t i = 0; i < n; ++i) places[i] = mesh.at(ring.link[i]);
    RingTriangulation best;
    if (!triangulate_ring(mesh.at(a), mesh.at(b), std::span(places).first(n), floor, best)) return RemovalResult::none;

    exchange.old = ring.tets;
    exchange.least = best.least;
    for (const auto& [i, j, k] : best.triangles) {
        exchange.fresh.push_back({ring.link[i], ring.link[j], ring.link[k], b});
        exchange.fresh.push_back({ring.link[i], ring.link[k], ring.link[j], a});
    }
    if (!are_positive(mesh, exchange.fresh)) return RemovalResult::none;
    return ring.is_closed ? RemovalResult::interior : RemovalResult::surface;
}

}
