// SPDX-License-Identifier: GPL-3.0-or-later
// The runtime solver in float against the reference in double, from the same states.
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/reference.h"
#include "solver/body.h"

namespace crumple {
namespace {

using solver::Isa;
using solver::Settings;
using solver::test::elastic_material;
using solver::test::grid_body;

const auto left_end = [](Vec3f p) { return p.x == 0; };

Settings exact(Isa isa = Isa::automatic) {
    Settings settings;
    settings.max_iterations = 3000;
    settings.tolerance = 3e-7;
    settings.isa = isa;
    return settings;
}

std::vector<Isa> runnable() {
    std::vector<Isa> isas{Isa::scalar};
    for (const Isa isa : {Isa::avx2, Isa::avx512}) {
        if (solver::best_isa(isa) == isa) isas.push_back(isa);
    }
    return isas;
}

// Two materials with different ratios of Lame's constants, stiffnesses and dampings.
Bundle mixed_body() {
    Bundle b = grid_body({4, 2, 2}, {0.5f, 0.5f, 0.5f}, elastic_material(2e5, 0.3), left_end);
    Material other = elastic_material(1e5, 0.45);
    other.beta_s = 0.01;
    other.alpha_per_s = 2;
    b.materials.push_back(other);
    for (std::size_t t = 0; t < b.tets.size(); t += 3) b.material[t] = 1;
    for (std::size_t t = 0; t < b.tets.size(); t += 5) b.stiffness_scale[t] = 1.5f;
    return b;
}

Vec3f bent(Vec3f p) {
    const float angle = 0.5f * p.x;
    return {std::sin(angle) * (2 + p.y), std::cos(angle) * (2 + p.y) - 2, p.z * (1 + 0.1f * p.x)};
}

void copy_state(const solver::test::Body& from, reference::Body& to) {
    for (std::size_t i = 0; i < from.node_count(); ++i) {
        to.positions[i] = widen(from.x(i));
        to.velocities[i] = widen(solver::velocity(from.state, i));
    }
}

double farthest(const solver::test::Body& a, const reference::Body& b) {
    double far = 0;
    for (std::size_t i = 0; i < a.node_count(); ++i) far = std::max(far, length(widen(a.x(i)) - b.positions[i]));
    return far;
}

}

// The edge-centric matrix against the slot route in double: every block, also in a bent and twisted body.
TEST(SolverAgrees, EveryBlockWithTheSlotRoute) {
    for (const bool is_mixed : {false, true}) {
        const Bundle bundle =
            is_mixed ? mixed_body() : grid_body({4, 2, 2}, {0.5f, 0.5f, 0.5f}, elastic_material(), left_end);
        for (const Isa isa : runnable()) {
            solver::test::Body body(bundle, exact(isa));
            body.set_positions(bent);
            const float dt = 0.02f;
            std::vector<reference::Matrix3> rotations;
            std::vector<double> scale;
            for (std::size_t t = 0; t < bundle.solver_tet_count; ++t) {
                const auto f = solver::deformation_gradient(body.model, body.state, t);
                const auto r = solver::rotation_svd_smallest(f, solver::Mat3::identity());
                reference::Matrix3 wide;
                std::copy(r.m.begin(), r.m.end(), wide.begin());
                rotations.push_back(wide);
                scale.push_back(dt * (bundle.materials[bundle.material[t]].beta_s + dt));
            }
            body.step(dt);
            auto expected = reference::stiffness_by_slots(bundle, rotations, scale);
            double largest = 0;
            for (const double value : expected) largest = std::max(largest, std::fabs(value));
            for (std::size_t i = 0; i < bundle.diagonal.size(); ++i) {
                for (const std::size_t k : {0, 4, 8}) {
                    expected[9 * std::size_t{bundle.diagonal[i]} + k] += body.workspace.damped_mass[i];
                }
            }
            for (Index row = 0; row < body.node_count(); ++row) {
                solver::for_row(body.model.slices, row, [&](Index column, std::size_t number) {
                    const auto first = bundle.column.begin() + bundle.row_start[row];
                    const auto slot = std::find(first, bundle.column.end(), column) - bundle.column.begin();
                    const solver::Mat3 block = solver::block_at(body.workspace.blocks, number);
                    for (std::size_t i = 0; i < 9; ++i) {
                        const double value = expected[9 * static_cast<std::size_t>(slot) + i];
                        ASSERT_NEAR(transpose(block).m[i], value, 1e-5 * largest)
                            << name_of(isa) << " row " << row << " column " << column;
                    }
                });
            }
        }
    }
}

TEST(SolverAgrees, OneStepOfABentBodyWithEverything) {
    const Bundle bundle = mixed_body();
    for (const Isa isa : runnable()) {
        solver::test::Body body(bundle, exact(isa));
        body.set_positions(bent);
        body.set_velocities([](Vec3f p) { return Vec3f{1 + p.y, -2 * p.x, 0.5f}; });
        reference::Body truth = reference::body_at_rest(bundle);
        copy_state(body, truth);
        std::vector<Vec3f> forces(body.node_count(), Vec3f{0, 30, 5});
        std::vector<Vec3f> reactions(body.node_count());
        const std::vector<Vec3> wide_forces(body.node_count(), Vec3{0, 30, 5});
        const solver::Constraint pull{
            .node = 40, .kind = solver::ConstraintKind::fixed, .velocity = {1, 2, 3}, .normal = {}, .second = {}};
        const reference::Prescribed wide_pull{40, {1, 2, 3}};
        solver::StepInput input;
        input.dt = 0.01f;
        input.gravity = {0, -9.81f, 0};
        input.forces = forces;
        input.constraints = {&pull, 1};
        input.reactions = reactions;
        reference::StepInput wide;
        wide.dt = input.dt;
        wide.gravity = widen(input.gravity);
        wide.forces = wide_forces;
        wide.prescribed = {&wide_pull, 1};
        body.step(input);
        const auto wide_reactions = reference::step(truth, wide);
        EXPECT_LT(farthest(body, truth), 2e-6) << name_of(isa);
        double largest = 0;
        for (const Vec3 r : wide_reactions) largest = std::max(largest, length(r));
        for (std::size_t i = 0; i < body.node_count(); ++i) {
            EXPECT_LT(length(widen(reactions[i]) - wide_reactions[i]), 1e-4 * largest) << name_of(isa) << " node " << i;
        }
    }
}

TEST(SolverAgrees, AHundredStepsOfASwingingBeam) {
    Material material = elastic_material(1e5);
    material.alpha_per_s = 0.15;
    material.beta_s = 0.004;
    const Bundle bundle = grid_body({6, 1, 1}, {0.5f, 0.5f, 0.5f}, material, left_end);
    for (const Isa isa : runnable()) {
        solver::test::Body body(bundle, exact(isa));
        reference::Body truth = reference::body_at_rest(bundle);
        solver::StepInput input;
        input.gravity = {0, -9.81f, 0};
        reference::StepInput wide;
        wide.dt = input.dt;
        wide.gravity = widen(input.gravity);
        for (int i = 0; i < 100; ++i) {
            body.step(input);
            reference::step(truth, wide);
        }
        EXPECT_LT(farthest(body, truth), 1e-4 * 3) << name_of(isa);
    }
}

TEST(SolverAgrees, PlasticStrainFlowsAlike) {
    Material material = elastic_material(1e5);
    material.yield_pa = 1e3;
    material.creep_per_s = 20;
    const Bundle bundle = grid_body({4, 1, 1}, {0.5f, 0.5f, 0.5f}, material, left_end);
    solver::test::Body body(bundle, exact());
    reference::Body truth = reference::body_at_rest(bundle);
    solver::StepInput input;
    input.gravity = {0, -9.81f, 0};
    reference::StepInput wide;
    wide.dt = input.dt;
    wide.gravity = widen(input.gravity);
    wide.has_plasticity = true;
    for (int i = 0; i < 60; ++i) {
        body.step(input);
        reference::step(truth, wide);
    }
    EXPECT_LT(farthest(body, truth), 1e-4 * 2);
    double largest = 0;
    for (std::size_t t = 0; t < bundle.solver_tet_count; ++t) {
        const auto& state = body.state.tets[t / solver::packet_size];
        const std::size_t lane = t % solver::packet_size;
        EXPECT_NEAR(state.plastic[0][lane], truth.plastic[t][0], 1e-4);
        EXPECT_NEAR(state.plastic[3][lane], truth.plastic[t][1], 1e-4);
        EXPECT_NEAR(state.plastic[0][lane] + state.plastic[1][lane] + state.plastic[2][lane], 0, 1e-6);
        largest = std::max(largest, std::fabs(truth.plastic[t][0]));
    }
    EXPECT_GT(largest, 0.01);
}

}
