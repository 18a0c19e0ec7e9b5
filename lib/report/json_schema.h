// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON Schema (draft 7) of a described struct, from the same declaration that reads and writes it.
#pragma once
#include <string>
#include <string_view>

#include "report/described.h"

namespace crumple::report {

enum class SchemaUse {
    input,   // what a person writes: every key optional, with its default
    output,  // what the tool prints: every key there, null for what has no number
};

struct SchemaTitle {
    std::string_view id;  // "recipe": the file is schemas/recipe.schema.json
    std::string_view title;
    std::string_view description;
};

// `example` holds the defaults.
[[nodiscard]] std::string write_schema(Described example, const SchemaTitle& title, SchemaUse use);

}
