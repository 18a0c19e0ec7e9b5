// SPDX-License-Identifier: GPL-3.0-or-later
// One control shell, painted and written in many formats and ways, against the list of its locked vertices.
#include <limits>
#include <sstream>
#include <string>

#include "importer/import_checks.h"
#include "importer/temp_folder.h"
#include "mesh/shapes.h"

namespace crumple::importer {
namespace {

using test::find;
using test::has;
using test::import_shell;

constexpr std::size_t truth_count = 84;

std::string car_body(const std::string& name) {
    return (test::data_folder() / "locks" / "car_body" / ("car_body." + name)).string();
}

struct TruthVertex {
    float position[3];
    float rgba[4];
};

std::vector<TruthVertex> read_truth(const std::string& name) {
    std::ifstream file(test::data_folder() / "locks" / "car_body" / name, std::ios::binary);
    std::int32_t count = 0;
    file.read(reinterpret_cast<char*>(&count), sizeof count);
    std::vector<TruthVertex> vertices(static_cast<std::size_t>(count));
    file.read(reinterpret_cast<char*>(vertices.data()),
              static_cast<std::streamsize>(vertices.size() * sizeof(TruthVertex)));
    return vertices;
}

Vec3 position(const TruthVertex& v) { return {v.position[0], v.position[1], v.position[2]}; }

std::vector<Vec3> true_locks(const std::string& name = "truth.bin") {
    std::vector<Vec3> positions;
    for (const TruthVertex& v : read_truth(name)) {
        if (v.rgba[0] == 0) positions.push_back(position(v));
    }
    return test::sorted(positions);
}

// Both ways in which a result tells its locks agree.
std::vector<Vec3> locks_of(const Result& result) {
    std::vector<Vec3> positions;
    const Shell& shell = result.asset.shell;
    for (std::size_t v = 0; v < shell.positions.size(); ++v) {
        if (shell.locked[v]) positions.push_back(shell.positions[v]);
    }
    positions = test::sorted(positions);
    EXPECT_EQ(positions, result.asset.locked_positions);
    EXPECT_EQ(result.report.locked, positions.size());
    return positions;
}

double largest_distance(const std::vector<Vec3>& a, std::vector<Vec3> b) {
    if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (const Vec3& p : a) {
        const auto nearest = std::min_element(
            b.begin(), b.end(), [&](const Vec3& l, const Vec3& r) { return length(l - p) < length(r - p); });
        largest = std::max(largest, length(*nearest - p));
        b.erase(nearest);
    }
    return largest;
}

double volume_of(const Shell& shell) {
    double volume = 0;
    for (const Triangle& t : shell.triangles) {
        volume += dot(shell.positions[t[0]], cross(shell.positions[t[1]], shell.positions[t[2]])) / 6;
    }
    return volume;
}

class LockFile : public testing::TestWithParam<const char*> {};

TEST_P(LockFile, GivesExactlyThePaintedPositions) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_shell(car_body(GetParam()));
    const auto truth = true_locks();
    ASSERT_EQ(truth.size(), truth_count);
    EXPECT_EQ(locks_of(result), truth);
    EXPECT_EQ(result.asset.shell.positions.size(), 315u);
    EXPECT_EQ(result.asset.shell.triangles.size(), 642u);
    EXPECT_EQ(result.report.open_edges, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Exact, LockFile,
    testing::Values("ascii_rgb_u8.ply", "ascii_rgba_u8.ply", "ascii_rgb_f32.ply", "bin_rgba_u8.ply", "be_rgba_u8.ply",
                    "bin_rgba_u16.ply", "bin_rgba_f32.ply", "bin_posf64_rgba_u8.ply", "float.obj", "3dec.obj",
                    "int255.obj", "rgb_u8n.glb", "rgba_u8n.glb", "rgba_u16n.glb", "rgba_f32.glb", "flat_rgba_u8n.glb",
                    "twoprims_u8n.glb", "hand.dae", "viaassimp.x", "coff_float.off", "coff_int.off",
                    // beyond the required ones
                    "bin_posf64_rgb_f64.ply", "rgb_f32.glb", "rgb_u16n.glb", "rgba_u8_noflag.glb", "rgba_f32.gltf",
                    "viaassimp.dae", "viaassimp.glb", "viaassimp.obj", "viaassimp.ply"),
    [](const auto& parameter) {
        std::string name = parameter.param;
        std::replace(name.begin(), name.end(), '.', '_');
        return name;
    });

TEST(Locks, AsciiFbxInCentimetresIsExact) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_shell(car_body("viaassimp.fbxa.fbx"));
    EXPECT_EQ(result.report.shell.unit, 0.01);
    auto truth = true_locks();
    for (Vec3& p : truth) p = round_to_float(p * 0.01);
    EXPECT_EQ(locks_of(result), test::sorted(truth));
}

TEST(Locks, UnitAppliesToWhatTheFileSaysOtherwise) {
    CRUMPLE_NEEDS_DATA();
    Params params;
    params.unit = 1;
    EXPECT_EQ(locks_of(import_shell(car_body("viaassimp.fbxa.fbx"), params)), true_locks());
    params.unit = 0.01;
    auto truth = true_locks();
    for (Vec3& p : truth) p = round_to_float(p * 0.01);
    EXPECT_EQ(locks_of(import_shell(car_body("rgba_u8n.glb"), params)), test::sorted(truth));
}

TEST(Locks, SourceVertexNamesTheVertexOfTheFile) {
    CRUMPLE_NEEDS_DATA();
    const auto truth = read_truth("truth.bin");
    for (const char* name : {"float.obj", "bin_rgba_u8.ply", "rgba_u8n.glb", "coff_int.off"}) {
        const Shell shell = import_shell(car_body(name)).asset.shell;
        ASSERT_EQ(shell.positions.size(), truth.size());
        for (Index v = 0; v < truth.size(); ++v) {
            EXPECT_EQ(shell.source_vertex[v], v) << name;
            EXPECT_EQ(shell.positions[v], position(truth[v])) << name << " vertex " << v;
        }
    }
}

TEST(Locks, ColoursComeThroughAsPainted) {
    CRUMPLE_NEEDS_DATA();
    const auto truth = read_truth("truth.bin");
    for (const char* name : {"int255.obj", "coff_int.off", "be_rgba_u8.ply", "rgba_f32.glb"}) {
        const Shell shell = import_shell(car_body(name)).asset.shell;
        ASSERT_EQ(shell.color.size(), truth.size());
        for (std::size_t v = 0; v < truth.size(); ++v) {
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(shell.color[v][c], truth[v].rgba[c], 1e-6) << name << " vertex " << v;
        }
    }
}

TEST(Locks, OddRedsLockOnlyWhenFiniteAndBelowTheThreshold) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_shell(car_body("weirdred_f32.ply"));
    const auto truth = read_truth("truth.bin");
    auto wanted = true_locks();
    for (const std::size_t v : {0, 1, 2, 3, 7}) wanted.push_back(position(truth[v]));
    wanted = test::sorted(wanted);
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    EXPECT_EQ(locks_of(result), wanted);
    EXPECT_TRUE(has(result.report, "COLOR_NOT_FINITE"));
    EXPECT_EQ(find(result.report.findings, "LOCK_NEARLY_ZERO")->count, 4u);  // 1e-9, 1e-4, 0.0019, -1
}

TEST(Locks, InstancesAreLockedEachInItsPlace) {
    CRUMPLE_NEEDS_DATA();
    EXPECT_EQ(locks_of(import_shell(car_body("instanced2_u8n.glb"))), true_locks("truth_instanced2.bin"));
}

// Ways to write the same painted box that other readers stumble over.
TEST(Locks, AnObjIsWhatItsNumbersSayHoweverTheyAreWritten) {
    const auto painted = [](const std::string& vertex_line, const std::string& extra) {
        const test::TempFolder folder;
        std::string text;
        std::size_t v = 0;
        for (const Vec3& p : shapes::box().positions) {
            std::ostringstream line;
            line << "v " << p.x << ' ' << p.y << ' ' << p.z << (v % 2 == 0 ? " 0 1 1" : " 0.5 0.5 0.5");
            text += v++ == 4 ? vertex_line : line.str() + "\n";
        }
        text += "v 9 9 9 1 1 1\n" + extra;  // unused: corners could move on without leaving the list
        for (const Triangle& t : shapes::box().triangles)
            text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) +
                    "\n";
        return import_shell(folder.write("box.obj", text));
    };
    const Vec3 at = shapes::box().positions[4];
    std::ostringstream place;
    place << at.x << ' ' << at.y << ' ' << at.z;
    const Result plain = painted("v " + place.str() + " 0 1 1\n", "");
    ASSERT_EQ(plain.report.locked, 4u);
    const auto expected = locks_of(plain);
    for (const std::string& line :
         {"  v " + place.str() + " 0 1 1\n", "v " + place.str() + " .0 1. 1 # 5\n",
          "\tv  " + place.str() + " +0 .5 .5\n", "# C:\\dir\\\nv " + place.str() + " 0e0 1 1\n"}) {
        const Result result = painted(line, "l 1 2 3 4 5 6\np 1 2\n");
        EXPECT_EQ(locks_of(result), expected) << line;
        EXPECT_EQ(result.asset.shell.positions, plain.asset.shell.positions) << line;
        EXPECT_EQ(result.report.shell.points_and_lines, 7u);
    }
    EXPECT_EQ(painted("v " + place.str() + " .5 .5 .5\n", "").report.locked, 3u);
}

TEST(Locks, TinyShellLosesNothing) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_shell(car_body("tiny1e-6_rgba_u8.ply"));
    EXPECT_EQ(locks_of(result), true_locks("truth_tiny.bin"));
    EXPECT_EQ(result.asset.shell.positions.size(), 315u);
}

TEST(Locks, MirroredNodeKeepsLocksAndIsRightSideOut) {
    CRUMPLE_NEEDS_DATA();
    for (const char* name : {"mirrored_u8n.glb", "nodexform_u8n.glb"}) {
        const Result result = import_shell(car_body(name));
        EXPECT_LT(largest_distance(locks_of(result), true_locks()), 1e-5) << name;
        EXPECT_GT(volume_of(result.asset.shell), 3.3) << name;
        EXPECT_EQ(result.report.components[0].role, Role::solid) << name;
        EXPECT_FALSE(result.report.components[0].is_inward) << name;
        EXPECT_EQ(result.report.components[1].role, Role::cavity) << name;
    }
}

// The numbers of a list in a side file.
std::vector<Index> list_in(const std::string& path, const std::string& key) {
    std::ifstream file(path);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    const std::size_t begin = text.find('[', text.find('"' + key + '"'));
    std::string list = text.substr(begin + 1, text.find(']', begin) - begin - 1);
    std::replace(list.begin(), list.end(), ',', ' ');
    std::istringstream numbers(list);
    std::vector<Index> result;
    for (Index number = 0; numbers >> number;) result.push_back(number);
    return result;
}

// The side files list the vertices of which one copy is painted locked and another free.
std::vector<Vec3> conflicting_positions(const std::string& side_file) {
    const auto truth = read_truth("truth.bin");
    std::vector<Vec3> positions;
    for (const Index v : list_in(car_body(side_file), "conflicting_vertex_indices"))
        positions.push_back(position(truth[v]));
    return positions;
}

void expect_conflicts(const std::string& name, const std::string& side_file, std::size_t count) {
    const Result result = import_shell(car_body(name));
    EXPECT_EQ(locks_of(result), true_locks()) << name;
    const auto wanted = conflicting_positions(side_file);
    ASSERT_EQ(wanted.size(), count);
    const Finding* conflict = find(result.report.findings, "LOCK_CONFLICT");
    ASSERT_NE(conflict, nullptr) << name;
    EXPECT_EQ(conflict->count, count) << name;
    EXPECT_EQ(result.report.lock_conflicts, count) << name;
    EXPECT_FALSE(conflict->places.empty());
    for (const Place& place : conflict->places) {
        EXPECT_NE(std::find(wanted.begin(), wanted.end(), place.position), wanted.end()) << name;
    }
}

TEST(Locks, CopiesThatDisagreeLockAndAreReported) {
    CRUMPLE_NEEDS_DATA();
    expect_conflicts("seamconflict_u8n.glb", "seamconflict.json", 7);
    expect_conflicts("cornerconflict_firstunlocked_u8n.glb", "cornerconflict.json", 20);
    expect_conflicts("cornerconflict_lastunlocked_u8n.glb", "cornerconflict.json", 20);
}

TEST(Locks, StrictMakesADisagreementAnError) {
    CRUMPLE_NEEDS_DATA();
    Params params;
    params.strict = true;
    const auto refusal = test::refusal_of_file(car_body("seamconflict_u8n.glb"), params);
    EXPECT_EQ(refusal.kind, ErrorKind::bad_input);
    EXPECT_TRUE(test::contains(refusal.message, "LOCK_CONFLICT")) << refusal.message;
    EXPECT_EQ(locks_of(import_shell(car_body("twoprims_u8n.glb"), params)), true_locks());
}

TEST(Locks, NearDuplicatesAreWeldedWhereEdgesStayOpen) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_shell(car_body("nearduplicates5um_rgba_u8.ply"));
    EXPECT_EQ(locks_of(result), true_locks());
    EXPECT_EQ(result.asset.shell.positions.size(), 315u);
    EXPECT_EQ(result.report.open_edges, 0u);
    EXPECT_EQ(result.report.welded_by_tolerance, 20u);
    EXPECT_NEAR(result.report.weld_distance, 5e-6, 1e-7);
    EXPECT_EQ(result.report.lock_conflicts, 20u);  // the copies are painted 200
}

TEST(Locks, UncolouredMeshesLockNothingAndAreReported) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_shell(car_body("onlyhalfcoloured_u8n.glb"));
    const auto locks = locks_of(result);
    const auto truth = true_locks();
    EXPECT_EQ(locks.size(), 29u);  // of the 84, those on the coloured primitive
    EXPECT_TRUE(std::includes(truth.begin(), truth.end(), locks.begin(), locks.end(), test::lexicographic));
    EXPECT_TRUE(has(result.report, "COLOR_MISSING"));
    EXPECT_EQ(result.report.lock_conflicts, 0u);
}

TEST(Locks, SecondColourSetIsNamedAndCanBeChosen) {
    CRUMPLE_NEEDS_DATA();
    const std::string path = car_body("color1_only_u8n.glb");
    const Result first = import_shell(path);
    EXPECT_TRUE(locks_of(first).empty());
    EXPECT_TRUE(has(first.report, "LOCK_NOTHING_PAINTED"));
    const Finding* other = find(first.report.findings, "COLOR_SET_UNUSED");
    ASSERT_NE(other, nullptr);
    EXPECT_TRUE(test::contains(other->message, "COLOR_1")) << other->message;
    EXPECT_TRUE(test::contains(other->message, "--color-set 1")) << other->message;
    Params params;
    params.color_set = 1;
    const Result second = import_shell(path, params);
    EXPECT_EQ(locks_of(second), true_locks());
    EXPECT_FALSE(has(second.report, "COLOR_SET_UNUSED"));
    params.color_set = 7;
    const auto third = test::refusal_of_file(path, params);
    EXPECT_EQ(third.kind, ErrorKind::usage);
    EXPECT_TRUE(test::contains(third.message, "no colour set 7; the file has set 0, 1")) << third.message;
}

TEST(Locks, StlLocksNothingAndSaysSo) {
    CRUMPLE_NEEDS_DATA();
    const Result result = import_shell(car_body("viaassimp.stl"));
    EXPECT_TRUE(locks_of(result).empty());
    EXPECT_TRUE(result.asset.shell.color.empty());
    EXPECT_TRUE(has(result.report, "LOCK_NOTHING_PAINTED"));
}

TEST(Locks, TwoDecimalsLockWhatTheFileSays) {
    CRUMPLE_NEEDS_DATA();
    EXPECT_EQ(locks_of(import_shell(car_body("2dec.obj"))).size(), 109u);
}

TEST(Locks, FarFromTheOriginIsReported) {
    CRUMPLE_NEEDS_DATA();
    EXPECT_TRUE(has(import_shell(car_body("far1e6_posf64_rgba_u8.ply")).report, "SHELL_FAR_FROM_ORIGIN"));
    EXPECT_FALSE(has(import_shell(car_body("rgba_u8n.glb")).report, "SHELL_FAR_FROM_ORIGIN"));
}

TEST(Locks, MixedVertexLinesAreRefusedByLine) {
    CRUMPLE_NEEDS_DATA();
    const std::pair<const char*, const char*> cases[] = {
        {"partial.obj", "line 6"}, {"partial_unlocked.obj", "line 6"}, {"rgba.obj", "line 2"}};
    for (const auto& [name, line] : cases) {
        const auto refusal = test::refusal_of_file(car_body(name));
        EXPECT_EQ(refusal.kind, ErrorKind::bad_input) << name;
        EXPECT_TRUE(test::contains(refusal.message, line)) << refusal.message;
        EXPECT_TRUE(refusal.message.starts_with(car_body(name))) << refusal.message;
    }
}

TEST(Locks, BrokenAndUnreadFormatsAreRefusedClearly) {
    CRUMPLE_NEEDS_DATA();
    for (const char* name : {"viaassimp.fbx", "viaassimp.plyb.ply", "viaassimp.3mf", "viaassimp.x3d",
                             "viaassimp.assbin", "viaassimp.glb1.gltf"}) {
        const auto refusal = test::refusal_of_file(car_body(name));
        EXPECT_EQ(refusal.kind, ErrorKind::bad_input) << name;
        EXPECT_GT(refusal.message.size(), car_body(name).size() + 20) << refusal.message;
    }
    EXPECT_TRUE(test::contains(test::refusal_of_file(car_body("viaassimp.3mf")).message, ".obj, .ply"));
}

TEST(Locks, AnotherPaintedShellGivesItsOwnList) {
    CRUMPLE_NEEDS_DATA();
    const std::string open = (test::data_folder() / "open").string();
    const Result spot = import_shell(open + "/spot_shell_painted.ply");
    std::vector<Index> locked;
    for (std::size_t v = 0; v < spot.asset.shell.locked.size(); ++v) {
        if (spot.asset.shell.locked[v]) locked.push_back(spot.asset.shell.source_vertex[v]);
    }
    EXPECT_EQ(locked, list_in(open + "/spot_shell_painted.locks.json", "locked_indices"));
    EXPECT_EQ(locked.size(), 90u);
}

TEST(Locks, APaintedVertexThatNoFaceUsesIsReported) {
    const test::TempFolder folder;
    const std::string text =
        "v 0 0 0 1 1 1\nv 1 0 0 0 1 1\nv 0 1 0 1 1 1\nv 0 0 1 1 1 1\nv 5 6 7 0 1 1\nv 8 8 8 1 1 1\n"
        "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    const Result result = import_shell(folder.write("a.obj", text));
    EXPECT_EQ(result.report.unused_vertices, 2u);
    const Finding* unused = find(result.report.findings, "LOCK_UNUSED");
    ASSERT_NE(unused, nullptr);
    EXPECT_EQ(unused->count, 1u);
    EXPECT_EQ(unused->places.front().position, (Vec3{5, 6, 7}));
    EXPECT_EQ(unused->places.front().element, 4u);
}

}
}
