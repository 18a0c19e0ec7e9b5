// SPDX-License-Identifier: MIT
#include "solver/step.h"

#include <gtest/gtest.h>

#include <cstring>

#include "solver/body.h"

namespace crumple::solver::test {
namespace {

Settings exact() {
    Settings settings;
    settings.max_iterations = 2000;
    settings.tolerance = 1e-6;
    return settings;
}

}

TEST(Step, ABodyAtRestStaysAtRest) {
    Body body(grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, elastic_material()), exact());
    for (int i = 0; i < 20; ++i) body.step(1.0f / 60);
    for (std::size_t i = 0; i < body.node_count(); ++i) EXPECT_LT(length(body.x(i) - body.rest(i)), 1e-6f);
}

TEST(Step, AFreeBodyFallsAsOne) {
    Body body(grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, elastic_material()), exact());
    StepInput input;
    input.gravity = {0, -9.81f, 0};
    for (int i = 0; i < 60; ++i) body.step(input);
    const float fall = 9.81f / 3600 * 60 * 61 / 2;  // semi-implicit Euler: g dt^2 n (n + 1) / 2
    for (std::size_t i = 0; i < body.node_count(); ++i) {
        EXPECT_NEAR(body.x(i).y, body.rest(i).y - fall, 2e-5f * fall);
        EXPECT_NEAR(body.x(i).x, body.rest(i).x, 1e-5f);
    }
}

// Nothing strains it, so there is nothing but rounding to solve for: no budget makes more of that.
TEST(Step, AStiffBodyThatFallsAsOneIsNotTooStiff) {
    Material steel = elastic_material(2e8);
    steel.density_kg_m3 = 180;
    for (const bool has_locks : {false, true}) {
        Settings settings;
        settings.max_iterations = 400;
        const auto is_locked = [=](Vec3f p) { return has_locks && p.x > 1.1f; };
        Body body(grid_body({12, 6, 6}, {0.1f, 0.1f, 0.1f}, steel, is_locked), settings);
        StepInput input;
        input.gravity = {0, -9.81f, 0};
        input.has_free_carrier = true;
        for (int i = 0; i < 20; ++i) {
            const StepReport report = body.step(input);
            EXPECT_EQ(report.warnings, 0u) << has_locks << " " << i;
            EXPECT_LT(report.residual, 1e-3f);
            EXPECT_LT(report.iterations, 400u) << has_locks << " " << i;
        }
    }
}

}
