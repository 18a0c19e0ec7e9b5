// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON Schema of everything the tool reads or prints as JSON; the files under schemas/ are these, kept current by a
// test.
#pragma once
#include <string>
#include <vector>

namespace crumple::pipeline {

struct SchemaFile {
    std::string name;  // recipe.schema.json
    std::string text;
};

[[nodiscard]] std::vector<SchemaFile> all_schemas();

}
