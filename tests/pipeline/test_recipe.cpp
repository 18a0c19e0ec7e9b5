// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/recipe.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/builtin_recipes.h"
#include "pipeline/stage_table.h"
#include "relax/relax.h"

using crumple::Error;
using crumple::ErrorKind;
using crumple::pipeline::apply_setting;
using crumple::pipeline::canonical_json;
using crumple::pipeline::read_recipe;

namespace {

std::string refusal(const std::string& json) {
    try {
        (void)read_recipe(json, "recipe.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << json;
    return {};
}

}

TEST(Recipe, AnEmptyObjectIsTheDefaults) {
    auto recipe = crumple::pipeline::default_recipe();
    EXPECT_EQ(canonical_json(read_recipe("{}", "x")), canonical_json(recipe));
}

TEST(Recipe, OneKeyAStageInTheOrderOfTheTable) {
    const std::string json = canonical_json(crumple::pipeline::default_recipe());
    std::size_t at = 0;
    for (const auto& stage : crumple::pipeline::stage_table()) {
        const std::size_t found = json.find("\"" + std::string(stage.name) + "\":{", at);
        ASSERT_NE(found, std::string::npos) << stage.name;
        at = found;
    }
}

TEST(Recipe, AnUnknownStageNamesTheNearest) {
    EXPECT_NE(refusal(R"({"relaxe": {}})").find("'relax'"), std::string::npos);
}

TEST(Recipe, AnUnknownKeyNamesItsPath) {
    EXPECT_NE(refusal(R"({"relax": {"sweep": 1}})").find("relax.sweep: unknown key"), std::string::npos);
}

TEST(Recipe, AHugeRecipeIsRefused) { (void)refusal("{" + std::string(2u << 20, ' ') + "}"); }

TEST(Recipe, ASettingReachesTheStage) {
    auto recipe = crumple::pipeline::default_recipe();
    apply_setting(recipe, "relax.sweeps=5");
    const auto& params = recipe.params[crumple::pipeline::stage_index("relax")].as<crumple::relax::Params>();
    EXPECT_EQ(static_cast<int>(params.sweeps), 5);
    EXPECT_THROW(apply_setting(recipe, "relaxx.sweeps=5"), Error);
}

TEST(Recipe, TheDescriptionIsNoParameter) {
    EXPECT_EQ(canonical_json(read_recipe(R"({"description": "a"})", "x")), canonical_json(read_recipe("{}", "x")));
}

TEST(Recipe, CanonicalTextReadsBackAsItself) {
    for (const auto& builtin : crumple::pipeline::builtin_recipes()) {
        const std::string text = canonical_json(read_recipe(builtin.json, builtin.name));
        EXPECT_EQ(canonical_json(read_recipe(text, "canonical")), text) << builtin.name;
    }
}

TEST(Recipe, BuiltinRecipesDiffer) {
    std::vector<std::string> texts;
    for (const auto& builtin : crumple::pipeline::builtin_recipes()) {
        texts.push_back(canonical_json(read_recipe(builtin.json, builtin.name)));
    }
    ASSERT_EQ(texts.size(), 4u);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(texts[i], texts[j]);
    }
}

TEST(Recipe, ANameThatIsNoRecipeNamesTheNearest) {
    try {
        (void)crumple::pipeline::load_recipe_text("smok");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("'smoke'"), std::string::npos);
    }
}
