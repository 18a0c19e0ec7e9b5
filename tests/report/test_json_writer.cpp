// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_writer.h"

#include <gtest/gtest.h>

#include <limits>

#include "report/example_params.h"
#include "report/json_reader.h"

using crumple::report::Described;
using crumple::report::JsonStyle;
using crumple::report::write_json;
using example::Box;
using example::Params;

TEST(JsonWriter, KeysKeepTheOrderOfTheDeclaration) {
    const Box box;
    EXPECT_EQ(write_json(Described::of(box), JsonStyle::compact), R"({"low":[-1.0,-1.0,-1.0],"high":[1.0,1.0,1.0]})");
}

TEST(JsonWriter, WhatIsWrittenReadsBackTheSame) {
    Params params;
    params.method = example::Method::lloyd;
    params.seed = std::numeric_limits<std::uint64_t>::max();
    params.tolerance = 0.1 + 0.2;
    params.share = 0.3f;
    params.element = 12;
    params.name = "caf\xc3\xa9 \"quoted\"\n";
    params.sensors.resize(2);
    params.sensors[1].low = {1e-300, -0.0, 1.0 / 3};
    params.roles["b"] = example::Method::odt;
    params.findings.push_back({"SHELL_OPEN", crumple::Severity::error, "close it", 3, {{{1, 2, 3}, 7, "hood"}}});
    const std::string text = write_json(Described::of(params));
    Params again;
    crumple::report::read_json(text, "x", Described::of(again));
    EXPECT_EQ(write_json(Described::of(again)), text);
    EXPECT_EQ(again.tolerance, params.tolerance);
    EXPECT_EQ(again.share, params.share);
    EXPECT_EQ(again.seed, params.seed);
    EXPECT_EQ(again.name, params.name);
    EXPECT_EQ(again.findings[0].places[0].name, "hood");
}

TEST(JsonWriter, AFloatIsWrittenWithItsOwnDigits) {
    Params params;
    params.share = 0.1f;
    EXPECT_NE(write_json(Described::of(params)).find("\"share\": 0.1,"), std::string::npos);
}

TEST(JsonWriter, WhatIsNoNumberIsNull) {
    Params params;
    params.tolerance = std::numeric_limits<double>::quiet_NaN();
    params.box.low = {std::numeric_limits<double>::infinity(), 0, 0};
    const std::string text = write_json(Described::of(params), JsonStyle::compact);
    EXPECT_NE(text.find(R"("tolerance":null)"), std::string::npos);
    EXPECT_NE(text.find(R"("element":null)"), std::string::npos);
    EXPECT_NE(text.find(R"("low":[null,0.0,0.0])"), std::string::npos);
}

TEST(JsonWriter, BrokenUtf8IsReplacedNotThrownAt) {
    Params params;
    params.name = "caf\xe9";
    EXPECT_NO_THROW((void)write_json(Described::of(params)));
}
