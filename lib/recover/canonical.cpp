// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/canonical.h"

#include <algorithm>
#include <numeric>

#include "mesh/neighbours.h"

namespace crumple::recover {

namespace {

// The even permutation of the corners that is ascending but for, perhaps, the last two.
Tet canonical_corners(Tet tet) {
    int swaps = 0;
    for (int i = 0; i < 4; ++i) {
        const auto least = std::min_element(tet.begin() + i, tet.end()) - tet.begin();
        if (least != i) {
            std::swap(tet[i], tet[least]);
            ++swaps;
        }
    }
    if (swaps % 2 != 0) std::swap(tet[2], tet[3]);
    return tet;
}

}

Canonical canonical_task(const TetMesh& mesh, const Shell& shell) {
    const auto count = static_cast<Index>(mesh.positions.size());
    std::vector<std::uint8_t> is_used(count, 0);
    for (const Tet& tet : mesh.tets) {
        for (const Index v : tet) is_used[v] = 1;
    }
    std::vector<Index> order(count);
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        const Vec3 p = mesh.positions[a];
        const Vec3 q = mesh.positions[b];
        if (p != q) return lexicographic_less(p, q);
        return is_used[a] != is_used[b] ? is_used[a] > is_used[b] : a < b;
    });
    Canonical task;
    std::vector<Index> number(count);
    for (const Index v : order) {
        if (task.original.empty() || mesh.positions[task.original.back()] != mesh.positions[v]) {
            task.original.push_back(v);
            task.mesh.positions.push_back(mesh.positions[v]);
        }
        number[v] = static_cast<Index>(task.original.size() - 1);
    }
    task.mesh.tets.reserve(mesh.tets.size());
    for (const Tet& tet : mesh.tets)
        task.mesh.tets.push_back(canonical_corners({number[tet[0]], number[tet[1]], number[tet[2]], number[tet[3]]}));
    std::sort(task.mesh.tets.begin(), task.mesh.tets.end());
    task.mesh.neighbours = neighbours_of(task.mesh.tets);
    for (Index f = 0; f < shell.triangles.size(); ++f) {
        const auto& [a, b, c] = shell.triangles[f];
        task.constraints.add_facet({number[a], number[b], number[c]}, f);
    }
    return task;
}

TetMesh original_mesh(const Canonical& task, const TetMesh& canonical, const TetMesh& input) {
    TetMesh mesh;
    mesh.positions = input.positions;
    mesh.shell_vertex_count = input.shell_vertex_count;
    std::vector<Index> number = task.original;
    number.resize(canonical.positions.size(), none);
    std::vector<std::uint8_t> is_used(canonical.positions.size(), 0);
    for (const Tet& tet : canonical.tets) {
        for (const Index v : tet) is_used[v] = 1;
    }
    for (std::size_t v = task.original.size(); v < canonical.positions.size(); ++v) {
        if (!is_used[v]) continue;
        number[v] = static_cast<Index>(mesh.positions.size());
        mesh.positions.push_back(canonical.positions[v]);
    }
    mesh.tets.reserve(canonical.tets.size());
    for (const Tet& tet : canonical.tets)
        mesh.tets.push_back({number[tet[0]], number[tet[1]], number[tet[2]], number[tet[3]]});
    mesh.neighbours = canonical.neighbours;
    return mesh;
}

}
