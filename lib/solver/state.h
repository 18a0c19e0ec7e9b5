// SPDX-License-Identifier: MIT
// One body in motion. A State lies in one block of the caller's memory: copying the block saves it, copying it back
// restores it, equal bytes are equal states. A Workspace holds what does not outlive a step; bodies stepped one after
// the other can share one.
#pragma once
#include <cstddef>
#include <span>

#include "solver/kernels.h"
#include "solver/model.h"

namespace crumple::solver {

struct StateHeader {
    std::uint64_t step_count = 0;
    float last_dt = 0;
    float quiet_s = 0;   // how long it has hardly moved
    double energy = 0;   // kinetic and elastic, J, at the end of the last step
    double budget = 0;   // what was put in and is not known to be gone, J
    Vec3f sleep_centre;  // ball around the sleeping body
    float sleep_radius = 0;
    Vec3f sleep_pull;  // gravity and inertia it fell asleep under, m/s^2
    std::uint32_t is_asleep = 0;
};

struct State {
    StateHeader* header = nullptr;
    std::span<float> positions;   // N x 4, metres; the fourth is 0. Room for a multiple of four nodes
    std::span<float> velocities;  // N x 4, m/s
    std::span<float> moved;       // N, metres travelled since the drawn vertices were last taken (see skin.h)
    std::span<TetState> tets;     // packets
    std::span<TetShape> shapes;   // packets, empty unless the plasticity is multiplicative
};

[[nodiscard]] std::size_t state_bytes(const Model& model, Plasticity plasticity);

// REQUIRES: memory on a 64-byte boundary, state_bytes of it. place_state finds a state in memory it was made in (or
// copied to); make_state starts one at rest.
[[nodiscard]] State place_state(const Model& model, Plasticity plasticity, std::span<std::byte> memory);
[[nodiscard]] State make_state(const Model& model, Plasticity plasticity, std::span<std::byte> memory);

// Puts the nodes at `positions` as if they had come straight from `from` (both N): tets that are degenerate now
// collapsed on that way. Velocities, rotations and plastic strain stay.
void move_nodes(const Model& model, State& state, std::span<const Vec3f> positions, std::span<const Vec3f> from,
                float degenerate_threshold = 0.1f);

[[nodiscard]] inline Vec3f position(const State& state, std::size_t node) {
    return {state.positions[4 * node], state.positions[4 * node + 1], state.positions[4 * node + 2]};
}
[[nodiscard]] inline Vec3f velocity(const State& state, std::size_t node) {
    return {state.velocities[4 * node], state.velocities[4 * node + 1], state.velocities[4 * node + 2]};
}
inline void set_velocity(State& state, std::size_t node, Vec3f v) {
    for (int i = 0; i < 3; ++i) state.velocities[4 * node + static_cast<std::size_t>(i)] = v[i];
}

// What a constraint leaves free of a node: all but the directions `taken` and, where there is a second, `also_taken`.
struct Partial {
    Index node;
    int taken_count;  // 1: plane or a contact that holds, 2: rail, 0: a contact that lets go
    Vec3f taken;
    Vec3f also_taken;
    bool is_contact;
    float least;  // of a contact: m/s along `taken`
};

struct Workspace {
    // Until the blocks are assembled. Its memory is then that of what follows, up to `product`.
    std::span<float> gradients;        // packets x 16 x 16
    std::span<float> mode_rows;        // N x 24, see rigid_modes.h
    std::span<Partial> partials;       // N, the first partial_count are used
    std::span<float> inverse;          // see inverse_at()
    std::span<float> change;           // N x 4
    std::span<float> residual;         // N x 4
    std::span<float> precise;          // N x 4
    std::span<float> direction;        // N x 4
    std::span<float> product;          // N x 4
    std::span<float> forces;           // packets x 16 x 16; its memory is then that of blocks
    std::span<float> blocks;           // see Slices
    std::span<float> outside;          // N x 4; its memory is then that of load
    std::span<float> load;             // N x 4
    std::span<float> damped_mass;      // N
    std::span<std::uint8_t> is_fixed;  // N
    std::span<Index> constraint;       // N: 1 + row of the step's constraints, 0 for none
    std::span<StepMaterial> materials;
    std::span<double> sums;           // one a piece
    std::span<ElementCounts> counts;  // one a piece
    std::span<std::uint32_t> raised;  // one a piece of nodes
    std::span<float> mode_sums;       // 48 a piece of nodes
};

[[nodiscard]] std::size_t workspace_bytes(const Model& model);
[[nodiscard]] Workspace make_workspace(const Model& model, std::span<std::byte> memory);

// Pieces of the loops, nodes_per_piece beside them: large enough to be worth a thread.
inline constexpr std::size_t packets_per_piece = 8;
inline constexpr std::size_t edges_per_piece = 1024;

}
