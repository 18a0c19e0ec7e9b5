// SPDX-License-Identifier: MIT
#include "solver/state.h"

#include <algorithm>
#include <cstring>

#include "solver/arena.h"
#include "solver/degenerate.h"

namespace crumple::solver {
namespace {

// Nodes of a state end on a full vector of the widest processor, those of a workspace on a full slice.
std::size_t padded_nodes(const Model& model) { return (model.node_count + 3) / 4 * 4; }
std::size_t sliced_nodes(const Model& model) { return (model.node_count + slice_rows - 1) / slice_rows * slice_rows; }

State take_state(const Model& model, Plasticity plasticity, Arena& arena) {
    State state;
    state.header = arena.take<StateHeader>(1).data();
    state.positions = arena.take<float>(4 * padded_nodes(model));
    state.velocities = arena.take<float>(4 * padded_nodes(model));
    state.moved = arena.take<float>(model.node_count);
    state.tets = arena.take<TetState>(model.packets.size());
    if (plasticity == Plasticity::multiplicative) state.shapes = arena.take<TetShape>(model.packets.size());
    return state;
}

// What is written only when the blocks are assembled, so that the gradients they came from may go.
void take_solve(const Model& model, Workspace& w, Arena& arena) {
    const std::size_t node_count = sliced_nodes(model);
    w.mode_rows = arena.take<float>(mode_floats * node_count);
    w.partials = arena.take<Partial>(model.node_count);
    w.inverse = arena.take<float>(12 * node_count);
    w.change = arena.take<float>(4 * node_count);
    w.residual = arena.take<float>(4 * node_count);
    w.precise = arena.take<float>(4 * node_count);
    w.direction = arena.take<float>(4 * node_count);
    w.product = arena.take<float>(4 * node_count);
}

Workspace take_workspace(const Model& model, Arena& arena) {
    const std::size_t node_count = sliced_nodes(model);
    const std::size_t corner_floats = model.packets.size() * packet_size * 16;
    Workspace w;
    Arena of_solve;
    take_solve(model, w, of_solve);
    const auto before_solve = arena.take<std::byte>(std::max(corner_floats * sizeof(float), of_solve.used()));
    if (!before_solve.empty()) {
        w.gradients = {reinterpret_cast<float*>(before_solve.data()), corner_floats};
        of_solve = Arena(before_solve);
        take_solve(model, w, of_solve);
    }
    const std::size_t block_floats = group_floats * model.group_count;
    const auto before_blocks = arena.take<float>(std::max(corner_floats, block_floats));
    if (!before_blocks.empty()) {
        w.forces = before_blocks.first(corner_floats);
        w.blocks = before_blocks.first(block_floats);
    }
    w.load = arena.take<float>(4 * node_count);
    w.outside = w.load;
    w.damped_mass = arena.take<float>(node_count);
    w.is_fixed = arena.take<std::uint8_t>(node_count);
    w.constraint = arena.take<Index>(node_count);
    w.materials = arena.take<StepMaterial>(model.materials.size());
    w.sums = arena.take<double>(node_count / nodes_per_piece + 1);
    w.raised = arena.take<std::uint32_t>(node_count / nodes_per_piece + 1);
    w.mode_sums = arena.take<float>(mode_sums * (node_count / nodes_per_piece + 1));
    w.counts = arena.take<ElementCounts>(model.packets.size() / packets_per_piece + 1);
    return w;
}

std::array<Vec3f, 4> corners_of(const Tet& tet, std::span<const Vec3f> positions) {
    return {positions[tet[0]], positions[tet[1]], positions[tet[2]], positions[tet[3]]};
}

float six_volumes(const std::array<Vec3f, 4>& x) { return dot(x[1] - x[0], cross(x[2] - x[0], x[3] - x[0])); }

}

std::size_t state_bytes(const Model& model, Plasticity plasticity) {
    Arena arena;
    (void)take_state(model, plasticity, arena);
    return arena.used();
}

State place_state(const Model& model, Plasticity plasticity, std::span<std::byte> memory) {
    Arena arena(memory);
    return take_state(model, plasticity, arena);
}

State make_state(const Model& model, Plasticity plasticity, std::span<std::byte> memory) {
    std::memset(memory.data(), 0, state_bytes(model, plasticity));
    State state = place_state(model, plasticity, memory);
    for (std::size_t node = 0; node < model.node_count; ++node) {
        for (int i = 0; i < 3; ++i) {
            state.positions[4 * node + static_cast<std::size_t>(i)] = model.bundle.rest_positions[node][i];
        }
    }
    for (TetState& tet : state.tets) std::fill(std::begin(tet.rotation[3]), std::end(tet.rotation[3]), 1.0f);
    for (std::size_t p = 0; p < state.shapes.size(); ++p) {
        std::memcpy(state.shapes[p].gradient, model.packets[p].gradient, sizeof state.shapes[p].gradient);
    }
    return state;
}

void move_nodes(const Model& model, State& state, std::span<const Vec3f> positions, std::span<const Vec3f> from,
                float degenerate_threshold) {
    for (std::size_t node = 0; node < model.node_count; ++node) {
        for (int i = 0; i < 3; ++i) state.positions[4 * node + static_cast<std::size_t>(i)] = positions[node][i];
    }
    for (std::size_t t = 0; t < model.packets.size() * packet_size; ++t) {
        const std::size_t real = std::min(t, model.tet_count - 1);
        const float volume = 6 * model.packets[real / packet_size].volume[real % packet_size];
        const CollapsePath path{corners_of(model.bundle.tets[real], from),
                                corners_of(model.bundle.tets[real], positions), volume, degenerate_threshold};
        const bool is_fine = six_volumes(path.to) > degenerate_threshold * volume;
        state.tets[t / packet_size].collapse[t % packet_size] =
            is_fine ? std::uint8_t{0} : static_cast<std::uint8_t>(classify_collapse(path));
    }
}

std::size_t workspace_bytes(const Model& model) {
    Arena arena;
    (void)take_workspace(model, arena);
    return arena.used();
}

Workspace make_workspace(const Model& model, std::span<std::byte> memory) {
    std::memset(memory.data(), 0, workspace_bytes(model));
    Arena arena(memory);
    return take_workspace(model, arena);
}

}
