// SPDX-License-Identifier: GPL-3.0-or-later
// Real shells and visual meshes: everything imports, or is refused with its reason.
#include <array>
#include <map>

#include "importer/import_checks.h"

namespace crumple::importer {
namespace {

using test::has;
using test::import_shell;

std::string open_file(const std::string& name) { return (test::data_folder() / "open" / name).string(); }
std::string quality_file(const std::string& name) { return (test::data_folder() / "quality" / name).string(); }

Result import_pair(const std::string& shell, const std::string& visual, const Params& params = {}) {
    Sources sources;
    sources.shell = open_file(shell);
    sources.visuals.push_back({"", open_file(visual)});
    return import_asset(sources, params);
}

TEST(OpenData, EveryFileImportsOrIsRefusedWithAReason) {
    CRUMPLE_NEEDS_DATA();
    std::size_t imported = 0;
    std::size_t refused = 0;
    for (const char* folder : {"open", "quality", "locks/car_body"}) {
        for (const auto& entry : std::filesystem::directory_iterator(test::data_folder() / folder)) {
            const std::string path = entry.path().string();
            if (test::contains(path, "mengersponge3")) continue;  // slow to judge, and has a test of its own
            const bool is_visual = test::contains(path, "_visual");
            try {
                const Result result =
                    is_visual ? import_pair("spot_shell.obj", entry.path().filename()) : import_shell(path);
                EXPECT_FALSE(result.asset.shell.triangles.empty()) << path;
                EXPECT_EQ(result.asset.visuals.size(), is_visual ? 1u : 0u);
                ++imported;
            } catch (const Error& error) {
                EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
                EXPECT_GT(std::string(error.what()).size(), path.size() + 10) << error.what();
                ++refused;
            }
        }
    }
    EXPECT_GE(imported, 70u);
    EXPECT_GE(refused, 10u);
}

TEST(OpenData, SpongeOfManyHolesIsCleanAndLocked) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_shell(open_file("mengersponge3_vertexcolours.glb"));
    EXPECT_EQ(result.report.locked, 296u);
    EXPECT_EQ(result.asset.shell.positions.size(), 7983u);
    for (const Finding& finding : result.report.findings) EXPECT_EQ(finding.code, "SHELL_NEEDLE");
}

TEST(OpenData, CarBodyHasACabin) {
    CRUMPLE_NEEDS_DATA();
    const Report report = import_shell(open_file("femfx_car_body_shell.obj")).report;
    ASSERT_EQ(report.components.size(), 2u);
    EXPECT_EQ(report.components[0].name, "car-body-tets");
    EXPECT_EQ(report.components[0].role, Role::solid);
    EXPECT_EQ(report.components[1].name, "car-body-tets.2");
    EXPECT_EQ(report.components[1].role, Role::cavity);
    EXPECT_EQ(report.components[1].parent, "car-body-tets");
    EXPECT_TRUE(test::contains(report.components[1].reason, "inwards inside 'car-body-tets'"));
}

TEST(OpenData, CarOfEightShellsKeepsTheirNamesAndOverlaps) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_shell(open_file("femfx_car_all_shell.obj"));
    EXPECT_EQ(result.report.components.size(), 9u);  // the body has a cabin
    EXPECT_EQ(result.asset.shell.positions.size(), 548u);
    EXPECT_TRUE(has(result.report, "SHELL_OVERLAPPING"));
    EXPECT_FALSE(has(result.report, "SHELL_SELF_INTERSECTING"));
    EXPECT_EQ(result.report.components.back().name, "car-wheel3-tets");
}

TEST(OpenData, BridgeCageHasAReversedInnerComponentAndUnusedVertices) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_pair("simplebridge_cage.obj", "simplebridge_visual.obj");
    EXPECT_EQ(result.report.unused_vertices, 139u);
    EXPECT_EQ(result.report.components.size(), 2u);
    EXPECT_EQ(result.report.components[1].role, Role::cavity);
    EXPECT_EQ(result.report.open_edges, 0u);
    ASSERT_EQ(result.asset.visuals.size(), 1u);
    EXPECT_EQ(result.asset.visuals[0].name, "simplebridge_visual");
    EXPECT_EQ(result.asset.visuals[0].positions.size(), 16085u);  // the `v` lines of the file
}

TEST(OpenData, TruckVisualIsPlacedByItsNodes) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_pair("kenney_truck_shell.obj", "kenney_truck_visual.glb");
    const VisualMesh& visual = result.asset.visuals.at(0);
    EXPECT_EQ(visual.positions.size(), 1890u);
    EXPECT_EQ(visual.triangles.size(), 1104u);
    Vec3 low{1e9, 1e9, 1e9};
    Vec3 high{-1e9, -1e9, -1e9};
    for (const Vec3& p : result.asset.shell.positions) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    for (const Vec3& p : visual.positions) {  // the shell encloses the visual mesh
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_GE(p[axis], low[axis]);
            ASSERT_LE(p[axis], high[axis]);
        }
    }
}

TEST(OpenData, CentimetresBecomeMetresByUnit) {
    CRUMPLE_NEEDS_DATA();
    Params params;
    params.unit = 0.01;
    const Result result = import_pair("prius_shell.obj", "prius_visual.obj", params);
    EXPECT_NEAR(result.report.diagonal, 5.41741, 1e-4);
    EXPECT_EQ(result.asset.visuals.at(0).positions.size(), 1270u);
}

TEST(OpenData, ColladaInInchesWithZUp) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_shell(open_file("kwxport_vcolors.dae"));
    EXPECT_EQ(result.report.shell.unit, 0.0254);
    EXPECT_EQ(result.report.shell.up, "z");
    EXPECT_EQ(result.asset.shell.positions.size(), 8u);
    EXPECT_NEAR(result.report.components.at(0).volume, 1, 1e-4);  // a cube of one metre
    EXPECT_EQ(result.report.locked, 2u);
}

TEST(OpenData, DirtyShellsAreJudged) {
    CRUMPLE_NEEDS_DATA();
    const Report cow = import_shell(quality_file("cow.obj")).report;
    EXPECT_TRUE(has(cow, "SHELL_SELF_INTERSECTING"));
    EXPECT_FALSE(has(cow, "SHELL_OPEN"));
    const Report suzanne = import_shell(quality_file("suzanne.obj")).report;
    EXPECT_TRUE(has(suzanne, "SHELL_OPEN"));
    EXPECT_TRUE(has(suzanne, "SHELL_NON_MANIFOLD"));
    const Report nest = import_shell(quality_file("boxnest.obj")).report;
    EXPECT_TRUE(has(nest, "SHELL_NESTED"));
    EXPECT_EQ(nest.components.at(1).role, Role::solid);
    EXPECT_TRUE(has(import_shell(quality_file("fandisk.obj")).report, "SHELL_NEEDLE"));
    for (const char* clean : {"spot.obj", "bonnet.obj", "carhood.obj"}) {
        for (const Finding& finding : import_shell(quality_file(clean)).report.findings) {
            const bool is_about_needles = clean[0] == 's' && finding.code == "SHELL_NEEDLE";
            EXPECT_TRUE(finding.code == "LOCK_NOTHING_PAINTED" || is_about_needles) << clean << finding.code;
        }
    }
}

// What the text says, correctly rounded: assimp's own parser is an ulp off here and there.
TEST(OpenData, TextPositionsAreTheNearestFloats) {
    CRUMPLE_NEEDS_DATA();
    for (const char* name : {"prius_visual.obj", "simplebridge_visual.obj", "femfx_car_body_shell.obj"}) {
        const Result result = import_pair("spot_shell.obj", name);
        std::ifstream file(open_file(name));
        std::vector<Vec3> wanted;
        for (std::string line; std::getline(file, line);) {
            if (!line.starts_with("v ")) continue;
            char* next = line.data() + 2;
            float p[3];
            for (float& x : p) x = std::strtof(next, &next);
            wanted.push_back({p[0], p[1], p[2]});
        }
        EXPECT_EQ(result.asset.visuals.at(0).positions, wanted) << name;
    }
}

}
}
