// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/cook.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <span>

#include "core/error.h"
#include "pipeline/builtin_recipes.h"
#include "pipeline/output_file.h"
#include "samples/samples.h"
#include "store/read_file.h"
#include "store/write_file.h"

using namespace crumple;
using namespace crumple::pipeline;

namespace {

class Cook : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(folder_);
        request_.sources.shell = samples::write("blob", folder_).front();
        request_.output = folder_ + "/out.hdf";
        const RecipeText text = load_recipe_text("smoke");
        recipe_ = read_recipe(text.json, text.source);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    // Tests run beside each other.
    std::string folder_ =
        testing::TempDir() + "crumple_cook_" + testing::UnitTest::GetInstance()->current_test_info()->name();
    CookRequest request_;
    Recipe recipe_;
    CookReport report_;
};

}

TEST_F(Cook, WhatIsToldBeforeTheOutputIsWhatTheReportSaysInTheEnd) {
    std::string told;
    request_.before_output = [&](const CookReport& report) {
        EXPECT_FALSE(std::filesystem::exists(request_.output));
        told = report.output.sha256 + report.stopped_in;
    };
    cook(recipe_, request_, report_);
    EXPECT_TRUE(std::filesystem::exists(request_.output));
    EXPECT_EQ(told, report_.output.sha256);
    EXPECT_EQ(report_.stopped_in, "");
}

TEST_F(Cook, WhatCannotBeWrittenBesideTheOutputLeavesTheOldOne) {
    const std::string old = "old";
    store::write_file(request_.output, std::as_bytes(std::span(old)));
    request_.before_output = [](const CookReport&) { throw Error(ErrorKind::file, "the disk is full"); };
    EXPECT_THROW(cook(recipe_, request_, report_), Error);
    const auto bytes = std::as_bytes(std::span(old));
    EXPECT_TRUE(holds(request_.output, {bytes.begin(), bytes.end()}));
}
