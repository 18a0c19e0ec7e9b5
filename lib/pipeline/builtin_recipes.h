// SPDX-License-Identifier: GPL-3.0-or-later
// The recipes of pipelines/, inside the program: `crumple cook car_body` works wherever it was installed to.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace crumple::pipeline {

struct BuiltinRecipe {
    std::string_view name;  // car_body
    std::string_view json;
};

[[nodiscard]] std::span<const BuiltinRecipe> builtin_recipes();

struct RecipeText {
    std::string source;  // for messages: the path, or the name
    std::string json;
};

// A path ends in .json or holds a slash; everything else is the name of a builtin recipe.
[[nodiscard]] bool is_recipe_path(const std::string& name_or_path);

// Throws Error(file) for a path that cannot be read, Error(usage) with the nearest name.
[[nodiscard]] RecipeText load_recipe_text(const std::string& name_or_path);

}
