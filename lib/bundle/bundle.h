// SPDX-License-Identifier: MIT
// What a game loads: plain float and 32-bit arrays, no pointers, no package. N nodes, T tets, S of them simulated
// (solver_tet_count), E edges, B blocks of the sparse matrix. FORMAT.md beside this file is the on-disk counterpart.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"
#include "material/material.h"

namespace crumple {

// A detailed mesh bound to the tets. V vertices.
struct BundleVisual {
    std::string name;
    std::vector<Index> tet;                         // V
    std::vector<std::array<float, 4>> barycentric;  // V: sum 1 to rounding, unclamped
    std::vector<std::uint8_t> inside;               // V: 1 when the tet contains the vertex
    std::vector<float> distance;                    // V: metres outside the tet, 0 inside
    // The same by element: vertices_by_tet[tet_start[t] .. tet_start[t + 1]) move when tet t moves.
    std::vector<Index> tet_start;        // T + 1
    std::vector<Index> vertices_by_tet;  // V
};

// A named rigid frame carried by a cluster of control nodes. K nodes.
struct BundleSensor {
    std::string name;
    std::vector<Index> node;           // K, ascending
    std::vector<float> weight;         // K, positive, sum 1
    Vec3f rest_origin;                 // weighted centre of the rest positions
    std::array<float, 9> rest_axes{};  // rotation, row-major; a rest frame aligned with the world is the identity
};

struct BundleProvenance {
    std::string tool_version;
    std::string recipe;  // canonical JSON of the effective parameters
    struct Entry {
        std::string name;
        std::string value;
        friend bool operator==(const Entry&, const Entry&) = default;
    };
    std::vector<Entry> stage_versions;  // stage -> version number
    std::vector<Entry> input_digests;   // "shell", "visual/<name>" -> SHA-256; never a path, clock, host or user
};

struct Bundle {
    // Nodes
    std::vector<Vec3f> rest_positions;    // N, metres
    std::vector<float> mass;              // N, kg: a quarter of each tet's; 0 only at a locked node no tet uses
    std::vector<std::uint8_t> locked;     // N
    std::vector<Index> node_to_mesh;      // N: node of the TetMesh it came from
    std::vector<Index> mesh_to_node;      // nodes of the TetMesh: where it went, none when dropped
    std::vector<Vec3f> locked_positions;  // L: what the artist painted, lexicographic order, for check

    // Tets: [0, solver_tet_count) enter the matrix, the rest (all four nodes locked) only carry bindings
    std::uint32_t solver_tet_count = 0;
    std::vector<Tet> tets;                           // T, positive
    std::vector<std::array<float, 9>> inverse_rest;  // T: Dm^-1 row-major, Dm = [x1-x0 x2-x0 x3-x0] as columns
    std::vector<float> volume;                       // T, m^3
    std::vector<float> stiffness_scale;              // T: factor on Young's modulus, 1 by default
    std::vector<std::uint16_t> material;             // T: index into materials
    std::vector<Index> region;                       // T: shell component
    std::vector<Material> materials;
    std::vector<std::string> regions;  // name of each shell component

    // Block CSR of 3 x 3 blocks over the solver tets: every row has its diagonal, columns ascend
    std::vector<Index> row_start;                      // N + 1
    std::vector<Index> column;                         // B
    std::vector<Index> diagonal;                       // N: block of (i, i)
    std::vector<std::array<Index, 16>> element_slots;  // S: block of (corner a, corner b) at 4 a + b

    // Edges i < j of the solver tets, and who contributes to each: two edges never write the same block
    std::vector<Edge> edges;                                // E, ascending
    std::vector<std::array<Index, 2>> edge_slots;           // E: block of (i, j) and of (j, i)
    std::vector<Index> edge_start;                          // E + 1
    std::vector<Index> edge_tet;                            // 6 S
    std::vector<std::array<std::uint8_t, 2>> edge_corners;  // 6 S: corner of i and corner of j in that tet

    std::vector<BundleVisual> visuals;
    std::vector<BundleSensor> sensors;
    BundleProvenance provenance;
};

}
