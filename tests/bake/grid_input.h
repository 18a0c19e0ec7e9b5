// SPDX-License-Identifier: GPL-3.0-or-later
// A cube of tets as the stages before bake would hand it over: boundary nodes first, they are the shell.
#pragma once
#include <algorithm>
#include <numeric>

#include "bake/bake.h"
#include "core/random.h"
#include "mesh/shapes.h"

namespace crumple::test {

struct BakeInput {
    Asset asset;
    TetMesh mesh;
    Bindings bindings;
};

// Puts node order[k] in place k.
inline void renumber(TetMesh& mesh, const std::vector<Index>& order) {
    std::vector<Index> place(order.size());
    std::vector<Vec3> positions;
    for (Index k = 0; k < order.size(); ++k) {
        place[order[k]] = k;
        positions.push_back(mesh.positions[order[k]]);
    }
    mesh.positions = positions;
    for (Tet& tet : mesh.tets) {
        for (Index& node : tet) node = place[node];
    }
}

inline void lock(Asset& asset, Index vertex) {
    asset.shell.locked[vertex] = 1;
    asset.locked_positions.push_back(asset.shell.positions[vertex]);
    std::sort(asset.locked_positions.begin(), asset.locked_positions.end(), lexicographic_less<double>);
}

// The unit cube cut into cells^3 cubes; every vertex with y <= lock_below is locked. One visual vertex at the centre of
// each tet, bound with weights that tell the corners apart.
inline BakeInput grid_input(int cells = 3, double lock_below = -1) {
    BakeInput input;
    TetMesh& mesh = input.mesh;
    mesh = shapes::tet_grid(cells);
    const auto is_boundary = [&](Index node) {
        const Vec3 p = mesh.positions[node];
        return p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1 || p.z == 0 || p.z == 1;
    };
    std::vector<Index> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto interior = std::stable_partition(order.begin(), order.end(), is_boundary);
    mesh.shell_vertex_count = static_cast<Index>(interior - order.begin());
    renumber(mesh, order);
    mesh.neighbours.clear();

    Shell& shell = input.asset.shell;
    shell.positions.assign(mesh.positions.begin(), mesh.positions.begin() + mesh.shell_vertex_count);
    shell.locked.assign(shell.positions.size(), 0);
    shell.components.push_back({"body", "paint", Role::solid, "", 1, true, false, none});
    for (Index vertex = 0; vertex < shell.positions.size(); ++vertex) {
        shell.triangles.push_back({vertex, vertex, vertex});  // only says which component the vertex belongs to
        shell.component.push_back(0);
        if (shell.positions[vertex].y <= lock_below) lock(input.asset, vertex);
    }
    VisualBinding binding;
    binding.name = "paint";
    for (Index t = 0; t < mesh.tets.size(); ++t) {
        binding.tet.push_back(t);
        binding.barycentric.push_back({0.1, 0.2, 0.3, 0.4});
        binding.inside.push_back(1);
        binding.distance.push_back(0);
    }
    input.bindings.push_back(binding);
    return input;
}

// The same input with its nodes and tets in a random order, corners turned evenly.
inline BakeInput shuffled(BakeInput input, std::uint64_t seed) {
    Rng rng(seed);
    const auto shuffle = [&](auto begin, auto end) {
        for (auto i = end - begin; i > 1; --i)
            std::swap(begin[i - 1], begin[rng.next_below(static_cast<std::uint32_t>(i))]);
    };
    TetMesh& mesh = input.mesh;
    std::vector<Index> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    shuffle(order.begin(), order.begin() + mesh.shell_vertex_count);
    shuffle(order.begin() + mesh.shell_vertex_count, order.end());
    renumber(mesh, order);
    Shell& shell = input.asset.shell;
    const std::vector<std::uint8_t> locked = shell.locked;
    for (Index vertex = 0; vertex < shell.positions.size(); ++vertex) {
        shell.positions[vertex] = mesh.positions[vertex];
        shell.locked[vertex] = locked[order[vertex]];
    }
    std::vector<Index> tet_order(mesh.tets.size());
    std::iota(tet_order.begin(), tet_order.end(), 0u);
    shuffle(tet_order.begin(), tet_order.end());
    const std::vector<Tet> tets = mesh.tets;
    for (Index t = 0; t < tets.size(); ++t) {
        const Tet& tet = tets[tet_order[t]];
        mesh.tets[t] = {tet[1], tet[2], tet[0], tet[3]};
    }
    for (VisualBinding& binding : input.bindings) {
        std::vector<Index> place(tets.size());
        for (Index t = 0; t < tets.size(); ++t) place[tet_order[t]] = t;
        for (std::size_t v = 0; v < binding.tet.size(); ++v) {
            binding.tet[v] = place[binding.tet[v]];
            const auto w = binding.barycentric[v];
            binding.barycentric[v] = {w[1], w[2], w[0], w[3]};
        }
    }
    return input;
}

inline bake::Result bake_input(const BakeInput& input, const bake::Params& params = {}) {
    return bake::bake_bundle(input.asset, input.mesh, input.bindings, params);
}

}
