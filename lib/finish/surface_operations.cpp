// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/surface_operations.h"

#include <algorithm>

#include "finish/node_operations.h"
#include "geometry/measures.h"

namespace crumple::finish {

namespace {

// Ascending, without `node` itself.
std::vector<Index> neighbours_of_node(const WorkMesh& mesh, Index node, std::span<const Index> star) {
    std::vector<Index> nodes;
    for (const Index t : star) {
        for (const Index v : mesh.complex.corners(t)) {
            if (v != node) nodes.push_back(v);
        }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}

std::vector<Edge> surface_link(const WorkMesh& mesh, Index node, std::span<const Index> star) {
    std::vector<Edge> link;
    for (const Index t : star) {
        const Tet& corners = mesh.complex.corners(t);
        for (int corner = 0; corner < 4; ++corner) {
            if (corners[corner] == node || !mesh.is_exposed(t, corner)) continue;
            const auto& face = tet_face_corners[corner];
            Triangle at{corners[face[0]], corners[face[1]], corners[face[2]]};
            std::rotate(at.begin(), std::find(at.begin(), at.end(), node), at.end());
            link.push_back({at[1], at[2]});
        }
    }
    return link;
}

namespace {

// Merging two nodes leaves a manifold when nodes that are neighbours of both lie around their edge, in the mesh and on
// the surface (the link condition) [Dey, Edelsbrunner, Guha, Nekhayev 1999].
bool keeps_manifold(const WorkMesh& mesh, Index node, std::span<const Index> star, Index target,
                    const std::vector<Edge>& link) {
    std::vector<Index> other_star;
    mesh.complex.star_of(target, other_star);
    const std::vector<Index> a = neighbours_of_node(mesh, node, star);
    const std::vector<Index> b = neighbours_of_node(mesh, target, other_star);
    std::vector<Index> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    const auto with_target =
        std::find_if(star.begin(), star.end(), [&](Index t) { return mesh.complex.corner_of(t, target) >= 0; });
    if (with_target == star.end()) return false;
    TetRing ring;
    mesh.complex.ring_of(*with_target, node, target, ring);
    if (ring.is_closed) return false;
    std::vector<Index> around = ring.link;
    std::sort(around.begin(), around.end());
    if (around != common) return false;
    std::vector<Index> on_surface;
    for (const Edge& edge : surface_link(mesh, target, other_star)) on_surface.push_back(edge[0]);
    const auto is_shared = [&](const Edge& e) {
        return std::find(on_surface.begin(), on_surface.end(), e[0]) != on_surface.end();
    };
    return std::count_if(link.begin(), link.end(), is_shared) == 2;
}

}

bool plan_surface_operations(const WorkMesh& mesh, const SurfaceGuard& guard, Index node, std::span<const Index> star,
                             Index target, double floor, Exchange& exchange) {
    if (!mesh.is_on_surface[target] || mesh.is_pinched[target]) return false;
    const std::vector<Edge> link = surface_link(mesh, node, star);
    return guard.may_contract(mesh.complex.positions(), link, node, target) &&
           plan_contraction(mesh, node, star, target, floor, exchange) &&
           keeps_manifold(mesh, node, star, target, link);
}

std::optional<BetterPlace> plan_slide(const WorkMesh& mesh, const SurfaceGuard& guard, Index node,
                                      std::span<const Index> star, Vec3 home, double reach, double floor) {
    const std::vector<Edge> link = surface_link(mesh, node, star);
    const Vec3 at = mesh.at(node);
    Leash leash;
    for (const auto& [from, to] : link) leash.normal += area_vector(at, mesh.at(from), mesh.at(to));
    leash.reach = reach - length(at - home);
    if (link.empty() || !(leash.reach > 0)) return std::nullopt;
    std::vector<OppositeFace> faces = opposite_faces(mesh, node, star);
    const auto better = find_better_place(at, faces, floor, leash);
    if (!better || !is_positive_towards(better->place, faces)) return std::nullopt;
    if (!guard.may_slide(mesh.complex.positions(), link, node, home, better->place)) return std::nullopt;
    return better;
}

}
