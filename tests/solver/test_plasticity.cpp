// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "solver/body.h"

namespace crumple::solver::test {
namespace {

Settings with(Plasticity plasticity) {
    Settings settings;
    settings.plasticity = plasticity;
    settings.max_iterations = 500;
    settings.tolerance = 1e-6;
    return settings;
}

// E = 1e6, yield at a uniaxial strain of 1 %.
Material soft_steel(double creep_per_s) {
    Material m = elastic_material(1e6);
    m.yield_pa = 1e4;
    m.creep_per_s = creep_per_s;
    m.alpha_per_s = 20;
    return m;
}

// A cube on rollers at x = 0 whose other end is moved along x.
class TensionTest {
public:
    TensionTest(const Material& material, Plasticity plasticity)
        : body(grid_body({1, 1, 1}, {1, 1, 1}, material), with(plasticity)) {
        for (Index i = 0; i < 8; ++i) {
            holds_.push_back({i, ConstraintKind::plane, {}, {1, 0, 0}, {}});
        }
        holds_[0].kind = ConstraintKind::fixed;
    }

    void move(double velocity, double time, double dt) {
        for (Index i = 0; i < 8; ++i) {
            if (body.rest(i).x > 0.5f) holds_[i].velocity = {static_cast<float>(velocity), 0, 0};
        }
        StepInput input;
        input.dt = static_cast<float>(dt);
        input.constraints = holds_;
        const int steps = static_cast<int>(std::lround(time / dt));
        for (int i = 0; i < steps; ++i) report = body.step(input);
    }

    [[nodiscard]] double plastic_xx(std::size_t t) const { return body.state.tets[0].plastic[0][t]; }
    // F_p^-1 of multiplicative flow.
    [[nodiscard]] Mat3 undo(std::size_t t) const {
        Mat3 shaped, rest;
        for (std::size_t i = 0; i < 9; ++i) {
            shaped.m[i] = body.state.shapes[0].gradient[i][t];
            rest.m[i] = body.model.packets[0].gradient[i][t];
        }
        return transpose(cofactor(rest)) * (1 / determinant(rest)) * shaped;
    }
    [[nodiscard]] double mean_plastic_xx() const {
        double sum = 0;
        for (std::size_t t = 0; t < 6; ++t) sum += plastic_xx(t) / 6;
        return sum;
    }

    Body body;
    StepReport report;

private:
    std::vector<Constraint> holds_;
};

}

TEST(Plasticity, BelowYieldNothingFlows) {
    for (const Plasticity plasticity : {Plasticity::additive, Plasticity::multiplicative}) {
        TensionTest test(soft_steel(1000), plasticity);
        test.move(0.009, 1, 0.02);
        test.move(0, 1, 0.02);
        EXPECT_EQ(test.report.yielding, 0u);
        EXPECT_EQ(test.mean_plastic_xx(), 0);
        if (plasticity == Plasticity::multiplicative) {
            EXPECT_EQ(test.body.state.shapes[0].gradient[0][0], test.body.model.packets[0].gradient[0][0]);
        }
    }
}

TEST(Plasticity, InvertedTetsDoNotFlow) {
    TensionTest test(soft_steel(1000), Plasticity::additive);
    test.body.set_positions([](Vec3f p) { return Vec3f{p.x, p.y, -p.z}; });
    test.body.step(0.01f);
    EXPECT_EQ(test.mean_plastic_xx(), 0);
}

// A11: pulled to twice the yield strain and held, what is left of the stress is the yield stress: uniaxially
// eps_p = eps - sigma_y / E. The axial plastic strain of a trace-free flow with nu = .3 sees eps at fixed stress.
TEST(A11PlasticBar, HeldBeyondYieldItFlowsUntilTheStressIsTheYieldStress) {
    TensionTest test(soft_steel(60), Plasticity::additive);
    test.move(0.02, 1, 1.0 / 120);
    test.move(0, 2, 1.0 / 120);
    for (std::size_t t = 0; t < 6; ++t) EXPECT_NEAR(test.plastic_xx(t), 0.02 - 0.01, 2e-4);
}

// S12 and A11: a rate-dependent flow that is still under way ends the same at 60, 120 and 240 Hz.
TEST(S12DtIndependence, ACycleLeavesTheSameStrainAtAnyRate) {
    std::vector<double> left;
    for (const double rate : {60.0, 120.0, 240.0}) {
        TensionTest test(soft_steel(3), Plasticity::additive);
        test.move(0.04, 0.5, 1 / rate);
        test.move(-0.04, 0.5, 1 / rate);
        test.move(0, 1, 1 / rate);
        left.push_back(test.mean_plastic_xx());
    }
    EXPECT_GT(left[0], 1e-3);
    EXPECT_NEAR(left[1], left[0], 0.02 * left[0]);
    EXPECT_NEAR(left[2], left[0], 0.02 * left[0]);
}

TEST(Plasticity, HardeningLeavesLessStrain) {
    Material hard = soft_steel(60);
    hard.hardening_pa = 5e5;
    TensionTest soft_test(soft_steel(60), Plasticity::additive);
    TensionTest hard_test(hard, Plasticity::additive);
    for (TensionTest* test : {&soft_test, &hard_test}) {
        test->move(0.03, 1, 0.01);
        test->move(0, 1, 0.01);
    }
    EXPECT_LT(hard_test.mean_plastic_xx(), 0.9 * soft_test.mean_plastic_xx());
    EXPECT_GT(hard_test.mean_plastic_xx(), 0.3 * soft_test.mean_plastic_xx());
}

TEST(Plasticity, StrainStopsAtItsLimit) {
    Material m = soft_steel(1000);
    m.max_plastic_strain = 0.05;
    TensionTest test(m, Plasticity::additive);
    test.move(0.5, 1, 0.01);
    for (std::size_t t = 0; t < 6; ++t) {
        double squared = 0;
        for (std::size_t i = 0; i < 6; ++i) {
            const double e = test.body.state.tets[0].plastic[i][t];
            squared += (i < 3 ? 1 : 2) * e * e;
        }
        EXPECT_NEAR(std::sqrt(squared), 0.05, 1e-5);
    }
}

// Multiplicative: large strain, volume kept, limits kept, and the same where both apply.
TEST(Plasticity, MultiplicativeFlowKeepsTheVolumeAndItsLimits) {
    TensionTest test(soft_steel(1000), Plasticity::multiplicative);
    test.move(0.5, 1, 0.005);
    for (std::size_t t = 0; t < 6; ++t) {
        EXPECT_NEAR(determinant(test.undo(t)), 1, 1e-3);
        const Svd svd = singular_values(test.undo(t));
        EXPECT_GE(svd.s.z, 1 / 1.2 - 1e-3);
        EXPECT_LT(svd.s.z, 0.9f);
    }
}

TEST(Plasticity, MultiplicativeAndAdditiveAgreeAtSmallStrain) {
    TensionTest additive(soft_steel(60), Plasticity::additive);
    TensionTest multiplicative(soft_steel(60), Plasticity::multiplicative);
    for (TensionTest* test : {&additive, &multiplicative}) {
        test->move(0.02, 1, 0.01);
        test->move(0, 1, 0.01);
    }
    for (std::size_t t = 0; t < 6; ++t) {
        EXPECT_NEAR(1 / multiplicative.undo(t)(0, 0) - 1, additive.plastic_xx(t), 5e-4);
    }
}

TEST(Plasticity, MultiplicativeResultDoesNotDependOnDt) {
    std::vector<double> left;
    for (const double rate : {60.0, 120.0, 240.0}) {
        TensionTest test(soft_steel(3), Plasticity::multiplicative);
        test.move(0.1, 0.5, 1 / rate);
        test.move(0, 0.5, 1 / rate);
        double sum = 0;
        for (std::size_t t = 0; t < 6; ++t) sum += (1 / test.undo(t)(0, 0) - 1) / 6;
        left.push_back(sum);
    }
    EXPECT_GT(left[0], 1e-3);
    EXPECT_NEAR(left[1], left[0], 0.02 * left[0]);
    EXPECT_NEAR(left[2], left[0], 0.02 * left[0]);
}

// A12: bent beyond yield and released, it stays bent and what elastic stress is left is below yield.
TEST(A12PlasticRestShape, ABentBarStaysBentBelowYield) {
    Material m = soft_steel(60);
    m.alpha_per_s = 5;
    Body body(grid_body({8, 2, 2}, {0.25f, 0.25f, 0.25f}, m, [](Vec3f p) { return p.x == 0; }),
              with(Plasticity::additive));
    std::vector<Vec3f> push(body.node_count());
    for (std::size_t i = 0; i < push.size(); ++i) {
        if (body.rest(i).x == 2) push[i] = {0, -60, 0};
    }
    StepInput input;
    input.forces = push;
    for (int i = 0; i < 60; ++i) body.step(input);
    for (int i = 0; i < 400; ++i) body.step(1.0f / 60);
    const std::size_t tip = body.node_count() - 1;
    EXPECT_LT(body.x(tip).y, body.rest(tip).y - 0.02f);
    EXPECT_LT(length(velocity(body.state, tip)), 1e-3f);
    for (std::size_t t = 0; t < body.model.tet_count; ++t) {
        const Mat3 s = transpose(rotation(body.state, t)) * deformation_gradient(body.model, body.state, t);
        const auto& state = body.state.tets[t / packet_size];
        const std::size_t lane = t % packet_size;
        Mat3 e = s - Mat3::identity();
        const int places[6] = {0, 4, 8, 1, 2, 5};
        const int mirrored[6] = {0, 4, 8, 3, 6, 7};
        for (std::size_t i = 0; i < 6; ++i) {
            e.m[static_cast<std::size_t>(places[i])] -= state.plastic[i][lane];
            if (i > 2) e.m[static_cast<std::size_t>(mirrored[i])] -= state.plastic[i][lane];
        }
        e = e - Mat3::identity() * (trace(e) / 3);
        EXPECT_LT(norm(e), 1.02f * body.model.packets[t / packet_size].yield_strain[lane]);
    }
}

}
