// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/error.h"
#include "core/names.h"
#include "pipeline/builtin_recipes.h"
#include "store/read_file.h"

namespace crumple::pipeline {

bool is_recipe_path(const std::string& name_or_path) {
    return name_or_path.ends_with(".json") || name_or_path.find('/') != std::string::npos;
}

RecipeText load_recipe_text(const std::string& name_or_path) {
    if (is_recipe_path(name_or_path)) {
        const std::vector<std::byte> bytes = store::read_file(name_or_path);
        return {name_or_path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}};
    }
    std::vector<std::string> names;
    for (const BuiltinRecipe& recipe : builtin_recipes()) {
        if (recipe.name == name_or_path) return {name_or_path, std::string(recipe.json)};
        names.emplace_back(recipe.name);
    }
    throw Error(ErrorKind::usage, "no recipe '" + name_or_path + "'; nearest: '" + nearest_name(name_or_path, names) +
                                      "' (there are: " + list_names(names) + "; or give the path of a .json file)");
}

}
