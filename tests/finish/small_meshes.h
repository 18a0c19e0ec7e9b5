// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of a few tets made by hand, so that each operation can be watched alone.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "finish/work_mesh.h"
#include "geometry/measures.h"
#include "geometry/predicates.h"
#include "mesh/boundary.h"
#include "mesh/neighbours.h"
#include "mesh/shapes.h"
#include "mesh/shell.h"

namespace crumple::finish::small {

inline TetMesh mesh_of(std::vector<Vec3> positions, std::vector<Tet> tets, Index shell_vertex_count) {
    TetMesh mesh;
    mesh.positions = std::move(positions);
    for (Vec3& p : mesh.positions) p = round_to_float(p);
    mesh.shell_vertex_count = shell_vertex_count;
    mesh.tets = std::move(tets);
    mesh.neighbours = neighbours_of(mesh.tets);
    mesh.region.assign(mesh.tets.size(), 0);
    return mesh;
}

// Nodes 0 and 1 at (0, 0, -height) and (0, 0, height), n nodes around them on the unit circle, n tets around the edge.
inline TetMesh ring(int n, double height) {
    std::vector<Vec3> positions{{0, 0, -height}, {0, 0, height}};
    std::vector<Tet> tets;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        positions.push_back({std::cos(angle), std::sin(angle), 0.02 * (i % 2)});
        tets.push_back({0, 1, static_cast<Index>(2 + i), static_cast<Index>(2 + (i + 1) % n)});
    }
    return mesh_of(positions, tets, static_cast<Index>(positions.size()));
}

// The same nodes without the edge: tets over and under a fan of triangles from the first node of the circle.
inline TetMesh double_fan(int n, double height) {
    TetMesh mesh = ring(n, height);
    mesh.tets.clear();
    for (Index i = 1; i + 1 < static_cast<Index>(n); ++i) {
        mesh.tets.push_back({2, 2 + i, 3 + i, 1});
        mesh.tets.push_back({2, 3 + i, 2 + i, 0});
    }
    mesh.neighbours = neighbours_of(mesh.tets);
    mesh.region.assign(mesh.tets.size(), 0);
    return mesh;
}

// The six faces of a box as fans around `centre`, node 8: 12 tets.
inline TetMesh box_around(Vec3 centre) {
    std::vector<Vec3> positions;
    for (int i = 0; i < 8; ++i) positions.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
    positions.push_back(centre);
    static constexpr Index faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    std::vector<Tet> tets;
    for (const auto& f : faces) {
        tets.push_back({f[0], f[1], f[2], 8});
        tets.push_back({f[0], f[2], f[3], 8});
    }
    for (Tet& t : tets) {
        if (orient3d(positions[t[0]], positions[t[1]], positions[t[2]], positions[t[3]]) < 0) std::swap(t[0], t[1]);
    }
    return mesh_of(positions, tets, 8);
}

// The tets of a grid of unit cells whose cell is wanted; cells count from the low corner.
inline TetMesh cells(int per_axis, const std::function<bool(int x, int y, int z)>& is_wanted) {
    TetMesh mesh = shapes::tet_grid(per_axis, {0, 0, 0}, Vec3{1, 1, 1} * per_axis);
    std::erase_if(mesh.tets, [&](const Tet& tet) {
        Vec3 sum{};
        for (const Index v : tet) sum += mesh.positions[v];
        return !is_wanted(static_cast<int>(sum.x / 4), static_cast<int>(sum.y / 4), static_cast<int>(sum.z / 4));
    });
    mesh.region.assign(mesh.tets.size(), 0);
    mesh.neighbours = neighbours_of(mesh.tets);
    return mesh;
}

inline Index node_at(const TetMesh& mesh, Vec3 place) {
    return static_cast<Index>(std::find(mesh.positions.begin(), mesh.positions.end(), place) - mesh.positions.begin());
}

inline double volume_of(const TetMesh& mesh) {
    double volume = 0;
    for (const auto& [a, b, c, d] : mesh.tets)
        volume += signed_volume(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]);
    return volume;
}

inline bool is_all_positive(const TetMesh& mesh) {
    for (const auto& [a, b, c, d] : mesh.tets) {
        if (orient3d(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]) <= 0) return false;
    }
    return true;
}

inline double worst_of(const TetMesh& mesh) {
    double least = 1;
    for (const auto& [a, b, c, d] : mesh.tets)
        least = std::min(least, shape_of(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]));
    return least;
}

// The surface of a mesh as a shell of one unpainted component.
inline Shell shell_of(const TetMesh& mesh) {
    Shell shell;
    shell.positions.assign(mesh.positions.begin(), mesh.positions.begin() + mesh.shell_vertex_count);
    shell.triangles = boundary_of(mesh).faces;
    shell.locked.assign(shell.positions.size(), 0);
    shell.component.assign(shell.triangles.size(), 0);
    shell.components.emplace_back().name = "body";
    return shell;
}

}
