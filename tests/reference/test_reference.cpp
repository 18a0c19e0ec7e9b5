// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/body.h"

namespace crumple::reference {
namespace {

using solver::test::elastic_material;
using solver::test::grid_body;

const auto left_end = [](Vec3f p) { return p.x == 0; };

Vec3 turned(Vec3 p, double angle) {
    return {p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle), p.z};
}

}

TEST(Reference, AMirroredMatrixStillGetsARotation) {
    const Matrix3 r = nearest_rotation({1, 0, 0, 0, 2, 0, 0, 0, -0.5});
    EXPECT_EQ(r, (Matrix3{1, 0, 0, 0, 1, 0, 0, 0, 1}));
}

TEST(Reference, ATurnedBodyFeelsNoForceAndALinearOneDoes) {
    const Bundle bundle = grid_body({2, 1, 1}, {1, 1, 1}, elastic_material(1e6));
    Body body = body_at_rest(bundle);
    for (Vec3& p : body.positions) p = turned(p, 1);
    for (const Vec3 f : elastic_forces(body)) EXPECT_LT(length(f), 1e-8);
    StepInput linear;
    linear.is_linear = true;
    step(body, linear);
    EXPECT_GT(length(body.velocities[0]), 1e-3);
}

// A4: the tip of a slender beam sinks by P L^3 / (3 E I) as the mesh gets finer; linear tets come from the stiff side.
TEST(Reference, AFineCantileverApproachesBeamTheory) {
    double before = 0;
    for (const int n : {2, 4}) {
        const Bundle bundle = grid_body({8 * n, n, n}, {1.0f / n, 1.0f / n, 1.0f / n}, elastic_material(1e6), left_end);
        Body body = body_at_rest(bundle);
        const double load = 0.01 * 1e6 / 12 / 64;  // k = P L^2 / (E I) = .01
        std::vector<Vec3> forces(body.positions.size());
        for (std::size_t i = 0; i < forces.size(); ++i) {
            if (bundle.rest_positions[i].x == 8) forces[i].y = -load / ((n + 1) * (n + 1));
        }
        ASSERT_TRUE(settle(body, forces));
        double tip = 0;
        for (std::size_t i = 0; i < forces.size(); ++i)
            tip += forces[i].y * (bundle.rest_positions[i].y - body.positions[i].y);
        const double ratio = -tip / load / (0.01 * 8 / 3);
        EXPECT_GT(ratio, before);
        EXPECT_LT(ratio, 1.02);
        before = ratio;
    }
    EXPECT_GT(before, 0.7);
}

// A1 in double: a linear field on the boundary gives the same field inside.
TEST(Reference, PatchTestIsExact) {
    Bundle bundle = grid_body({3, 3, 3}, {1, 1, 1}, elastic_material(1e6), [](Vec3f p) {
        return p.x == 0 || p.x == 3 || p.y == 0 || p.y == 3 || p.z == 0 || p.z == 3;
    });
    Body body = body_at_rest(bundle);
    const auto field = [](Vec3f p) {
        return Vec3{p.x + 1e-3 * p.y, p.y - 5e-4 * p.x + 2e-4 * p.z, p.z + 1e-3 * p.x - 1e-3 * p.z};
    };
    for (std::size_t i = 0; i < body.positions.size(); ++i) {
        if (bundle.locked[i]) body.positions[i] = field(bundle.rest_positions[i]);
    }
    std::vector<Vec3> forces(body.positions.size());
    ASSERT_TRUE(settle(body, forces, 1e-12));
    for (std::size_t i = 0; i < body.positions.size(); ++i) {
        EXPECT_LT(length(body.positions[i] - field(bundle.rest_positions[i])), 1e-12);
    }
}

TEST(Reference, ReactionsCarryTheWeight) {
    const Bundle bundle = grid_body(
        {3, 1, 1}, {1, 1, 1},
        [] {
            Material m = elastic_material(1e6);
            m.alpha_per_s = 20;
            return m;
        }(),
        left_end);
    Body body = body_at_rest(bundle);
    StepInput input;
    input.gravity = {0, -10, 0};
    std::vector<Vec3> reactions;
    for (int i = 0; i < 400; ++i) reactions = step(body, input);
    double push = 0, weight = 0;
    for (const Vec3 r : reactions) push += r.y;
    for (const float m : bundle.mass) weight += 10 * m;
    EXPECT_NEAR(push, weight, 1e-3 * weight);
}

}
