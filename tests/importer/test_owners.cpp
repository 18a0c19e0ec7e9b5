// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/owners.h"

#include <gtest/gtest.h>

#include "importer/import.h"
#include "importer/import_checks.h"
#include "importer/obj_text.h"
#include "importer/temp_folder.h"
#include "mesh/shapes.h"

namespace crumple::importer {
namespace {

using test::obj_text;
using test::TempFolder;

TEST(Owners, AVisualMeshGetsTheOwnerOfItsName) {
    const TempFolder folder;
    Sources sources;
    sources.shell = folder.write("shell.obj", obj_text(shapes::box()));
    sources.visuals = {{"skin", folder.write("a.obj", obj_text(shapes::box()))},
                       {"wheels", folder.write("b.obj", obj_text(shapes::box()))}};
    Params params;
    params.owners = {{"wheels", "axle"}};
    const Result result = import_asset(sources, params);
    EXPECT_EQ(result.asset.visuals.at(0).shell_component, "");
    EXPECT_EQ(result.asset.visuals.at(1).shell_component, "axle");
    EXPECT_EQ(test::find(result.report.findings, "OWNER_UNKNOWN"), nullptr);
}

TEST(Owners, ANameThatNoVisualMeshHasIsTold) {
    std::vector<VisualMesh> visuals(1);
    visuals[0].name = "skin";
    const std::vector<Finding> findings = assign_owners({{"skn", "body"}}, visuals);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].code, "OWNER_UNKNOWN");
    EXPECT_EQ(findings[0].severity, Severity::warning);
    EXPECT_TRUE(test::contains(findings[0].message, "'skn'"));
    EXPECT_EQ(visuals[0].shell_component, "");
}

}
}
