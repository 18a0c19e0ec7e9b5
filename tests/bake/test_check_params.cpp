// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <functional>

#include "bake/bake.h"
#include "core/error.h"

using namespace crumple;
using bake::Params;

namespace {

std::string complaint_of(const std::function<void(Params&)>& change) {
    Params params;
    change(params);
    try {
        check_params(params);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        return error.what();
    }
    return "nothing";
}

}

TEST(BakeParams, TheDefaultsAreFine) {
    EXPECT_EQ(complaint_of([](Params&) {}), "nothing");
}

TEST(BakeParams, AMaterialTableNeedsMaterialsWithNamesOfTheirOwn) {
    EXPECT_EQ(complaint_of([](Params& p) { p.materials.clear(); }),
              "bake.materials: the table is empty; it needs one material at least");
    EXPECT_EQ(complaint_of([](Params& p) { p.materials[1].name = "steel"; }),
              "bake.materials[1].name: 'steel' is the name of materials[0] already");
    EXPECT_EQ(complaint_of([](Params& p) { p.materials[0].name = ""; }), "bake.materials[0].name: is empty");
    EXPECT_EQ(complaint_of([](Params& p) { p.materials[1].poisson = 0.5; }),
              "bake.materials[1].poisson is 0.5, allowed are 0 to 0.499");
}

TEST(BakeParams, AMapNamesMaterialsOfTheTable) {
    EXPECT_EQ(complaint_of([](Params& p) { p.material_by_component["nobody"] = "stele"; }),
              "bake.material_by_component.nobody: 'stele' is not in bake.materials (steel, engine); nearest: 'steel'");
    EXPECT_EQ(complaint_of([](Params& p) { p.material_by_role["rigid"] = "engin"; }),
              "bake.material_by_role.rigid: 'engin' is not in bake.materials (steel, engine); nearest: 'engine'");
    EXPECT_EQ(complaint_of([](Params& p) { p.material_by_source["paint"] = ""; }),
              "bake.material_by_source.paint: '' is not in bake.materials (steel, engine); nearest: 'steel'");
}

TEST(BakeParams, AMapByRoleNamesRoles) {
    EXPECT_EQ(complaint_of([](Params& p) { p.material_by_role["rigidd"] = "steel"; }),
              "bake.material_by_role.rigidd: no such role (solid, cavity, rigid); nearest: 'rigid'");
}

TEST(BakeParams, AStepIsPositive) {
    EXPECT_EQ(complaint_of([](Params& p) { p.step_s = 0; }), "bake.step_s: a step lasts 1e-6 to 1 second");
}

TEST(BakeParams, AFactorOnStiffnessIsPositiveAndFinite) {
    EXPECT_EQ(complaint_of([](Params& p) { p.stiffness_by_component["body"] = 0; }),
              "bake.stiffness_by_component.body: a factor lies between 1e-6 and 1e6");
}

TEST(BakeParams, SensorsHaveNamesOfTheirOwn) {
    EXPECT_EQ(complaint_of([](Params& p) { p.sensors = {{}}; }), "bake.sensors[0].name: is empty");
    EXPECT_EQ(complaint_of([](Params& p) {
                  p.sensors.resize(2);
                  p.sensors[0].name = p.sensors[1].name = "horn";
              }),
              "bake.sensors[1].name: 'horn' is the name of sensors[0] already");
}
