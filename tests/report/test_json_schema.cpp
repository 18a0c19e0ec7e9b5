// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_schema.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/example_params.h"

using crumple::report::Described;
using crumple::report::SchemaUse;
using nlohmann::json;

namespace {

json schema_of_example(SchemaUse use) {
    const example::Params params;
    return json::parse(crumple::report::write_schema(Described::of(params), {"example", "Example", "For tests."}, use));
}

}

TEST(JsonSchema, AnInputSchemaHasDefaultsRangesAndHelpAndRequiresNothing) {
    const json schema = schema_of_example(SchemaUse::input);
    EXPECT_EQ(schema["additionalProperties"], false);
    EXPECT_FALSE(schema.contains("required"));
    const json& sweeps = schema["properties"]["sweeps"];
    EXPECT_EQ(sweeps["type"], "integer");
    EXPECT_EQ(sweeps["minimum"], 0);
    EXPECT_EQ(sweeps["maximum"], 1000);
    EXPECT_EQ(sweeps["default"], 20);
    EXPECT_EQ(sweeps["description"], "passes of moving nodes");
    EXPECT_EQ(schema["properties"]["method"]["enum"], json::parse(R"(["cpt", "odt", "lloyd"])"));
    EXPECT_EQ(schema["properties"]["small"]["maximum"], 255);
    EXPECT_EQ(schema["properties"]["box"]["properties"]["high"]["items"]["maximum"], 10);
    EXPECT_EQ(schema["properties"]["roles"]["additionalProperties"]["type"], "string");
    EXPECT_EQ(schema["properties"]["pair"]["minItems"], 2);
    EXPECT_TRUE(schema["properties"].contains("$schema"));
}

TEST(JsonSchema, AnOutputSchemaRequiresEveryKeyAndAllowsNullForNoNumber) {
    const json schema = schema_of_example(SchemaUse::output);
    EXPECT_EQ(schema["required"].size(), schema["properties"].size());
    EXPECT_EQ(schema["properties"]["tolerance"]["type"], json::parse(R"(["number", "null"])"));
    EXPECT_EQ(schema["properties"]["element"]["type"], json::parse(R"(["integer", "null"])"));
    EXPECT_EQ(schema["properties"]["sweeps"]["type"], "integer");
}
