// SPDX-License-Identifier: MIT
#include "solver/rigid_modes.h"

#include <algorithm>
#include <cmath>

#include "solver/constraints.h"

namespace crumple::solver {
namespace {

ModeJob mode_job(const Model& model, const State& state, Workspace& w) {
    return {model.slices.node.data(), model.slices.start.data(), model.slices.column.data(), w.blocks.data(),
            state.positions.data(),   w.mode_rows.data(),        w.precise.data(),           w.direction.data()};
}

// Columns of [I, -[x]].
struct Columns {
    Vec3f z[6];
};
Columns columns_at(Vec3f x) {
    return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -x.z, x.y}, {x.z, 0, -x.x}, {-x.y, x.x, 0}}};
}

// rows += s A (the taken part of Z at the node)
void add_taken(const Model& model, const State& state, Workspace& w, const Partial& p, float s) {
    Columns taken = columns_at(position(state, p.node));
    for (Vec3f& column : taken.z) column = taken_part(p, column) * s;
    for_row(model.slices, p.node, [&](Index column, std::size_t number) {
        float* row = &w.mode_rows[mode_floats * std::size_t{column}];
        // The block of the other row is the transpose.
        const Mat3 block = transpose(block_at(w.blocks, number));
        for (std::size_t m = 0; m < 6; ++m) {
            const Vec3f answer = block * taken.z[m];
            for (std::size_t axis = 0; axis < 3; ++axis) row[8 * axis + m] += answer[static_cast<int>(axis)];
        }
    });
}

// energy += s Z^T (row of A Z)
void add_energy(const Columns& at, const float* row, float s, Matrix6& energy) {
    for (std::size_t r = 0; r < 6; ++r) {
        const Vec3f z = at.z[r] * s;
        for (std::size_t m = 0; m < 6; ++m) {
            energy[6 * r + m] += static_cast<double>(z.x * row[m] + z.y * row[8 + m] + z.z * row[16 + m]);
        }
    }
}

// Z^T A Z of all nodes, Z in the free part of partials.
Matrix6 energy_of(const Model& model, const State& state, Workspace& w, std::span<const Partial> partials,
                  const Kernels& kernels, const Jobs& jobs) {
    const ModeJob job = mode_job(model, state, w);
    for_pieces(jobs, model.node_count, nodes_per_piece, [&](std::size_t piece, std::size_t b, std::size_t e) {
        kernels.mode_energies(job, b, e, &w.mode_sums[mode_sums * piece]);
    });
    Matrix6 energy{};
    for (std::size_t piece = 0; piece * nodes_per_piece < model.node_count; ++piece) {
        for (std::size_t r = 0; r < 6; ++r) {
            for (std::size_t m = 0; m < 6; ++m) energy[6 * r + m] += w.mode_sums[mode_sums * piece + 8 * r + m];
        }
    }
    for (const Partial& p : partials) {
        Columns taken = columns_at(position(state, p.node));
        for (Vec3f& column : taken.z) column = taken_part(p, column);
        add_energy(taken, &w.mode_rows[mode_floats * std::size_t{p.node}], -1, energy);
    }
    return energy;
}

Six pushes(const Model& model, const State& state, const Workspace& w, std::span<const float> rows) {
    Six sum{};
    for (std::size_t node = 0; node < model.node_count; ++node) {
        if (is_carried(model, w, node)) continue;
        add_to(sum, 1, push_at(widen(position(state, node)), {rows[4 * node], rows[4 * node + 1], rows[4 * node + 2]}));
    }
    return sum;
}

Six transposed_times(const Matrix6& m, const Six& v) {
    Six result{};
    for (std::size_t r = 0; r < 6; ++r) {
        for (std::size_t c = 0; c < 6; ++c) result[c] += m[6 * r + c] * v[r];
    }
    return result;
}

RigidField minus_field(const Six& a) {
    RigidField field{};
    const Vec3f v = -narrow(linear_part(a));
    const Vec3f w = -narrow(angular_part(a));
    const Vec3f parts[4] = {v, {0, w.z, -w.y}, {-w.z, 0, w.x}, {w.y, -w.x, 0}};
    float* rows[4] = {field.constant, field.by_x, field.by_y, field.by_z};
    for (std::size_t part = 0; part < 4; ++part) {
        for (std::size_t i = 0; i < 16; ++i) rows[part][i] = i % 4 < 3 ? parts[part][static_cast<int>(i % 4)] : 0;
    }
    return field;
}

}

void RigidModes::prepare(const Model& model, const State& state, Workspace& w, std::span<const Partial> partials,
                         const RigidLocks& locks, const Kernels& kernels, const Jobs& jobs) {
    const ModeJob job = mode_job(model, state, w);
    for_pieces(jobs, model.node_count, nodes_per_piece,
               [&](std::size_t, std::size_t b, std::size_t e) { kernels.multiply_modes(job, b, e); });
    for (const Partial& p : partials) add_taken(model, state, w, p, -1);
    refresh(model, state, w, partials, locks, kernels, jobs);
}

void RigidModes::follow(const Model& model, const State& state, Workspace& w, const Partial& partial) {
    Partial held = partial;
    held.taken_count = 1;
    add_taken(model, state, w, held, partial.taken_count == 0 ? 1.0f : -1.0f);
}

void RigidModes::refresh(const Model& model, const State& state, Workspace& w, std::span<const Partial> partials,
                         const RigidLocks& locks, const Kernels& kernels, const Jobs& jobs) {
    carrier_ = locks.own_mass;
    for (const Index node : model.locked_nodes) {
        if (!locks.is_active || !is_carried(model, w, node)) continue;
        add_energy(columns_at(position(state, node)), &w.mode_rows[mode_floats * std::size_t{node}], 1, carrier_);
    }
    Matrix6 energy = energy_of(model, state, w, partials, kernels, jobs);
    for (std::size_t i = 0; i < 36; ++i) energy[i] += locks.own_mass[i];
    for (std::size_t r = 0; r < 6; ++r) {
        for (std::size_t c = 0; c < r; ++c) {
            energy[6 * r + c] = energy[6 * c + r] = 0.5 * (energy[6 * r + c] + energy[6 * c + r]);
        }
    }
    inverse_ = inverse_of(energy, 1e-12);
    const Six ones{1, 1, 1, 1, 1, 1};
    is_active_ = inverse_[0] > 0 && std::isfinite(dot6(times(inverse_, ones), ones));
}

void RigidModes::balance(const Model& model, const State& state, Workspace& w, std::span<const Partial> partials,
                         RigidLocks& locks) const {
    if (!is_active_) return;
    Six owed = pushes(model, state, w, w.residual);
    add_to(owed, 1, locks.residual);
    const Six a = times(inverse_, owed);
    for (std::size_t node = 0; node < model.node_count; ++node) {
        const Vec3f v = narrow(rigid_velocity(a, widen(position(state, node))));
        const float* row = &w.mode_rows[mode_floats * node];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            w.change[4 * node + axis] += v[static_cast<int>(axis)];
            double answered = 0;
            for (std::size_t m = 0; m < 6; ++m) answered += static_cast<double>(row[8 * axis + m]) * a[m];
            if (!is_carried(model, w, node)) w.residual[4 * node + axis] -= static_cast<float>(answered);
        }
    }
    for (const Partial& p : partials) {
        const Vec3f taken = taken_part(p, narrow(rigid_velocity(a, widen(position(state, p.node)))));
        for (int i = 0; i < 3; ++i) w.change[4 * std::size_t{p.node} + static_cast<std::size_t>(i)] -= taken[i];
        keep_free_part(p, &w.residual[4 * std::size_t{p.node}]);
    }
    add_to(locks.change, 1, a);
    add_to(locks.residual, -1, times(carrier_, a));
}

void RigidModes::deflate(const Model& model, const State& state, Workspace& w, std::span<const Partial> partials,
                         RigidLocks& locks, const Kernels& kernels, const Jobs& jobs) const {
    if (!is_active_) return;
    const ModeJob job = mode_job(model, state, w);
    for_pieces(jobs, model.node_count, nodes_per_piece, [&](std::size_t piece, std::size_t b, std::size_t e) {
        kernels.dot_modes(job, b, e, &w.mode_sums[8 * piece]);
    });
    Six along = transposed_times(carrier_, locks.precise);
    for (std::size_t piece = 0; piece * nodes_per_piece < model.node_count; ++piece) {
        for (std::size_t m = 0; m < 6; ++m) along[m] += static_cast<double>(w.mode_sums[8 * piece + m]);
    }
    const Six mu = times(inverse_, along);
    const RigidField field = minus_field(mu);
    for_pieces(jobs, model.node_count, nodes_per_piece,
               [&](std::size_t, std::size_t b, std::size_t e) { kernels.subtract_motion(job, field, b, e); });
    for (const Partial& p : partials) keep_free_part(p, &w.direction[4 * std::size_t{p.node}]);
    add_to(locks.direction, -1, mu);
}

}
