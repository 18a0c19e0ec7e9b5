// SPDX-License-Identifier: GPL-3.0-or-later
// The solver is the oracle: bake must warn of a step exactly where the solver will.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "bake/grid_input.h"
#include "bundle/longest_steps.h"
#include "solver/step.h"

using namespace crumple;
using test::bake_input;
using test::BakeInput;
using test::grid_input;

namespace {

class Memory {
public:
    explicit Memory(std::size_t bytes) : bytes_(bytes), memory_(std::aligned_alloc(64, (bytes + 63) / 64 * 64)) {}
    [[nodiscard]] std::span<std::byte> get() const { return {static_cast<std::byte*>(memory_.get()), bytes_}; }

private:
    struct Free {
        void operator()(void* p) const { std::free(p); }
    };
    std::size_t bytes_;
    std::unique_ptr<void, Free> memory_;
};

bool solver_warns(const Bundle& bundle, double step_s) {
    const solver::BundleView view = solver::view_of(bundle);
    const Memory of_model(model_bytes(view));
    const solver::Model model = build_model(view, of_model.get());
    const Memory of_state(state_bytes(model, solver::Plasticity::additive));
    const Memory of_workspace(workspace_bytes(model));
    solver::State state = make_state(model, solver::Plasticity::additive, of_state.get());
    solver::Workspace workspace = make_workspace(model, of_workspace.get());
    solver::StepInput input;
    input.dt = static_cast<float>(step_s);
    return (step(model, state, workspace, input).warnings & solver::step_too_stiff) != 0;
}

const Finding* find_warning(const bake::Report& report) {
    const auto at = std::find_if(report.findings.begin(), report.findings.end(),
                                 [](const Finding& f) { return f.code == "STEP_TOO_STIFF"; });
    return at == report.findings.end() ? nullptr : &*at;
}

bake::Params with(const Material& material, double step_s = 1.0 / 60) {
    bake::Params params;
    params.materials[0] = material;
    params.step_s = step_s;
    return params;
}

bake::Result bake_cube(const bake::Params& params, int cells = 3, double lock_below = -1) {
    BakeInput input = grid_input(cells, lock_below);
    return bake_bundle(input.asset, input.mesh, input.bindings, params);
}

}

TEST(BakeLightNodes, AGameStepOfTheDefaultSteelIsFine) {
    const bake::Result baked = bake_cube({});
    EXPECT_EQ(find_warning(baked.report), nullptr);
    EXPECT_FALSE(solver_warns(baked.bundle, 1.0 / 60));
}

TEST(BakeLightNodes, RealSteelIsTooStiffForAGameStep) {
    Material steel;
    steel.young_pa = 2e11;
    steel.density_kg_m3 = 7800;
    const bake::Result baked = bake_cube(with(steel));
    const Finding* warning = find_warning(baked.report);
    ASSERT_NE(warning, nullptr);
    EXPECT_EQ(warning->severity, Severity::warning);
    EXPECT_GT(warning->count, max_places);
    EXPECT_EQ(warning->places.size(), max_places);
    EXPECT_EQ(warning->places[0].name, "body");
    EXPECT_NE(warning->message.find("steps of 16.7 ms"), std::string::npos) << warning->message;
    EXPECT_TRUE(solver_warns(baked.bundle, 1.0 / 60));
}

// Damping by mass or by stiffness, locks, shares of stiffness: just below the longest step nobody warns, just above it
// both do.
TEST(BakeLightNodes, BakeWarnsWhereTheSolverWill) {
    for (const double alpha : {0.0, 0.15, 1e4}) {
        for (const double beta : {0.0, 0.004, 1.0}) {
            for (const double young : {2e8, 2e11}) {
                Material m;
                m.young_pa = young;
                m.alpha_per_s = alpha;
                m.beta_s = beta;
                bake::Params params = with(m);
                params.stiffness_by_component["body"] = 3;
                const Bundle bundle = bake_cube(params, 3, 0.4).bundle;
                const auto steps = longest_steps(bundle);
                const double longest = *std::min_element(steps.begin(), steps.end());
                SCOPED_TRACE(testing::Message() << alpha << " " << beta << " " << young << " " << longest);
                for (const bool is_longer : {false, true}) {
                    params.step_s = longest * (is_longer ? 1.001 : 0.999);
                    if (params.step_s > 1) continue;
                    EXPECT_EQ(solver_warns(bundle, params.step_s), is_longer);
                    EXPECT_EQ(find_warning(bake_cube(params, 3, 0.4).report) != nullptr, is_longer);
                }
            }
        }
    }
}

TEST(BakeLightNodes, TheWorstNodeComesFirst) {
    BakeInput input = grid_input(3);
    // One shell vertex pushed close to its neighbours: its tets become flat and stiff.
    const auto near_corner = [](Vec3 p) { return p.x == 0 && p.y == 0 && p.z == 0; };
    for (Vec3& p : input.mesh.positions) {
        if (near_corner(p)) p = {0.328125, 0.328125, 0.328125};
    }
    for (Vec3& p : input.asset.shell.positions) {
        if (near_corner(p)) p = {0.328125, 0.328125, 0.328125};
    }
    Material m;
    m.young_pa = 2e10;
    const bake::Result baked = bake_bundle(input.asset, input.mesh, input.bindings, with(m));
    const Finding* warning = find_warning(baked.report);
    ASSERT_NE(warning, nullptr);
    const auto steps = longest_steps(baked.bundle);
    EXPECT_EQ(steps[warning->places[0].element], *std::min_element(steps.begin(), steps.end()));
    for (std::size_t i = 1; i < warning->places.size(); ++i) {
        EXPECT_LE(steps[warning->places[i - 1].element], steps[warning->places[i].element]);
    }
}

TEST(BakeLightNodes, NodesOfNoSimulatedTetNeverWarn) {
    Material m;
    m.young_pa = 1e13;
    const bake::Result baked = bake_cube(with(m), 1, 2);
    EXPECT_EQ(baked.bundle.solver_tet_count, 0u);
    EXPECT_EQ(find_warning(baked.report), nullptr);
}
