// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/node_operations.h"

#include <algorithm>

#include "geometry/predicates.h"

namespace crumple::finish {

Triangle facing(const Tet& corners, int corner) {
    const auto& face = tet_face_corners[corner];
    return {corners[face[0]], corners[face[1]], corners[face[2]]};
}

OppositeFace places_of(const WorkMesh& mesh, const Triangle& face) {
    return {mesh.at(face[0]), mesh.at(face[1]), mesh.at(face[2])};
}

bool is_positive_towards(Vec3 node, std::span<const OppositeFace> faces) {
    return std::all_of(faces.begin(), faces.end(),
                       [&](const OppositeFace& f) { return orient3d(node, f[0], f[1], f[2]) > 0; });
}

std::vector<OppositeFace> opposite_faces(const WorkMesh& mesh, Index node, std::span<const Index> star) {
    std::vector<OppositeFace> faces;
    faces.reserve(star.size());
    for (const Index t : star)
        faces.push_back(places_of(mesh, facing(mesh.complex.corners(t), mesh.complex.corner_of(t, node))));
    return faces;
}

std::optional<BetterPlace> plan_move(const WorkMesh& mesh, Index node, std::span<const Index> star, double floor) {
    std::vector<OppositeFace> faces = opposite_faces(mesh, node, star);
    const auto better = find_better_place(mesh.at(node), faces, floor);
    if (!better || !is_positive_towards(better->place, faces)) return std::nullopt;
    return better;
}

namespace {

// Where the whole star is a few tets on their own, merging would take other nodes away with it.
bool keeps_neighbours(const WorkMesh& mesh, Index node, const Exchange& exchange) {
    const auto is_kept = [&](Index v) {
        return v == node || std::any_of(exchange.fresh.begin(), exchange.fresh.end(),
                                        [v](const Tet& t) { return std::find(t.begin(), t.end(), v) != t.end(); });
    };
    return std::all_of(exchange.old.begin(), exchange.old.end(), [&](Index t) {
        const Tet& corners = mesh.complex.corners(t);
        return std::all_of(corners.begin(), corners.end(), is_kept);
    });
}

}

bool plan_contraction(const WorkMesh& mesh, Index node, std::span<const Index> star, Index target, double floor,
                      Exchange& exchange) {
    exchange.clear();
    exchange.least = 1;
    for (const Index t : star) {
        exchange.old.push_back(t);
        Tet corners = mesh.complex.corners(t);
        if (std::find(corners.begin(), corners.end(), target) != corners.end()) continue;
        *std::find(corners.begin(), corners.end(), node) = target;
        exchange.least = std::min(exchange.least, shape_of(mesh, corners));
        if (!(exchange.least > floor)) return false;
        exchange.fresh.push_back(corners);
    }
    return keeps_neighbours(mesh, node, exchange) && are_positive(mesh, exchange.fresh);
}

}
