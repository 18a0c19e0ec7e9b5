// SPDX-License-Identifier: GPL-3.0-or-later
#include "gates/bundle_mesh.h"

#include "mesh/neighbours.h"

namespace crumple::gates {

namespace {

// V: where a shell vertex is among the mesh's nodes; the mesh grows by those it lacks.
std::vector<Index> nodes_of(const Bundle& bundle, const Shell& shell, TetMesh& mesh) {
    std::vector<Index> node(shell.positions.size(), none);
    for (std::size_t v = 0; v < node.size(); ++v) {
        if (v < bundle.mesh_to_node.size()) node[v] = bundle.mesh_to_node[v];
        if (node[v] != none) continue;
        node[v] = static_cast<Index>(mesh.positions.size());
        mesh.positions.push_back(shell.positions[v]);
    }
    return node;
}

}

TetMesh mesh_of(const Bundle& bundle) {
    TetMesh mesh;
    mesh.positions.reserve(bundle.rest_positions.size());
    for (const Vec3f p : bundle.rest_positions) mesh.positions.push_back(widen(p));
    mesh.tets = bundle.tets;
    mesh.neighbours = neighbours_of(mesh.tets);
    mesh.region = bundle.region;
    return mesh;
}

Bindings bindings_of(const Bundle& bundle) {
    Bindings bindings;
    for (const BundleVisual& visual : bundle.visuals) {
        VisualBinding& binding = bindings.emplace_back();
        binding.name = visual.name;
        binding.tet = visual.tet;
        binding.inside = visual.inside;
        for (const auto& [a, b, c, d] : visual.barycentric) binding.barycentric.push_back({a, b, c, d});
        binding.distance.assign(visual.distance.begin(), visual.distance.end());
    }
    return bindings;
}

Shell shell_over(const Bundle& bundle, const Shell& shell, TetMesh& mesh) {
    const std::vector<Index> node = nodes_of(bundle, shell, mesh);
    Shell over = shell;
    over.positions = mesh.positions;
    for (Triangle& corners : over.triangles) {
        for (Index& v : corners) v = node[v];
    }
    return over;
}

}
