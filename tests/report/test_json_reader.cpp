// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_reader.h"

#include <gtest/gtest.h>

#include <string>

#include "report/example_params.h"

using crumple::Error;
using crumple::ErrorKind;
using crumple::report::apply_setting;
using crumple::report::Described;
using crumple::report::read_json;
using example::Params;

namespace {

Params read(const std::string& text) {
    Params params;
    read_json(text, "recipe.json", Described::of(params));
    return params;
}

std::string refusal(const std::string& text) {
    try {
        (void)read(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << text;
    return {};
}

std::string setting_refusal(const std::string& setting) {
    Params params;
    try {
        apply_setting(setting, Described::of(params));
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << setting;
    return {};
}

void expect_contains(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

}

TEST(JsonReader, EmptyTextIsRefused) { expect_contains(refusal(""), "recipe.json"); }

TEST(JsonReader, EmptyObjectKeepsEveryDefault) {
    const Params params = read("{}");
    EXPECT_EQ(params.sweeps, 20);
    EXPECT_EQ(params.method, example::Method::cpt);
    EXPECT_EQ(params.box.low, (crumple::Vec3{-1, -1, -1}));
}

TEST(JsonReader, ReadsEveryKind) {
    const Params params =
        read(R"({"$schema": "x", "method": "odt", "sweeps": 5, "seed": 18446744073709551615, "small": 255,
        "element": 3, "tolerance": 0.25, "share": 0.5, "is_graded": false, "name": "hood", "box": {"low": [-2, 0, 1]},
        "sensors": [{}, {"high": [1, 2, 3]}], "roles": {"engine.001": "lloyd"}, "boxes": {"a": {"low": [0, 0, 0]}},
        "pair": [3, 4]})");
    EXPECT_EQ(params.method, example::Method::odt);
    EXPECT_EQ(params.sweeps, 5);
    EXPECT_EQ(params.seed, 18446744073709551615u);
    EXPECT_EQ(params.small, 255);
    EXPECT_EQ(params.element, 3u);
    EXPECT_EQ(params.tolerance, 0.25);
    EXPECT_EQ(params.share, 0.5f);
    EXPECT_FALSE(params.is_graded);
    EXPECT_EQ(params.name, "hood");
    EXPECT_EQ(params.box.low, (crumple::Vec3{-2, 0, 1}));
    ASSERT_EQ(params.sensors.size(), 2u);
    EXPECT_EQ(params.sensors[0].high, (crumple::Vec3{1, 1, 1}));
    EXPECT_EQ(params.sensors[1].high, (crumple::Vec3{1, 2, 3}));
    EXPECT_EQ(params.roles.at("engine.001"), example::Method::lloyd);
    EXPECT_EQ(params.boxes.at("a").low, (crumple::Vec3{0, 0, 0}));
    EXPECT_EQ(params.pair[1], 4);
}

TEST(JsonReader, AListReplacesWhatWasThere) {
    Params params;
    params.sensors.resize(3);
    params.sensors[0].low = {5, 5, 5};
    read_json(R"({"sensors": [{}]})", "recipe.json", Described::of(params));
    ASSERT_EQ(params.sensors.size(), 1u);
    EXPECT_EQ(params.sensors[0].low, (crumple::Vec3{-1, -1, -1}));
}

TEST(JsonReader, AnUnknownKeyNamesItsPathAndTheNearestValidName) {
    const std::string text = refusal(R"({"sweep": 3})");
    expect_contains(text, "recipe.json: sweep: unknown key");
    expect_contains(text, "'sweeps'");
    const std::string nested = refusal(R"({"box": {"hihg": [0, 0, 0]}})");
    expect_contains(nested, "box.hihg: unknown key");
    expect_contains(nested, "'box.high'");
    expect_contains(refusal(R"({"sensors": [{}, {"lo": 1}]})"), "sensors[1].lo");
}

TEST(JsonReader, AWrongTypeNamesItsPath) {
    expect_contains(refusal(R"({"sweeps": "5"})"), "sweeps: expected a whole number, found text");
    expect_contains(refusal(R"({"sweeps": 5.5})"), "sweeps: expected a whole number");
    expect_contains(refusal(R"({"sweeps": null})"), "sweeps: expected a whole number");
    expect_contains(refusal(R"({"element": null})"), "element: expected a whole number");
    expect_contains(refusal(R"({"is_graded": 1})"), "is_graded: expected true or false");
    expect_contains(refusal(R"({"box": []})"), "box: expected an object");
    expect_contains(refusal(R"({"box": {"low": [1, 2]}})"), "box.low: expected a list of three numbers");
    expect_contains(refusal(R"({"box": {"low": [1, 2, "x"]}})"), "box.low[2]: expected a number");
    expect_contains(refusal(R"({"roles": {"a": 3}})"), "roles.a: expected text");
    expect_contains(refusal(R"({"sensors": {}})"), "sensors: expected a list");
    expect_contains(refusal(R"({"pair": [1]})"), "pair: expected 2 values");
    expect_contains(refusal(R"([])"), "expected an object");
}

TEST(JsonReader, ANumberOutOfRangeNamesTheRange) {
    expect_contains(refusal(R"({"sweeps": 1001})"), "sweeps: 1001 is out of range; allowed: 0 to 1000");
    expect_contains(refusal(R"({"sweeps": -1})"), "out of range");
    expect_contains(refusal(R"({"sweeps": 18446744073709551616})"), "sweeps");
    expect_contains(refusal(R"({"seed": -1})"), "seed: -1 is out of range");
    expect_contains(refusal(R"({"small": 256})"), "small: 256 is out of range; allowed: 0 to 255");
    expect_contains(refusal(R"({"tolerance": 1.5})"), "tolerance: 1.5 is out of range");
    expect_contains(refusal(R"({"tolerance": 1e999})"), "recipe.json");
    expect_contains(refusal(R"({"box": {"high": [0, 11, 0]}})"), "box.high[1]");
    expect_contains(refusal(R"({"pair": [1, 6]})"), "pair[1]");
}

TEST(JsonReader, AnUnknownChoiceNamesTheChoices) {
    const std::string text = refusal(R"({"method": "ctp"})");
    expect_contains(text, "method: 'ctp' is not one of cpt, odt, lloyd");
    expect_contains(text, "nearest: 'cpt'");
}

TEST(JsonReader, ARepeatedKeyIsRefusedWithItsPath) {
    expect_contains(refusal(R"({"sweeps": 1, "sweeps": 2})"), "sweeps: the key is there twice");
    expect_contains(refusal(R"({"box": {"low": [0,0,0], "low": [0,0,0]}})"), "box.low: the key is there twice");
}

TEST(JsonReader, BrokenTextNamesLineAndColumn) {
    expect_contains(refusal("{\n  \"sweeps\": }"), "line 2");
    expect_contains(refusal("{} x"), "recipe.json");
    expect_contains(refusal("\xff{}"), "recipe.json");
    expect_contains(refusal("{// comment\n}"), "recipe.json");
}

TEST(JsonReader, DeepNestingIsRefusedBeforeTheStackIsSpent) {
    expect_contains(refusal(std::string(1000000, '[')), "nested deeper");
    std::string objects;
    for (int i = 0; i < 100000; ++i) objects += R"({"a":)";
    expect_contains(refusal(objects), "nested deeper");
}

TEST(JsonReader, TooMuchTextIsRefused) {
    Params params;
    const crumple::report::ReadRules rules{.max_bytes = 10};
    EXPECT_THROW(read_json("{           }", "x", Described::of(params), rules), Error);
}

TEST(JsonReader, NullIsNoneOnlyWhereTheRulesAllowIt) {
    Params params;
    params.element = 3;
    const crumple::report::ReadRules rules{.kind = ErrorKind::bad_input, .allows_null = true};
    read_json(R"({"element": null, "tolerance": null})", "x", Described::of(params), rules);
    EXPECT_EQ(params.element, crumple::none);
    EXPECT_TRUE(std::isnan(params.tolerance));
    EXPECT_THROW(read_json(R"({"sweeps": null})", "x", Described::of(params), rules), Error);
}

TEST(Setting, SetsAFieldByItsPath) {
    Params params;
    const Described root = Described::of(params);
    apply_setting("sweeps=5", root);
    apply_setting("method=lloyd", root);
    apply_setting("name=a=b", root);
    apply_setting("is_graded=false", root);
    apply_setting("tolerance=1e-2", root);
    apply_setting("box.low=[0, 1, 2]", root);
    apply_setting("boxes.left.high=[3, 3, 3]", root);
    apply_setting("roles.engine.001=odt", root);
    apply_setting(R"(sensors=[{"low": [0, 0, 0]}])", root);
    EXPECT_EQ(params.sweeps, 5);
    EXPECT_EQ(params.method, example::Method::lloyd);
    EXPECT_EQ(params.name, "a=b");
    EXPECT_FALSE(params.is_graded);
    EXPECT_EQ(params.tolerance, 0.01);
    EXPECT_EQ(params.box.low, (crumple::Vec3{0, 1, 2}));
    EXPECT_EQ(params.boxes.at("left").high, (crumple::Vec3{3, 3, 3}));
    EXPECT_EQ(params.roles.at("engine.001"), example::Method::odt);
    EXPECT_EQ(params.sensors.size(), 1u);
}

TEST(Setting, RefusesWhatTheRecipeWouldRefuse) {
    expect_contains(setting_refusal("sweep=5"), "--set sweep=5: sweep: unknown key");
    expect_contains(setting_refusal("sweep=5"), "'sweeps'");
    expect_contains(setting_refusal("box.lo=5"), "'box.low'");
    expect_contains(setting_refusal("sweeps=x"), "--set sweeps=x");
    expect_contains(setting_refusal("sweeps="), "--set sweeps=");
    expect_contains(setting_refusal("sweeps=1001"), "out of range");
    expect_contains(setting_refusal("sweeps.x=1"), "sweeps: has no fields");
    expect_contains(setting_refusal("sweeps"), "path=value");
    expect_contains(setting_refusal("=5"), "path=value");
    expect_contains(setting_refusal("method=x"), "not one of");
}
