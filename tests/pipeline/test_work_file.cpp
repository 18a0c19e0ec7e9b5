// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/work_file.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "core/error.h"
#include "pipeline/cook_record.h"
#include "pipeline/small_work.h"
#include "pipeline/work_parts.h"
#include "store/write_file.h"

using crumple::Error;
using crumple::ErrorKind;
using crumple::pipeline::FileContents;
using crumple::pipeline::Group;
using crumple::pipeline::read_work_image;
using crumple::pipeline::work_image;
using crumple::pipeline::Workspace;

namespace {

// Writes what `change` made of a cooked workspace and expects it to be refused with a word of the message.
template <class Change>
void expect_refusal(const Change& change, const std::string& part) {
    Workspace work = small_work::cooked();
    work.bundle.reset();
    change(work);
    try {
        (void)read_work_image(work_image(work, {}), "work.hdf");
        ADD_FAILURE() << "accepted, expected: " << part;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        EXPECT_NE(std::string(error.what()).find("work.hdf"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

}

TEST(WorkFile, AnEmptyWorkspaceComesBackEmpty) {
    const Workspace back = read_work_image(work_image({}, {}), "x");
    for (const auto& group : crumple::pipeline::group_names) EXPECT_FALSE(has_group(back, group.value));
    EXPECT_TRUE(back.records.empty());
}

TEST(WorkFile, EveryPartComesBackAsItWas) {
    const Workspace work = small_work::cooked();
    const std::vector<std::byte> image = work_image(work, {});
    const Workspace back = read_work_image(image, "x");
    EXPECT_EQ(back.asset->shell.positions, work.asset->shell.positions);
    EXPECT_EQ(back.asset->shell.components[0].name, work.asset->shell.components[0].name);
    EXPECT_EQ(back.asset->locked_positions, work.asset->locked_positions);
    EXPECT_EQ(back.asset->visuals[0].positions, work.asset->visuals[0].positions);
    EXPECT_EQ(back.points->positions, work.points->positions);
    EXPECT_EQ(back.tets->tets, work.tets->tets);
    EXPECT_EQ(back.tets->region, work.tets->region);
    EXPECT_EQ((*back.bindings)[0].barycentric, (*work.bindings)[0].barycentric);
    EXPECT_EQ(back.bundle->rest_positions, work.bundle->rest_positions);
    EXPECT_EQ(back.bundle->provenance.recipe, work.bundle->provenance.recipe);
    EXPECT_EQ(crumple::pipeline::cook_record_json(back), crumple::pipeline::cook_record_json(work));
    // The strongest form of all of the above.
    EXPECT_EQ(work_image(back, {}), image);
}

TEST(WorkFile, WithoutWorkOnlyTheBundleIsThere) {
    const Workspace back = read_work_image(work_image(small_work::cooked(), {.has_work = false}), "x");
    EXPECT_FALSE(back.asset || back.points || back.tets || back.bindings);
    ASSERT_TRUE(back.bundle);
    EXPECT_EQ(back.records.size(), crumple::pipeline::stage_table().size());
}

TEST(WorkFile, TheSameWorkspaceGivesTheSameBytes) {
    const Workspace work = small_work::cooked();
    EXPECT_EQ(work_image(work, {}), work_image(work, {}));
}

TEST(WorkFile, IndicesOutOfRangeAreRefused) {
    expect_refusal([](Workspace& w) { w.asset->shell.triangles[0][1] = 1000; }, "/asset/shell");
    expect_refusal([](Workspace& w) { w.asset->shell.component[0] = 7; }, "/asset/shell");
    expect_refusal([](Workspace& w) { w.asset->visuals[0].triangles[0][2] = 3; }, "/asset/visual/0");
    expect_refusal([](Workspace& w) { w.tets->tets[0][3] = 100000; }, "/tets");
    expect_refusal([](Workspace& w) { w.tets->neighbours[0][0] = 99999; }, "/tets");
    expect_refusal([](Workspace& w) { w.tets->region[0] = 5; }, "/tets/region");
    expect_refusal([](Workspace& w) { (*w.bindings)[0].tet[0] = 99999; }, "/bindings");
    expect_refusal([](Workspace& w) { w.points->shell_vertex_count = 1u << 30; }, "/points");
}

TEST(WorkFile, SizesThatDoNotFitAreRefused) {
    expect_refusal([](Workspace& w) { w.asset->shell.locked.pop_back(); }, "/asset/shell");
    expect_refusal([](Workspace& w) { w.asset->visuals[0].source_vertex.pop_back(); }, "source_vertex");
    expect_refusal([](Workspace& w) { w.tets->region.pop_back(); }, "/tets");
    expect_refusal([](Workspace& w) { (*w.bindings)[0].distance.pop_back(); }, "/bindings/0/distance");
    expect_refusal([](Workspace& w) { w.bindings->clear(); }, "/bindings");
    expect_refusal([](Workspace& w) { w.tets->shell_vertex_count -= 1; }, "/tets");
}

TEST(WorkFile, NumbersThatAreNoneAndTetsInsideOutAreRefused) {
    const double bad = std::numeric_limits<double>::quiet_NaN();
    expect_refusal([&](Workspace& w) { w.points->positions[0].x = bad; }, "/points/positions");
    expect_refusal([&](Workspace& w) { w.tets->positions[0].y = bad; }, "/tets/positions");
    expect_refusal([&](Workspace& w) { w.asset->visuals[0].positions[0].z = bad; }, "/asset/visual/0/positions");
    expect_refusal([](Workspace& w) { std::swap(w.tets->tets[0][0], w.tets->tets[0][1]); }, "/tets");
}

TEST(WorkFile, PartsOfTwoCooksAreRefused) {
    expect_refusal([](Workspace& w) { w.asset->shell.positions[0].x += 1; }, "/tets does not fit the shell");
    expect_refusal([](Workspace& w) { w.points->shell_vertex_count -= 1; }, "/points/shell_vertex_count");
    expect_refusal([](Workspace& w) { w.points->positions.back().x = 0.1; }, "must be finite floats");
    expect_refusal(
        [](Workspace& w) {
            w.points->positions[0].x += 1;
            w.tets.reset();
            w.bindings.reset();
        },
        "do not begin with the shell's");
    expect_refusal([](Workspace& w) { (*w.bindings)[0].barycentric[0][0] += 1; }, "weights do not sum to 1");
    expect_refusal([](Workspace& w) { (*w.bindings)[0].distance[0] = -1; }, "a negative one");
}

TEST(WorkFile, AStageIsGivenNoBundleThatIsNotSound) {
    Workspace work = small_work::cooked();
    work.bundle->tets[0][0] = 1u << 30;
    const std::string path = testing::TempDir() + "crumple_unsound.hdf";
    crumple::store::write_file(path, work_image(work, {}));
    try {
        (void)crumple::pipeline::read_work_file(path);
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        EXPECT_NE(std::string(error.what()).find("BUNDLE_INDEX"), std::string::npos) << error.what();
    }
    std::remove(path.c_str());
}

TEST(WorkFile, ARecordThatIsNoneIsRefused) {
    expect_refusal([](Workspace& w) { w.bindings.reset(), w.records[0].name.assign(70u << 20, 'x'); }, "/cook/record");
}

TEST(WorkFile, PointsWithoutAShellMayBeAnyDoubles) {
    Workspace work;
    work.points.emplace();
    work.points->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.2, 0.3}};
    (void)small_work::run("delaunay", work);
    EXPECT_EQ(read_work_image(work_image(work, {}), "x").tets->positions[3], (crumple::Vec3{0.1, 0.2, 0.3}));
}
