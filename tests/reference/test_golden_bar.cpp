// SPDX-License-Identifier: GPL-3.0-or-later
// A4 and A5 on the very mesh that CalculiX was given: k = P L^2 / (E I) spread equally over the nodes of the free end.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/calculix_figures.h"
#include "reference/displacement.h"
#include "reference/golden_bar.h"
#include "reference/reference.h"
#include "solver/body.h"
#include "solver/effort.h"

namespace crumple {
namespace {

// Critical damping of the first mode, which takes 12.5 s, or the bar would still swing when it is looked at.
Bundle damped_bar() {
    Material material = solver::test::elastic_material(1e6, 0.3);
    material.alpha_per_s = 1;
    return calculix::golden_bar(material);
}

bool is_tip(Vec3f rest) { return rest.x > 8 - 1e-4f; }

std::vector<Vec3> load(const Bundle& bar, double k) {
    double count = 0;
    for (const Vec3f p : bar.rest_positions) count += is_tip(p) ? 1 : 0;
    std::vector<Vec3> forces(bar.rest_positions.size());
    for (std::size_t i = 0; i < forces.size(); ++i) {
        if (is_tip(bar.rest_positions[i])) forces[i].y = -k * 1e6 / 12 / 64 / count;
    }
    return forces;
}

// Mean displacement of the free end.
template <class AnyBody>
Vec3 tip_of(const AnyBody& body, const Bundle& bar) {
    return test::mean_displacement(body, [&](std::size_t i) { return is_tip(bar.rest_positions[i]); });
}

Vec3 tip_of(const reference::Body& body) { return tip_of(body, *body.bundle); }

Vec3 runtime_tip(solver::test::Body& body, double k) {
    std::vector<Vec3f> forces;
    for (const Vec3 f : load(body.bundle, k)) forces.push_back({0, static_cast<float>(f.y), 0});
    solver::StepInput input;
    input.dt = 0.2f;
    input.forces = forces;
    for (int i = 0; i < 250; ++i) body.step(input);
    return tip_of(body, body.bundle);
}

void expect_near(Vec3 tip, const calculix::Tip& truth, double down, double along) {
    EXPECT_NEAR(tip.y / truth.down, 1, down) << truth.k;
    EXPECT_NEAR(tip.x / truth.along, 1, along) << truth.k;
}

}

TEST(A4CantileverSmall, TheBarOf5kTetsBendsAsCalculixSays) {
    const Bundle bar = damped_bar();
    ASSERT_EQ(bar.tets.size(), 5326u);
    const double truth = calculix::bar_5k_linear_down;
    reference::Body linear = reference::body_at_rest(bar);
    ASSERT_TRUE(reference::settle(linear, load(bar, 0.01), 1e-9, true));
    EXPECT_NEAR(tip_of(linear).y, truth, 1e-6 * std::fabs(truth));
    solver::Settings settings;
    settings.max_iterations = 3000;
    settings.tolerance = 1e-4;
    solver::test::Body body(bar, settings);
    EXPECT_NEAR(runtime_tip(body, 0.01).y, truth, 1e-3 * std::fabs(truth));
}

namespace {

// The rest take seconds, minutes with sanitizers.
bool is_quick(double k) {
#ifdef NDEBUG
    return k <= 1;
#else
    return k <= 0.2;
#endif
}

bool is_left_out(double k) { return !is_quick(k) && solver::test::effort(true, false, true); }

}

// CalculiX strains by Green, ours is corotated: they differ by the order of the strain.
TEST(A5CantileverLarge, TheBarOf5kTetsRestsWhereCalculixSays) {
    const Bundle bar = damped_bar();
    solver::Settings settings;
    settings.max_iterations = 3000;
    settings.tolerance = 1e-4;
    solver::test::Body body(bar, settings);
    reference::Body corotated = reference::body_at_rest(bar);
    for (const calculix::Tip& truth : calculix::bar_5k_tips) {
#ifndef NDEBUG
        if (is_left_out(truth.k)) continue;
#endif
        const Vec3 tip = runtime_tip(body, truth.k);
        expect_near(tip, truth, 3e-3, 0.02);
        if (is_left_out(truth.k)) continue;
        ASSERT_TRUE(reference::settle(corotated, load(bar, truth.k), 1e-7)) << truth.k;
        expect_near(tip_of(corotated), truth, 3e-3, 0.02);
        EXPECT_NEAR(tip.y / tip_of(corotated).y, 1, 2e-4) << truth.k;
    }
}

TEST(A5CantileverLarge, TheBarOf5kTetsByGreensStrainIsCalculixs) {
    const Bundle bar = damped_bar();
    for (const calculix::Tip& truth : calculix::bar_5k_tips) {
        if (truth.k != 0.2 && solver::test::effort(true, false, true)) continue;
        reference::Body body = reference::body_at_rest(bar);
        const int parts = truth.k == 0.2 ? 1 : 5;
        ASSERT_TRUE(reference::settle_by_green(body, load(bar, truth.k), 1e-7, parts)) << truth.k;
        expect_near(tip_of(body), truth, 1e-4, 1e-4);
    }
}

}
