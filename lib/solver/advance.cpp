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

// What each constraint gives; a body that some of them hold fast.
void add_constraint_impulses(const Model& model, const State& state, const Workspace& w, const StepInput& input,
                             Six& given) {
    for (Index node = 0; node < model.node_count; ++node) {
        if (w.constraint[node] == 0 || model.bundle.locked[node]) continue;
        const Vec3f impulse = constraint_impulse(model, w, input.constraints[w.constraint[node] - 1]);
        add_to(given, 1, push_at(widen(position(state, node)), widen(impulse)));
    }
}

// A free body's momentum changes by what its constraints give and by what is known: so the two agree whatever the
// solve left undone.
void add_missing_momentum(const Model& model, const State& state, const Workspace& w, const StepInput& input,
                          const Ledger& ledger, const RigidLocks& locks, Six& given) {
    add_to(given, -1, ledger.momentum);
    const double dt = static_cast<double>(input.dt);
    for (std::size_t node = 0; node < model.node_count; ++node) {
        const Vec3 v = widen(velocity(state, node)) + widen(row(w.change, node));
        const Vec3 known =
            widen(outside_force(model, state, input, node)) - v * static_cast<double>(model.alpha_mass[node]);
        const Vec3 gained = v * static_cast<double>(model.bundle.mass[node]) - known * dt;
        add_to(given, 1, push_at(widen(position(state, node)), gained));
    }
    add_to(given, 1, times(locks.own_mass, locks.change));
    add_to(given, -1, locks.fall);
    add_to(given, -1, ledger.wind.push);
}

void add_impulses(const Model& model, const State& state, const Workspace& w, const StepInput& input,
                  const ConstraintCounts& constraints, const Ledger& ledger, const Whole& whole, Advanced& result) {
    Six given = ledger.wind.push;
    if (!input.forces.empty()) {
        for (std::size_t node = 0; node < model.node_count; ++node) {
            add_to(given, static_cast<double>(input.dt),
                   push_at(widen(position(state, node)), widen(input.forces[node])));
        }
    }
    if (!whole.response.is_given) {
        add_constraint_impulses(model, state, w, input, given);
    } else if (constraints.partial > 0) {
        add_missing_momentum(model, state, w, input, ledger, whole.locks, given);
    }
    result.impulse = linear_part(given);
    result.angular_impulse = angular_part(given);
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
    // Nodes that are driven leave those that stand still behind: then stopping is no way out.
    const bool is_driven = std::any_of(input.constraints.begin(), input.constraints.end(),
                                       [](const Constraint& c) { return !(c.velocity == Vec3f{}); });
    for (;;) {
        const Trial trial = propose(model, state, w, input, whole.locks);
        const double work = trial.work + ledger.wind.work + constraint_work(model, w, constraints.partial, input);
        budget = std::max(put_in + work, 0.0);
        result.energy = trial.kinetic + elastic_energy_of(trial, model, w, input, elements, kernels, jobs);
        result.has_overflowed = result.has_overflowed || trial.has_overflowed;
        const bool is_fine = result.energy <= std::max(budget_slack * budget, energy + work) + noise;
        const bool is_last = keep == 0 || (is_driven && keep < 0.1);
        if (is_fine || is_last) {
            add_impulses(model, state, w, input, constraints, ledger, whole, result);
            if (!input.reactions.empty()) write_reactions(model, w, constraints.partial, input);
            commit(model, state, trial);
            result.energy += trial.relative - trial.kinetic;
            budget = std::max(0.0, budget + trial.relative - trial.kinetic);
            break;
        }
        // A few halves, then standing still.
        const double before = keep;
        keep = keep > 0.1 || is_driven ? 0.5 * keep : 0;
        shorten_change(model, state, w, constraints, whole, 1 - keep / before);
        result.is_cut = true;
    }
    if (!std::isfinite(result.energy) || !std::isfinite(budget)) result.energy = budget = 0;
    header.energy = result.energy;
    header.budget = budget - std::max(0.0, budget - result.energy) * std::min(1.0, forgets_per_s * input.dt);
    return result;
}

}
