// SPDX-License-Identifier: MIT
#include "solver/step.h"

#include <algorithm>
#include <cmath>

#include "solver/advance.h"
#include "solver/check_input.h"
#include "solver/measure.h"
#include "solver/outside.h"
#include "solver/solve.h"

namespace crumple::solver {
namespace {

// Velocities meet their constraints; `outside` becomes dt (gravity and forces) - dt alpha m v, and at constrained nodes
// the momentum the constraint takes, which is part of its reaction.
void start_velocities(const Model& model, State& state, Workspace& w, const StepInput& input) {
    const float dt = input.dt;
    for (Index node = 0; node < model.node_count; ++node) {
        const float mass = model.bundle.mass[node];
        const Vec3f before = velocity(state, node);
        const Vec3f v = constrained_velocity(w, input, node, before);
        set_velocity(state, node, v);
        const Vec3f outside =
            (outside_force(model, state, input, node) - v * model.alpha_mass[node]) * dt + (before - v) * mass;
        for (int i = 0; i < 3; ++i) w.outside[4 * node + static_cast<std::size_t>(i)] = outside[i];
        w.damped_mass[node] = mass + dt * model.alpha_mass[node];
    }
}

ElementJob element_job(const Model& model, State& state, Workspace& w, const StepInput& input,
                       const Settings& settings) {
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
        const ModelMaterial& m = model.materials[i];
        w.materials[i] = {static_cast<float>(flowing_part(m.creep_per_s, input.dt)), m.hardening_pa,
                          m.max_plastic_strain};
    }
    ElementJob job{
        model.packets.data(),   state.tets.data(),       state.shapes.empty() ? nullptr : state.shapes.data(),
        state.positions.data(), state.velocities.data(), w.gradients.data(),
        w.forces.data(),        w.materials.data(),      {}};
    job.settings.dt = input.dt;
    job.settings.last_dt = state.header->last_dt;
    job.settings.degenerate_threshold = static_cast<float>(settings.degenerate_threshold);
    job.settings.treatment = settings.treatment;
    job.settings.plasticity = settings.plasticity;
    job.settings.min_plastic_stretch = static_cast<float>(settings.min_plastic_stretch);
    job.settings.max_plastic_stretch = static_cast<float>(settings.max_plastic_stretch);
    if (settings.rotation != RotationMethod::apd) job.settings.rotation = rotation_function(settings.rotation);
    return job;
}

ElementCounts run_elements(const ElementJob& job, const Model& model, Workspace& w, const Kernels& kernels,
                           const Jobs& jobs) {
    for_pieces(jobs, model.packets.size(), packets_per_piece,
               [&](std::size_t piece, std::size_t b, std::size_t e) { w.counts[piece] = kernels.elements(job, b, e); });
    ElementCounts total;
    for (std::size_t i = 0; i * packets_per_piece < model.packets.size(); ++i) {
        total.degenerate += w.counts[i].degenerate;
        total.yielding += w.counts[i].yielding;
        total.softened += w.counts[i].softened;
        total.energy += w.counts[i].energy;
    }
    return total;
}

void gather_loads(const Model& model, Workspace& w, const Kernels& kernels, const Jobs& jobs) {
    const LoadJob job{model.node_start.data(), model.node_corner.data(), w.forces.data(), w.outside.data(),
                      w.load.data()};
    for_pieces(jobs, model.node_count, nodes_per_piece,
               [&](std::size_t, std::size_t b, std::size_t e) { kernels.loads(job, b, e); });
}

// Says whether some node was too light beside its stiffness for float.
bool assemble(const Model& model, Workspace& w, bool is_uniform, const Kernels& kernels, const Jobs& jobs) {
    const EdgeJob edges{model.bundle.edge_start.data(),
                        model.incidence.data(),
                        model.edge_block.data()->data(),
                        w.gradients.data(),
                        w.blocks.data(),
                        model.ratio,
                        is_uniform};
    for_pieces(jobs, model.edge_count, edges_per_piece,
               [&](std::size_t, std::size_t b, std::size_t e) { kernels.edges(edges, b, e); });
    const RowJob rows{model.slices.node.data(), model.slices.start.data(), model.slices.column.data(),
                      w.damped_mass.data(),     w.blocks.data(),           w.inverse.data()};
    for_pieces(jobs, model.node_count, nodes_per_piece,
               [&](std::size_t piece, std::size_t b, std::size_t e) { w.raised[piece] = kernels.rows(rows, b, e); });
    const std::size_t pieces = (model.node_count + nodes_per_piece - 1) / nodes_per_piece;
    return std::any_of(w.raised.begin(), w.raised.begin() + static_cast<std::ptrdiff_t>(pieces),
                       [](std::uint32_t count) { return count > 0; });
}

}

StepReport step(const Model& model, State& state, Workspace& workspace, const StepInput& input,
                const Settings& settings, const Jobs& jobs) noexcept {
    StepReport report;
    if (!is_usable(model, state, input, settings)) {
        report.warnings = step_bad_input;
        return report;
    }
    const Kernels& wide = kernels(best_isa(settings.isa));
    const ConstraintCounts constraints = gather_constraints(model, workspace, input);
    const double kinetic = kinetic_energy(model, state);
    const Six momentum = momentum_of(model, state);
    start_velocities(model, state, workspace, input);
    const WindPush wind = input.wind ? add_wind(model, state, workspace, *input.wind, input.dt) : WindPush{};
    const ElementJob elements = element_job(model, state, workspace, input, settings);
    const ElementCounts counts = run_elements(elements, model, workspace, wide, jobs);
    gather_loads(model, workspace, wide, jobs);
    const bool is_too_stiff = assemble(model, workspace, model.is_uniform && counts.softened == 0, wide, jobs);
    list_partials(model, workspace, input);
    constrain_inverse(model, workspace, constraints.partial);
    Whole whole;
    if (input.has_free_carrier)
        whole.locks = make_rigid_locks(model, workspace, input.carrier_mass, input.gravity * input.dt);
    // Where nodes stand fast the body does not move as a whole.
    if (constraints.fixed == 0) {
        Six moving = outside_push(model, state, input, wind);
        add_to(moving, 1, momentum);
        add_to(moving, 1, whole.locks.fall);
        whole.response = respond_rigidly(model, state, input, workspace, workspace.partials.first(constraints.partial),
                                         whole.locks, moving);
    }
    const Solved solved = solve(model, workspace, constraints.partial, settings, state, whole, wide, jobs);
    restrain(model, state, workspace, constraints, solved, whole, wide, jobs);
    const Ledger ledger{kinetic + counts.energy, momentum, wind};
    const Advanced end = advance(model, state, workspace, input, constraints, elements, ledger, whole, wide, jobs);

    state.header->last_dt = input.dt;
    ++state.header->step_count;
    report.iterations = solved.iterations;
    report.residual = solved.residual;
    report.degenerate = counts.degenerate;
    report.yielding = counts.yielding;
    report.start_energy = ledger.energy;
    report.energy = end.energy;
    report.impulse = end.impulse;
    report.angular_impulse = end.angular_impulse;
    report.carrier_velocity = linear_part(whole.locks.change);
    report.carrier_turn = angular_part(whole.locks.change);
    if (end.is_cut) report.warnings |= step_restrained;
    if (is_too_stiff || solved.is_too_stiff) report.warnings |= step_too_stiff;
    if (end.has_overflowed || solved.has_overflowed) report.warnings |= step_not_finite;
    if (constraints.has_bad) report.warnings |= step_bad_constraint;
    return report;
}

}
