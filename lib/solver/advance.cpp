// SPDX-License-Identifier: MIT
#include "solver/advance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/outside.h"

namespace crumple::solver {
namespace {

// Strains of float rounding, 1e-7 and a little, hold this part of (lambda + 2 mu) V; they are no motion.
constexpr double noise_strain_squared = 1e-12;
constexpr double forgets_per_s = 1;  // how fast the budget comes down to what is there

bool is_finite(Vec3f v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Vec3f row(std::span<const float> rows, std::size_t node) {
    return {rows[4 * node], rows[4 * node + 1], rows[4 * node + 2]};
}

void set_row(std::span<float> rows, std::size_t node, Vec3f v) {
    for (int i = 0; i < 3; ++i) rows[4 * node + static_cast<std::size_t>(i)] = v[i];
}

// Where the change leads, in memory the solve no longer needs.
struct Trial {
    std::span<float> positions;
    std::span<float> velocities;
    double kinetic = 0;   // seen from the frame as it was
    double relative = 0;  // seen from the frame as the carrier leaves it
    double work = 0;      // of gravity and forces on the way
    bool has_overflowed = false;
};

// A node whose numbers overflow stops where it is.
Trial propose(const Model& model, const State& state, Workspace& w, const StepInput& input, const RigidLocks& locks) {
    Trial trial{w.product, w.precise};
    for (std::size_t node = 0; node < model.node_count; ++node) {
        Vec3f v = velocity(state, node);
        if (!w.is_fixed[node]) v += row(w.change, node);
        Vec3f u = v;
        if (locks.is_active) {
            u = is_carried(model, w, node)
                    ? Vec3f{}
                    : narrow(widen(v) - rigid_velocity(locks.change, widen(position(state, node))));
        }
        Vec3f x = position(state, node) + u * input.dt;
        if (!is_finite(u) || !is_finite(x)) {
            trial.has_overflowed = true;
            u = v = {};
            x = position(state, node);
        }
        set_row(trial.positions, node, x);
        set_row(trial.velocities, node, u);
        trial.positions[4 * node + 3] = trial.velocities[4 * node + 3] = 0;  // what the solve left there
        const double mass = model.bundle.mass[node];
        const Vec3f push = working_force(model, state, input, node);
        trial.kinetic += 0.5 * mass * static_cast<double>(dot(v, v));
        trial.relative += 0.5 * mass * static_cast<double>(dot(u, u));
        trial.work += static_cast<double>(dot(push, v)) * static_cast<double>(input.dt);
    }
    trial.kinetic += 0.5 * dot6(locks.change, times(locks.own_mass, locks.change));
    trial.work += dot6(locks.change, locks.fall);
    return trial;
}

double elastic_energy_of(const Trial& trial, const Model& model, Workspace& w, const StepInput& input,
                         ElementJob elements, const Kernels& kernels, const Jobs& jobs) {
    elements.positions = trial.positions.data();
    elements.velocities = trial.velocities.data();
    elements.settings.last_dt = input.dt;
    for_pieces(jobs, model.packets.size(), packets_per_piece, [&](std::size_t piece, std::size_t b, std::size_t e) {
        w.counts[piece].energy = kernels.energies(elements, b, e);
    });
    double total = 0;
    for (std::size_t i = 0; i * packets_per_piece < model.packets.size(); ++i) total += w.counts[i].energy;
    return total;
}

void commit(const Model& model, State& state, const Trial& trial) {
    for (std::size_t node = 0; node < model.node_count; ++node) {
        // Squares of what is still a float may be none any more.
        const float way = state.moved[node] + length(row(trial.positions, node) - position(state, node));
        state.moved[node] = std::min(way, std::numeric_limits<float>::max());
    }
    std::copy_n(trial.positions.begin(), 4 * model.node_count, state.positions.begin());
    std::copy_n(trial.velocities.begin(), 4 * model.node_count, state.velocities.begin());
}

}

Advanced advance(const Model& model, State& state, Workspace& w, const StepInput& input,
                 const ConstraintCounts& constraints, const ElementJob& elements, const Ledger& ledger, Whole& whole,
                 const Kernels& kernels, const Jobs& jobs) {
    StateHeader& header = *state.header;
    const double energy = ledger.energy;
    const double put_in = header.step_count == 0 ? energy : header.budget + energy - header.energy;
    const double noise = noise_strain_squared * model.stiffness_volume;
    Advanced result;
    double budget = 0;
    double keep = 1;
    Pushes pushes(model, state, w, input, w.partials.first(constraints.partial), ledger, whole);
    // Nodes that are driven leave those that stand still behind: then stopping is no way out.
    const bool is_driven = std::any_of(input.constraints.begin(), input.constraints.end(), [](const Constraint& c) {
        return c.kind != ConstraintKind::contact && !(c.velocity == Vec3f{});
    });
    for (;;) {
        const Trial trial = propose(model, state, w, input, whole.locks);
        const double work = trial.work + ledger.wind.work + pushes.work(result.is_cut);
        budget = std::max(put_in + work, 0.0);
        result.energy = trial.kinetic + elastic_energy_of(trial, model, w, input, elements, kernels, jobs);
        result.has_overflowed = result.has_overflowed || trial.has_overflowed;
        const bool is_fine = result.energy <= std::max(budget_slack * budget, energy + work) + noise;
        const bool is_last = is_driven ? keep < 0.1 : keep == 0 && !pushes.has_contacts();
        if (is_fine || is_last) {
            const Six given = pushes.given();
            result.impulse = linear_part(given);
            result.angular_impulse = angular_part(given);
            if (!input.reactions.empty()) pushes.write_reactions(result.is_cut);
            commit(model, state, trial);
            result.energy += trial.relative - trial.kinetic;
            budget = std::max(0.0, budget + trial.relative - trial.kinetic);
            break;
        }
        // A few halves, then standing still, then without contacts.
        if (keep == 0) pushes.let_go_of_contacts();
        const double before = keep;
        keep = keep > 0.1 || is_driven ? 0.5 * keep : 0;
        shorten_change(model, state, w, constraints, whole, before > 0 ? 1 - keep / before : 1);
        result.is_cut = true;
    }
    if (!std::isfinite(result.energy) || !std::isfinite(budget)) result.energy = budget = 0;
    header.energy = result.energy;
    header.budget = budget - std::max(0.0, budget - result.energy) * std::min(1.0, forgets_per_s * input.dt);
    return result;
}

}
