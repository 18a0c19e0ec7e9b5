// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/import.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <set>
#include <string>
#include <vector>

#include "importer/import_checks.h"
#include "importer/obj_text.h"
#include "importer/temp_folder.h"
#include "mesh/shapes.h"
#include "sandbox/child_side.h"
#include "sandbox/process_memory.h"

namespace crumple::importer {
namespace {

using test::contains;
using test::find;
using test::has;
using test::import_shell;
using test::obj_text;
using test::refusal_of_file;
using test::TempFolder;

Result import_obj(const Shell& shell, const Params& params = {}) {
    const TempFolder folder;
    return import_shell(folder.write("shell.obj", obj_text(shell)), params);
}

Shell two(const Shell& a, const Shell& b) { return shapes::joined(a, b); }

TEST(Import, PathThatCannotBeOpenedIsAFileError) {
    const TempFolder folder;
    EXPECT_EQ(refusal_of_file((folder.path() / "absent.obj").string()).kind, ErrorKind::file);
    EXPECT_EQ(refusal_of_file("").kind, ErrorKind::file);
    EXPECT_EQ(refusal_of_file(folder.path().string()).kind, ErrorKind::file);
    const std::string pipe = (folder.path() / "pipe.obj").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(refusal_of_file(pipe).kind, ErrorKind::file);
}

// The limit is for good: in a process of its own.
[[noreturn]] void import_with_little_memory(const std::string& path) {
    const rlim_t most = sandbox::memory_of(getpid()).address_space + (rlim_t{8} << 20);
    const rlimit limit{most, most};
    setrlimit(RLIMIT_AS, &limit);
    const auto refusal = refusal_of_file(path);
    const bool is_told = refusal.kind == ErrorKind::budget && contains(refusal.message, "ulimit -v");
    _exit(is_told ? 0 : 1);
}

TEST(Import, MemoryThatTheSystemDoesNotLeaveIsNoFaultOfTheFile) {
    if (sandbox::has_sanitizer) GTEST_SKIP() << "AddressSanitizer's own mappings exclude a limit on the address space";
    const TempFolder folder;
    const std::string path = folder.write("large.obj", obj_text(shapes::subdivided_box(60)));
    EXPECT_EXIT(import_with_little_memory(path), ::testing::ExitedWithCode(0), "");
}

TEST(Import, UnknownExtensionSaysWhichFormatsWork) {
    const TempFolder folder;
    for (const char* name : {"a.blend", "a", "a.obj.txt", ".obj"}) {
        const auto refusal = refusal_of_file(folder.write(name, "v 0 0 0\n"));
        EXPECT_EQ(refusal.kind, ErrorKind::bad_input) << name;
        EXPECT_TRUE(contains(refusal.message, ".obj, .ply, .off, .stl, .gltf, .glb, .dae, .fbx, .x"))
            << refusal.message;
    }
}

TEST(Import, ExtensionIsReadInAnyCase) {
    const TempFolder folder;
    EXPECT_EQ(import_shell(folder.write("A.OBJ", obj_text(shapes::box()))).report.shell.format, "Wavefront OBJ");
}

// How many triangles of a box of some size and a changed copy of it lie nearly on another one.
template <class Change>
std::uint64_t nearly_double(double size, const Change& change) {
    const Shell box = shapes::subdivided_box(4);
    Shell copy = box;
    for (Vec3& p : copy.positions) p = change(p);
    Shell both = two(box, copy);
    for (Vec3& p : both.positions) p = p * size;
    const Result result = import_obj(both);
    const Finding* finding = find(result.report.findings, "SHELL_NEARLY_DOUBLE");
    return finding ? finding->count : 0;
}

TEST(Import, ACopyOfASurfaceNearItIsTold) {
    const std::uint64_t all = 2 * shapes::subdivided_box(4).triangles.size();
    for (const double size : {1.0, 1e-3, 1e4}) {
        EXPECT_EQ(nearly_double(size, [](Vec3 p) { return p * (1 - 2e-6) + Vec3{1e-6, 1e-6, 1e-6}; }), all);
        EXPECT_GT(nearly_double(size, [](Vec3 p) { return p + Vec3{1e-6, 1e-6, 1e-6}; }), all / 2) << "they cross";
        EXPECT_EQ(nearly_double(size, [](Vec3 p) { return p + Vec3{1e-2, 1e-2, 1e-2}; }), 0u);
        EXPECT_EQ(nearly_double(size, [](Vec3 p) { return p + Vec3{1 + 1e-6, 0, 0}; }), 0u) << "solids that touch";
    }
}

TEST(Import, BoxComesThroughAsItIs) {
    const Result result = import_obj(shapes::box());
    EXPECT_EQ(result.asset.shell.positions, shapes::box().positions);
    EXPECT_EQ(result.asset.shell.triangles, shapes::box().triangles);
    EXPECT_EQ(result.report.vertices, 8u);
    EXPECT_EQ(result.report.triangles, 12u);
    EXPECT_EQ(result.report.shell.vertices, 8u);
    EXPECT_EQ(result.report.shell.up, "y");
    EXPECT_EQ(result.asset.shell.component, std::vector<Index>(12, 0));
    EXPECT_EQ(result.asset.shell.locked, std::vector<std::uint8_t>(8, 0));
    EXPECT_TRUE(result.asset.locked_positions.empty());
}

TEST(Import, PolygonsAreSplitAndPointsAndLinesCounted) {
    const TempFolder folder;
    const std::string quads =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nl 1 7\np 3\n";
    const Result result = import_shell(folder.write("quads.obj", quads));
    EXPECT_EQ(result.report.triangles, 12u);
    EXPECT_DOUBLE_EQ(result.report.components.at(0).volume, 1);
    EXPECT_EQ(result.report.shell.points_and_lines, 2u);
    EXPECT_TRUE(has(result.report, "FILE_POINTS_AND_LINES"));
    EXPECT_FALSE(has(result.report, "FILE_FACES_LOST"));
}

TEST(Import, WhatEnclosesNothingIsRefused) {
    const TempFolder folder;
    const auto none_at_all = refusal_of_file(folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"));
    EXPECT_EQ(none_at_all.kind, ErrorKind::bad_input);
    EXPECT_TRUE(contains(none_at_all.message, "no faces")) << none_at_all.message;
    const auto flat =
        refusal_of_file(folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n"));
    EXPECT_TRUE(contains(flat.message, "SHELL_FLAT")) << flat.message;
    const auto needles = refusal_of_file(folder.write("needle.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"));
    EXPECT_TRUE(contains(needles.message, "SHELL_EMPTY")) << needles.message;
}

TEST(Import, NonFinitePositionsAreRefused) {
    const TempFolder folder;
    for (const char* number : {"nan", "inf", "1e39", "-1e200"}) {
        const auto refusal =
            refusal_of_file(folder.write("a.obj", std::string("v 0 0 ") + number + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        EXPECT_EQ(refusal.kind, ErrorKind::bad_input) << number;
        EXPECT_TRUE(contains(refusal.message, "line 1: coordinate")) << refusal.message;
    }
}

TEST(Import, IndicesBeyondTheListAreRefused) {
    const TempFolder folder;
    EXPECT_EQ(refusal_of_file(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")).kind,
              ErrorKind::bad_input);
    EXPECT_EQ(refusal_of_file(folder.write("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n")).kind,
              ErrorKind::bad_input);
}

struct Case {
    const char* code;
    Shell shell;
};

TEST(Import, EveryKindOfDirtHasItsFinding) {
    const Shell box = shapes::box();
    Shell turned = box;
    std::swap(turned.triangles[0][0], turned.triangles[0][1]);
    Shell twice = box;
    twice.triangles.push_back(box.triangles[5]);
    Shell fin = box;
    fin.positions.push_back({0.5, 0.5, -0.1});
    fin.triangles.push_back({box.triangles[0][0], box.triangles[0][1], 8});
    Shell needle = box;
    needle.positions.insert(needle.positions.end(), {{5, 0, 0}, {6, 0, 0}, {7, 0, 0}});
    needle.triangles.push_back({8, 9, 10});
    Shell folded = shapes::icosphere(1, 2);
    folded.positions[0] = folded.positions[0] * -2.0;
    const Case cases[] = {
        {"SHELL_OPEN", shapes::without_triangle(box)},
        {"SHELL_NON_MANIFOLD", fin},
        {"SHELL_PINCHED", two(box, shapes::box({1, 1, 1}, {2, 2, 2}))},
        {"SHELL_INCONSISTENT", turned},
        {"SHELL_SELF_INTERSECTING", folded},
        {"SHELL_DUPLICATE", twice},
        {"SHELL_DEGENERATE", needle},
        {"SHELL_NESTED", shapes::nested_boxes()},
        {"SHELL_INVERTED", shapes::inverted(box)},
        {"SHELL_OVERLAPPING", two(box, shapes::box({0.5, 0.5, 0.5}, {2, 2, 2}))},
        {"SHELL_FAR_FROM_ORIGIN", shapes::moved(box, {1e5, 0, 0})},
        {"LOCK_NOTHING_PAINTED", box},
    };
    for (const Case& c : cases) {
        const Result result = import_obj(c.shell);
        const Finding* finding = find(result.report.findings, c.code);
        ASSERT_NE(finding, nullptr) << c.code;
        EXPECT_GT(finding->count, 0u) << c.code;
        EXPECT_FALSE(finding->message.empty()) << c.code;
        EXPECT_FALSE(finding->places.empty()) << c.code;
        EXPECT_LE(finding->places.size(), max_places) << c.code;
    }
}

TEST(Import, PartsThatHangTogetherInAPointAreTold) {
    const auto beside = [](Vec3 low) { return import_obj(two(shapes::box(), shapes::box(low, low + Vec3{1, 1, 1}))); };
    const Result corner = beside({1, 1, 1});
    const Finding* pinched = find(corner.report.findings, "SHELL_PINCHED");
    ASSERT_NE(pinched, nullptr);
    EXPECT_EQ(pinched->count, 1u);
    EXPECT_EQ(pinched->places.at(0).position, (Vec3{1, 1, 1}));
    EXPECT_EQ(corner.asset.shell.positions[pinched->places[0].element], (Vec3{1, 1, 1}));
    EXPECT_FALSE(has(corner.report, "SHELL_NON_MANIFOLD"));
    const Result edge = beside({1, 1, 0});
    EXPECT_TRUE(has(edge.report, "SHELL_NON_MANIFOLD"));
    EXPECT_FALSE(has(edge.report, "SHELL_PINCHED")) << "an edge holds them together";
    EXPECT_FALSE(has(beside({2, 2, 2}).report, "SHELL_PINCHED"));
    EXPECT_FALSE(has(import_obj(shapes::without_triangle(shapes::box())).report, "SHELL_PINCHED"));
}

TEST(Import, ObjectsClosedByThemselvesMayTouchInAPoint) {
    const TempFolder folder;
    const Shell both = two(shapes::box(), shapes::box({1, 1, 1}, {2, 2, 2}));
    std::string text = "o first\n" + obj_text(both);
    const Triangle& first_of_second = both.triangles[both.triangles.size() / 2];
    text.insert(text.find("f " + std::to_string(first_of_second[0] + 1) + " " + std::to_string(first_of_second[1] + 1)),
                "o second\n");
    const Result result = import_shell(folder.write("two.obj", text));
    EXPECT_EQ(result.asset.shell.components.size(), 2u);
    EXPECT_FALSE(has(result.report, "SHELL_PINCHED"));
}

TEST(Import, NearlyEverythingPaintedIsReported) {
    const TempFolder folder;
    const Shell sphere = shapes::icosphere(1, 2);
    const auto all = import_shell(folder.write("all.obj", obj_text(sphere, [](std::size_t) { return 0.0; })));
    EXPECT_TRUE(has(all.report, "LOCK_NEARLY_ALL"));
    EXPECT_EQ(all.asset.locked_positions, test::sorted(sphere.positions));
    const auto half =
        import_shell(folder.write("half.obj", obj_text(sphere, [](std::size_t v) { return v % 2 ? 0.0 : 1.0; })));
    EXPECT_FALSE(has(half.report, "LOCK_NEARLY_ALL"));
    EXPECT_FALSE(has(half.report, "LOCK_NOTHING_PAINTED"));
    EXPECT_EQ(half.report.locked, sphere.positions.size() / 2);
}

TEST(Import, VisualMeshesKeepNamesOrderAndEveryVertex) {
    const TempFolder folder;
    const std::string shell = folder.write("shell.obj", obj_text(shapes::box()));
    const std::string list = "v 9 9 9\nv 0 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 4 5\n";
    Sources sources{shell,
                    {{"body", folder.write("a.obj", list)}, {"", folder.write("wheel.obj", obj_text(shapes::box()))}}};
    const Result result = import_asset(sources);
    ASSERT_EQ(result.asset.visuals.size(), 2u);
    EXPECT_EQ(result.asset.visuals[0].name, "body");
    EXPECT_EQ(result.asset.visuals[0].positions.size(), 5u);
    EXPECT_EQ(result.asset.visuals[0].positions[0], (Vec3{9, 9, 9}));
    EXPECT_EQ(result.asset.visuals[0].source_vertex, (std::vector<Index>{0, 1, 2, 3, 4}));
    EXPECT_EQ(result.asset.visuals[1].name, "wheel");
    EXPECT_EQ(result.report.visuals.at(1).vertices, 8u);
}

TEST(Import, UnitAndUpApplyToShellAndVisualsAlike) {
    const TempFolder folder;
    const std::string path = folder.write("box.obj", obj_text(shapes::box({0, 0, 0}, {1, 2, 3})));
    Params params;
    params.unit = 0.01;
    params.up = Up::z;
    const Result result = import_asset({path, {{"same", path}}}, params);
    EXPECT_EQ(test::sorted(result.asset.shell.positions), test::sorted(result.asset.visuals[0].positions));
    const std::vector<Vec3>& placed = result.asset.visuals[0].positions;
    EXPECT_NE(std::find(placed.begin(), placed.end(), round_to_float({0.01, 0.03, -0.02})), placed.end());
    EXPECT_GT(result.report.components.at(0).volume, 0);
    EXPECT_FALSE(result.report.components.at(0).is_inward);
}

TEST(Import, NamesOfVisualMeshesMustBeUsableAndUnique) {
    const TempFolder folder;
    const std::string path = folder.write("box.obj", obj_text(shapes::box()));
    const auto refusal = [&](const std::string& first, const std::string& second) {
        return test::refusal_of([&] { (void)import_asset({path, {{first, path}, {second, path}}}); });
    };
    EXPECT_EQ(refusal("a", "a").kind, ErrorKind::usage);
    EXPECT_EQ(refusal("", "box").kind, ErrorKind::usage);
    EXPECT_TRUE(contains(refusal("", "").message, "--visual NAME="));
    EXPECT_EQ(refusal("a/b", "c").kind, ErrorKind::usage);
    EXPECT_EQ(refusal("..", "c").kind, ErrorKind::usage);
    EXPECT_EQ(refusal("a\n", "c").kind, ErrorKind::usage);
    EXPECT_TRUE(refusal("a", "b").message.empty());
}

TEST(Import, ErrorsNameTheFileTheyAreAbout) {
    const TempFolder folder;
    const std::string shell = folder.write("shell.obj", obj_text(shapes::box()));
    const std::string broken = folder.write("broken.ply", "ply\n");
    const auto refusal = test::refusal_of([&] { (void)import_asset({shell, {{"", broken}}}); });
    EXPECT_TRUE(refusal.message.starts_with(broken)) << refusal.message;
    const std::string flat = folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_TRUE(refusal_of_file(flat).message.starts_with(flat));
}

TEST(Import, LimitsOfTheReaderBecomeRefusals) {
    const TempFolder folder;
    const std::string path = folder.write("ball.obj", obj_text(shapes::icosphere(1, 6)));
    Params params;
    params.time_s = 0.001;
    const auto late = refusal_of_file(path, params);
    EXPECT_EQ(late.kind, ErrorKind::bad_input);
    EXPECT_TRUE(contains(late.message, "import.time_s")) << late.message;
    params = {};
    params.memory_mb = 1;
    const auto large = refusal_of_file(path, params);
    EXPECT_EQ(large.kind, ErrorKind::bad_input);
}

TEST(Import, CancelledImportStops) {
    const TempFolder folder;
    const std::atomic<bool> cancelled = true;
    Context context;
    context.cancelled = &cancelled;
    const std::string path = folder.write("box.obj", obj_text(shapes::box()));
    EXPECT_EQ(test::refusal_of([&] { (void)import_asset({path, {}}, {}, context); }).kind, ErrorKind::budget);
}

TEST(Import, TwiceIsTheSame) {
    const TempFolder folder;
    const std::string path =
        folder.write("a.obj", obj_text(shapes::nested_boxes(), [](std::size_t v) { return v % 3 ? 1.0 : 0.0; }));
    const Result a = import_shell(path);
    const Result b = import_shell(path);
    EXPECT_EQ(a.asset.shell.positions, b.asset.shell.positions);
    EXPECT_EQ(a.asset.shell.triangles, b.asset.shell.triangles);
    EXPECT_EQ(a.asset.locked_positions, b.asset.locked_positions);
}

// Names every field a visitor is shown.
struct FieldNames {
    std::vector<std::string> names;
    template <class T>
    void field(const char* name, T&, const char*) {
        names.emplace_back(name);
    }
    template <class T>
    void field(const char* name, T&, Range, const char*) {
        names.emplace_back(name);
    }
};

TEST(Import, EveryFieldIsDescribed) {
    const auto names_of = [](auto value) {
        FieldNames visitor;
        describe(visitor, value);
        EXPECT_EQ(std::set<std::string>(visitor.names.begin(), visitor.names.end()).size(), visitor.names.size());
        return visitor.names.size();
    };
    EXPECT_EQ(names_of(Params{}), 12u);
    EXPECT_EQ(names_of(FileReport{}), 10u);
    EXPECT_EQ(names_of(ComponentReport{}), 9u);
    EXPECT_EQ(names_of(Report{}), 26u);
}

TEST(Import, ASizeThatNothingHasNamesTheUnitToTry) {
    const TempFolder folder;
    const auto finding_at = [&](double scale, double unit) {
        const std::string path =
            folder.write("shell.obj", obj_text(shapes::moved(shapes::box({0, 0, 0}, {4, 2, 2}), {0, 0, 0}, scale)));
        Params params;
        params.unit = unit;
        const Result result = import_shell(path, params);
        const Finding* finding = find(result.report.findings, "IMPORT_SIZE_UNUSUAL");
        return finding ? finding->message : std::string();
    };
    EXPECT_EQ(finding_at(1, 0), "");
    EXPECT_EQ(finding_at(100, 0.01), "");
    EXPECT_TRUE(contains(finding_at(100, 0), "489.9 m")) << finding_at(100, 0);
    EXPECT_TRUE(contains(finding_at(100, 0), "--unit 0.01 makes it 4.899 m"));
    EXPECT_TRUE(contains(finding_at(1000, 0), "--unit 0.001 makes it 4.899 m"));
    EXPECT_TRUE(contains(finding_at(1, 0.001), "--unit 1 makes it 4.899 m"));
}

}
}
