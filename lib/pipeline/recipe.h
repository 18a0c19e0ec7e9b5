// SPDX-License-Identifier: GPL-3.0-or-later
// A recipe: the parameters of every stage. One key a stage, strict JSON; what it leaves out keeps the stage's default.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "report/described.h"

namespace crumple::pipeline {

struct Recipe {
    std::string description;                     // for people
    std::vector<report::OwnedDescribed> params;  // one per stage, in the order of the stage table

    // As one struct with a field per stage. Valid as long as the recipe is.
    [[nodiscard]] report::Described view();
};

[[nodiscard]] Recipe default_recipe();

// Throws Error(usage) with the path of the key and the nearest valid name.
[[nodiscard]] Recipe read_recipe(std::string_view json, std::string_view source);

// "relax.sweeps=5"; `option` names the flag in messages where it was not --set.
void apply_setting(Recipe& recipe, std::string_view setting, std::string_view option = {});

// What no key alone shows: a count that says nothing, a material that is not in the table. To be asked once all is read
// and set. Throws Error(usage) with the path of the key.
void check_recipe(const Recipe& recipe, std::string_view source);

// Every parameter of every stage on one line without spaces: what provenance keeps. The description is not part of it.
[[nodiscard]] std::string canonical_json(const Recipe& recipe);

[[nodiscard]] std::string recipe_schema();

}
