// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/figures.h"

#include <algorithm>

#include "mesh/boundary.h"

namespace crumple::quality {

namespace {

Topology measure_topology(const TetMesh& mesh, std::span<const Triangle> faces) {
    Topology topology;
    const NonManifold places = non_manifold(faces);
    topology.non_manifold_edges = places.edges.size();
    topology.non_manifold_vertices = places.vertices.size();
    const std::vector<Index> piece = pieces_of(mesh);
    if (!piece.empty()) topology.pieces = *std::max_element(piece.begin(), piece.end()) + std::uint64_t{1};
    return topology;
}

}

Figures measure(const TetMesh& mesh, const Shell* shell, const Context& context) {
    Figures figures;
    figures.shape = summarize(mesh, context);
    figures.cost = measure_cost(mesh.positions, mesh.tets, context);
    const std::vector<Triangle> faces = boundary_of(mesh).faces;
    figures.topology = measure_topology(mesh, faces);
    const Surface surface = shell ? Surface{shell->positions, shell->triangles} : Surface{mesh.positions, faces};
    const std::vector<ShellLimit> limits = find_limits(surface, mesh.positions, mesh.tets, context);
    figures.below_10_thin = static_cast<std::uint64_t>(std::count(limits.begin(), limits.end(), ShellLimit::thin));
    figures.below_10_needle = static_cast<std::uint64_t>(std::count(limits.begin(), limits.end(), ShellLimit::needle));
    return figures;
}

}
