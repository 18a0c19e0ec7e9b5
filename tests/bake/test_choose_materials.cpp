// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/choose_materials.h"

#include <gtest/gtest.h>

#include "bake/grid_input.h"

using namespace crumple;
using bake::Params;

namespace {

// body (painted "steel_paint"), block (rigid, painted "iron"), cabin (cavity).
Shell three_parts() {
    Shell shell;
    shell.components.push_back({"body", "steel_paint", Role::solid, "", 1, true, false, none});
    shell.components.push_back({"block", "iron", Role::rigid, "", 1, true, false, 0});
    shell.components.push_back({"cabin", "", Role::cavity, "", 1, true, true, 0});
    return shell;
}

std::vector<std::string> names_of(const Params& params, std::vector<Finding>* findings = nullptr) {
    std::vector<Finding> found;
    std::vector<std::string> names;
    for (const auto& chosen : bake::choose_materials(three_parts(), params, found))
        names.push_back(params.materials[chosen.material].name);
    if (findings) *findings = found;
    return names;
}

}

TEST(ChooseMaterials, AShellWithoutComponentsIsSolid) {
    std::vector<Finding> findings;
    const auto chosen = bake::choose_materials(Shell{}, Params{}, findings);
    ASSERT_EQ(chosen.size(), 1u);
    EXPECT_EQ(chosen[0].material, 0);
}

TEST(ChooseMaterials, RolesDecideByDefault) {
    EXPECT_EQ(names_of({}), (std::vector<std::string>{"steel", "engine", "steel"}));
}

TEST(ChooseMaterials, NamesComeBeforeSourceMaterialsBeforeRoles) {
    Params params;
    params.materials.push_back({});
    params.materials.back().name = "rubber";
    params.material_by_source["iron"] = "rubber";
    EXPECT_EQ(names_of(params), (std::vector<std::string>{"steel", "rubber", "steel"}));
    params.material_by_component["block"] = "steel";
    EXPECT_EQ(names_of(params), (std::vector<std::string>{"steel", "steel", "steel"}));
}

TEST(ChooseMaterials, NamesThatTheShellLacksAreFindings) {
    Params params;
    params.material_by_component["spoiler"] = "steel";
    params.stiffness_by_component["bumper"] = 0.5;
    std::vector<Finding> findings;
    (void)names_of(params, &findings);
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].code, "MATERIAL_UNUSED");
    EXPECT_NE(findings[0].message.find("'spoiler'"), std::string::npos);
}

TEST(ChooseMaterials, ReachTheTetsOfTheirRegion) {
    test::BakeInput input = test::grid_input(2);
    input.asset.shell.components.push_back({"block", "", Role::rigid, "", 1, true, false, 0});
    input.mesh.region.assign(input.mesh.tets.size(), 0);
    for (std::size_t t = 0; t < 6; ++t) input.mesh.region[t] = 1;
    Params params;
    params.stiffness_by_component["block"] = 0.25;
    const bake::Result result = test::bake_input(input, params);
    EXPECT_EQ(result.report.bundle.materials[1].tets, 6u);
    EXPECT_NEAR(result.report.bundle.mass_kg, 1000 * 7 / 8.0 + 3000 / 8.0, 1e-3);
    for (std::size_t t = 0; t < result.bundle.tets.size(); ++t) {
        const bool is_block = result.bundle.region[t] == 1;
        EXPECT_EQ(result.bundle.material[t], is_block ? 1 : 0);
        EXPECT_EQ(result.bundle.stiffness_scale[t], is_block ? 0.25f : 1.0f);
    }
}
