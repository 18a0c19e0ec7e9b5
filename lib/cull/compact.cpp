// SPDX-License-Identifier: GPL-3.0-or-later
#include "cull/compact.h"

#include <vector>

#include "mesh/neighbours.h"

namespace crumple::cull {

namespace {

// New index of every node, none for those that go; moves the positions.
std::vector<Index> close_ranks(TetMesh& mesh) {
    std::vector<Index> number(mesh.positions.size(), none);
    for (const Tet& tet : mesh.tets) {
        for (const Index v : tet) number[v] = 0;
    }
    Index count = 0;
    for (Index v = 0; v < mesh.positions.size(); ++v) {
        if (number[v] == none && v >= mesh.shell_vertex_count) continue;
        mesh.positions[count] = mesh.positions[v];
        number[v] = count++;
    }
    mesh.positions.resize(count);
    return number;
}

}

TetMesh compact(TetMesh mesh, std::span<const Index> region) {
    mesh.region.clear();
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        if (region[t] == none) continue;
        mesh.tets[kept++] = mesh.tets[t];
        mesh.region.push_back(region[t]);
    }
    mesh.tets.resize(kept);
    const std::vector<Index> number = close_ranks(mesh);
    for (Tet& tet : mesh.tets) {
        for (Index& v : tet) v = number[v];
    }
    mesh.neighbours = neighbours_of(mesh.tets);
    return mesh;
}

}
