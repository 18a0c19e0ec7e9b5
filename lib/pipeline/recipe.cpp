// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/recipe.h"

#include "pipeline/stage_table.h"
#include "report/json_reader.h"
#include "report/json_schema.h"
#include "report/json_writer.h"

namespace crumple::pipeline {

namespace {

// What no artist's file needs: a recipe is a page of text.
constexpr std::size_t max_recipe_bytes = 1u << 20;

std::vector<report::Field> recipe_fields(void* data) {
    auto& recipe = *static_cast<Recipe*>(data);
    report::FieldCollector collector;
    collector.field("description", recipe.description, "for people: what the recipe is good for");
    for (std::size_t i = 0; i < recipe.params.size(); ++i) {
        const Stage& stage = stage_table()[i];
        collector.add(stage.name, recipe.params[i].view(), Range{}, stage.help);
    }
    return collector.take();
}

}

report::Described Recipe::view() {
    static const report::TypeInfo type{.kind = report::Kind::object, .fields = recipe_fields};
    return {this, &type};
}

Recipe default_recipe() {
    Recipe recipe;
    for (const Stage& stage : stage_table()) recipe.params.push_back(stage.make_params());
    return recipe;
}

Recipe read_recipe(std::string_view json, std::string_view source) {
    Recipe recipe = default_recipe();
    report::read_json(json, source, recipe.view(), {.max_bytes = max_recipe_bytes});
    return recipe;
}

void apply_setting(Recipe& recipe, std::string_view setting, std::string_view option) {
    report::apply_setting(setting, recipe.view(), option);
}

void check_recipe(const Recipe& recipe, std::string_view source) {
    try {
        for (std::size_t i = 0; i < recipe.params.size(); ++i) stage_table()[i].check_params(recipe.params[i]);
    } catch (const Error& error) {
        throw Error(error.kind(), std::string(source) + ": " + error.what());
    }
}

std::string canonical_json(const Recipe& recipe) {
    report::Json json = report::Json::Object{};
    for (std::size_t i = 0; i < recipe.params.size(); ++i) {
        json.add(std::string(stage_table()[i].name), report::build_json(recipe.params[i].view()));
    }
    return report::dump_json(json, report::JsonStyle::compact);
}

std::string recipe_schema() {
    Recipe recipe = default_recipe();
    return report::write_schema(
        recipe.view(),
        {"recipe", "crumple recipe", "The parameters of every stage. Units are in the names, lengths in metres."},
        report::SchemaUse::input);
}

}
