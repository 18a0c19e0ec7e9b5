// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/runner.h"

#include <gtest/gtest.h>

#include <set>

#include "core/error.h"
#include "pipeline/small_work.h"

using crumple::Error;
using crumple::ErrorKind;
using crumple::pipeline::Group;
using crumple::pipeline::Stage;
using crumple::pipeline::stage_table;
using crumple::pipeline::Workspace;

namespace {

std::string refusal(const char* stage, Workspace work) {
    try {
        (void)small_work::run(stage, work);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.what();
    }
    ADD_FAILURE() << stage << " ran";
    return {};
}

}

TEST(StageTable, GroupsAreWrittenInTheirOrder) {
    Group last = Group::asset;
    for (const Stage& stage : stage_table()) {
        EXPECT_GE(stage.writes, last) << stage.name;
        last = stage.writes;
        for (const Group read : stage.reads) EXPECT_LE(read, stage.writes) << stage.name;
    }
    EXPECT_EQ(last, Group::bundle);
}

TEST(StageTable, EveryStageHasHelpAVersionAndNamesOfItsOwn) {
    std::set<std::string_view> names;
    for (const Stage& stage : stage_table()) {
        EXPECT_GE(stage.version, 1);
        EXPECT_FALSE(stage.help.empty());
        EXPECT_TRUE(names.insert(stage.name).second);
    }
}

TEST(StageTable, EveryReportHasFindings) {
    for (const Stage& stage : stage_table()) {
        const auto report = stage.make_report();
        bool has_findings = false;
        for (const auto& field : report.view().fields()) {
            has_findings = has_findings || field.value.get_if<std::vector<crumple::Finding>>();
        }
        EXPECT_TRUE(has_findings) << stage.name;
    }
}

TEST(StageTable, AnUnknownStageNamesTheNearest) {
    try {
        (void)crumple::pipeline::find_stage("relaxx");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("'relax'"), std::string::npos);
    }
}

TEST(Runner, AStageWithoutItsInputSaysWhatToRunFirst) {
    EXPECT_NE(refusal("sample", {}).find("crumple import first"), std::string::npos);
    EXPECT_NE(refusal("delaunay", small_work::imported()).find("crumple sample first"), std::string::npos);
    EXPECT_NE(refusal("bake", small_work::imported()).find("crumple delaunay first"), std::string::npos);
}

TEST(Runner, AStageThatChangesItsInputRunsOnce) {
    EXPECT_NE(refusal("relax", small_work::cooked()).find("already"), std::string::npos);
    EXPECT_NE(refusal("cull", small_work::cooked()).find("already"), std::string::npos);
}

TEST(Runner, RunningAStageAgainForgetsWhatCameAfterIt) {
    Workspace work = small_work::cooked();
    (void)small_work::run("sample", work);
    EXPECT_TRUE(work.points);
    EXPECT_FALSE(work.tets || work.bindings || work.bundle);
    ASSERT_EQ(work.records.size(), 2u);
    EXPECT_EQ(work.records[1].name, "sample");
}

TEST(Runner, ARecordOfAnotherVersionsStageIsDroppedWithWhatComesAfter) {
    Workspace work = small_work::imported();
    work.records.push_back({"polish", 1, {"{}"}, {"{}"}});
    (void)small_work::run("sample", work);
    EXPECT_EQ(work.records.back().name, "sample");
    EXPECT_EQ(work.records.size(), 2u);
}

TEST(Runner, TheBundleKnowsHowItCameToBe) {
    const Workspace work = small_work::cooked();
    const auto& provenance = work.bundle->provenance;
    EXPECT_EQ(provenance.stage_versions.size(), crumple::pipeline::stage_table().size());
    EXPECT_EQ(provenance.stage_versions[0].name, "import");
    EXPECT_EQ(provenance.input_digests, work.input_digests);
    EXPECT_NE(provenance.recipe.find("\"sweeps\""), std::string::npos);
}

TEST(Runner, TheObserverHearsBeginProgressAndEnd) {
    Workspace work = small_work::imported();
    std::vector<std::string> heard;
    crumple::pipeline::Observer observer;
    observer.begin = [&](const Stage& stage) { heard.push_back("begin " + std::string(stage.name)); };
    observer.end = [&](const Stage& stage, const auto& run, auto) {
        heard.push_back("end " + std::string(stage.name));
        EXPECT_EQ(run.name, stage.name);
    };
    const Stage& sample = crumple::pipeline::find_stage("sample");
    (void)run_stage(sample, sample.make_params(), work, 1, observer);
    EXPECT_EQ(heard, (std::vector<std::string>{"begin sample", "end sample"}));
}

TEST(Runner, TheSameRecordForAnyNumberOfThreads) {
    Workspace one = small_work::imported();
    Workspace many = small_work::imported();
    const Stage& sample = crumple::pipeline::find_stage("sample");
    (void)run_stage(sample, sample.make_params(), one, 1);
    (void)run_stage(sample, sample.make_params(), many, 4);
    EXPECT_EQ(one.records[1].report.text, many.records[1].report.text);
    EXPECT_EQ(one.points->positions, many.points->positions);
}
