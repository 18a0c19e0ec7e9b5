// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/check_provenance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/check.h"
#include "pipeline/exit_codes.h"
#include "pipeline/small_work.h"
#include "pipeline/work_file.h"

using crumple::pipeline::check_image;
using crumple::pipeline::check_provenance;
using crumple::pipeline::work_image;
using crumple::pipeline::Workspace;

namespace {

// What is said of a cooked workspace whose provenance was changed.
template <class Change>
std::string complaint_of(const Change& change) {
    Workspace work = small_work::cooked();
    change(work.bundle->provenance);
    const auto findings = check_provenance(work);
    return findings.size() == 1 ? findings[0].message : std::to_string(findings.size()) + " findings";
}

}

TEST(CheckProvenance, WhatWasCookedIsTrue) {
    EXPECT_TRUE(check_provenance(small_work::cooked()).empty());
    const auto check = check_image(work_image(small_work::cooked(), {}), "a.hdf");
    EXPECT_TRUE(check.problems.empty());
}

TEST(CheckProvenance, EachPartIsHeldAgainstTheRecord) {
    using Provenance = crumple::BundleProvenance;
    EXPECT_NE(complaint_of([](Provenance& p) { p.recipe.pop_back(); }).find("no JSON"), std::string::npos);
    EXPECT_NE(complaint_of([](Provenance& p) { p.recipe.clear(); }).find("no JSON"), std::string::npos);
    EXPECT_NE(complaint_of([](Provenance& p) { p.recipe = "{}"; }).find("not that of its stages"), std::string::npos);
    EXPECT_NE(complaint_of([](Provenance& p) { p.stage_versions[0].value = "99"; }).find("versions"),
              std::string::npos);
    EXPECT_NE(complaint_of([](Provenance& p) { p.input_digests[0].value[0] = 'b'; }).find("digests"),
              std::string::npos);
    EXPECT_EQ(complaint_of([](Provenance& p) { p.recipe.insert(1, " "); }), "0 findings");  // the same recipe
}

TEST(CheckProvenance, AnUntrueBundleIsDamaged) {
    Workspace work = small_work::cooked();
    work.bundle->provenance.input_digests[0].value[0] = 'b';
    const auto check = check_image(work_image(work, {}), "a.hdf");
    EXPECT_EQ(check.exit_code, crumple::pipeline::exit_difference);
    ASSERT_EQ(check.problems.size(), 1u);
    EXPECT_EQ(check.problems[0].code, "BUNDLE_PROVENANCE");
}

TEST(CheckProvenance, WithoutARecordTheRecipeMustStillBeJson) {
    Workspace work = small_work::cooked();
    work.records.clear();
    work.bundle->provenance.recipe = "{}";
    EXPECT_TRUE(check_provenance(work).empty());
    work.bundle->provenance.recipe = "{";
    EXPECT_EQ(check_provenance(work).size(), 1u);
}

TEST(CheckProvenance, TheToolVersionIsOne) {
    using Provenance = crumple::BundleProvenance;
    for (const char* version :
         {"", "1", "1.2", "1.2.", "1.2.3.4", "1.2.x", "v1.2.3", "1.2.3-", "1.2.3 ", "-1.2.3", "1..3"}) {
        EXPECT_NE(complaint_of([&](Provenance& p) { p.tool_version = version; }).find("is none"), std::string::npos)
            << version;
    }
    for (const char* version : {"0.0.1", "1.2.3", "99.0.0-rc.1+build"})
        EXPECT_EQ(complaint_of([&](Provenance& p) { p.tool_version = version; }), "0 findings") << version;
}

TEST(CheckProvenance, ANewerProgramsBundleIsReadAndSaysSo) {
    Workspace work = small_work::cooked();
    const auto says_newer = [&] {
        const auto check = check_image(work_image(work, {}), "a.hdf");
        EXPECT_NE(check.exit_code, crumple::pipeline::exit_difference);
        return std::any_of(check.findings.begin(), check.findings.end(),
                           [](const crumple::Finding& f) { return f.code == "BUNDLE_NEWER"; });
    };
    EXPECT_FALSE(says_newer());
    work.bundle->provenance.tool_version = "99.0.0";
    EXPECT_TRUE(says_newer());
    work.bundle->provenance.tool_version = "0.0.0";
    EXPECT_FALSE(says_newer());
}
