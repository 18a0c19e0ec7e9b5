// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/schemas.h"

#include <gtest/gtest.h>

#include <set>

#include "pipeline/stage_table.h"
#include "report/json.h"

TEST(Schemas, ThereIsOneForEveryStageAndEveryOutput) {
    std::set<std::string> names;
    for (const auto& file : crumple::pipeline::all_schemas()) {
        EXPECT_TRUE(names.insert(file.name).second) << file.name;
        const auto json = crumple::report::parse_json(file.text, file.name);
        EXPECT_TRUE(json.find("properties")) << file.name;
        EXPECT_TRUE(json.find("$schema")) << file.name;
    }
    for (const auto& stage : crumple::pipeline::stage_table()) {
        EXPECT_TRUE(names.contains("stage_" + std::string(stage.name) + ".schema.json"));
    }
    for (const char* name :
         {"recipe", "cook_report", "check", "inspect", "compare", "progress", "version", "finding"}) {
        EXPECT_TRUE(names.contains(std::string(name) + ".schema.json")) << name;
    }
}
