// SPDX-License-Identifier: MIT
// What a step reads and never writes, all of it in the model's own memory: some of a bundle's arrays, and what is
// derived from the others once. One model serves any number of states. N nodes, S simulated tets, E edges, B blocks.
#pragma once
#include <array>
#include <cstddef>
#include <span>

#include "bundle/bundle.h"
#include "solver/element_data.h"
#include "solver/rigid_motion.h"
#include "solver/slices.h"

namespace crumple::solver {

// The arrays of a bundle (see bundle.h) that a model is built from.
struct BundleView {
    std::span<const Vec3f> rest_positions;               // N
    std::span<const float> mass;                         // N
    std::span<const std::uint8_t> locked;                // N
    std::span<const Tet> tets;                           // S
    std::span<const std::array<float, 9>> inverse_rest;  // S
    std::span<const float> volume;                       // S
    std::span<const float> stiffness_scale;              // S
    std::span<const std::uint16_t> material;             // S
    std::span<const Material> materials;
    std::span<const Index> row_start;                           // N + 1
    std::span<const Index> column;                              // B
    std::span<const Index> diagonal;                            // N
    std::span<const Edge> edges;                                // E
    std::span<const std::array<Index, 2>> edge_slots;           // E
    std::span<const Index> edge_start;                          // E + 1
    std::span<const Index> edge_tet;                            // 6 S
    std::span<const std::array<std::uint8_t, 2>> edge_corners;  // 6 S
};

// REQUIRES: solver_tet_count <= the number of tets, else the view has no tets and is refused by first_problem.
[[nodiscard]] BundleView view_of(const Bundle& bundle);

// "edge_slots: row 17 is not the block of its edge": why a step could read outside the view or divide by zero; null
// when it cannot. Reads only inside the view, whatever it holds. The full proof of a bundle is crumple::validate.
[[nodiscard]] const char* first_problem(const BundleView& view);

struct ModelMaterial {
    float creep_per_s;
    float hardening_pa;
    float max_plastic_strain;
};

// Copies of a bundle's arrays.
struct ModelArrays {
    std::span<const Vec3f> rest_positions;  // N
    std::span<const float> mass;            // N
    std::span<const std::uint8_t> locked;   // N
    std::span<const Tet> tets;              // S
    std::span<const Index> edge_start;      // E + 1
};

struct Model {
    std::size_t node_count = 0;
    std::size_t tet_count = 0;
    std::size_t edge_count = 0;
    std::size_t group_count = 0;  // of eight blocks, see Slices
    ModelArrays bundle;
    bool is_uniform = true;  // lambda / mu is `ratio` everywhere
    float ratio = 0;
    double stiffness_volume = 0;  // sum of (lambda + 2 mu) V, J
    PointMasses rest_mass;        // of all nodes at rest
    std::span<const TetPacket> packets;
    Slices slices;
    std::span<const std::array<Index, 2>> edge_block;  // E: numbers of the blocks of (i, j) and (j, i)
    std::span<const Index> incidence;                  // 6 S: 16 tet + 4 corner of i + corner of j, by edge_start
    std::span<const Index> node_start;                 // N + 1
    std::span<const Index> node_corner;                // 4 S: 4 tet + corner, by node_start
    std::span<const float> alpha_mass;                 // N: mass-weighted Rayleigh damping, kg/s
    std::span<const Index> locked_nodes;               // ascending
    std::span<const ModelMaterial> materials;
};

// REQUIRES of both: first_problem(view) is null.
[[nodiscard]] std::size_t model_bytes(const BundleView& view);

// REQUIRES: memory on a 64-byte boundary, model_bytes(view) of it, that outlives the model; the view's arrays may go.
// Throws nothing.
[[nodiscard]] Model build_model(const BundleView& view, std::span<std::byte> memory);

}
