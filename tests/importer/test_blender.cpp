// SPDX-License-Identifier: GPL-3.0-or-later
// Shells painted and exported by Blender 3.4 (fixtures/make_blender_fixtures.py), against the truth the script wrote.
#include <cmath>
#include <sstream>

#include "core/random.h"
#include "importer/import_checks.h"
#include "importer/temp_folder.h"

namespace crumple::importer {
namespace {

using test::find;
using test::has;
using test::import_shell;

std::string fixture(const std::string& name) { return CRUMPLE_FIXTURES "/" + name; }

std::vector<double> numbers_of(const std::string& text, const std::string& key, const std::string& end) {
    const std::size_t begin = text.find('[', text.find('"' + key + '"'));
    std::string list = text.substr(begin, text.find(end, begin) - begin);
    for (char& c : list) c = c == '[' || c == ']' || c == ',' ? ' ' : c;
    std::istringstream stream(list);
    std::vector<double> numbers;
    for (double number = 0; stream >> number;) numbers.push_back(number);
    return numbers;
}

struct Truth {
    std::vector<Vec3> positions;
    std::vector<std::uint8_t> locked;
};

Truth read_truth() {
    std::ifstream file(fixture("blender.locks.json"));
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    const auto numbers = numbers_of(text, "positions", "]]");
    Truth truth;
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        truth.positions.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    truth.locked.assign(truth.positions.size(), 0);
    for (const double v : numbers_of(text, "locked", "]")) truth.locked.at(static_cast<std::size_t>(v)) = 1;
    return truth;
}

// The shell's vertices are the truth's, each within `tolerance`, and so are the locks; all faces look outwards.
void expect_truth(const Result& result, double tolerance) {
    const Truth truth = read_truth();
    const Shell& shell = result.asset.shell;
    ASSERT_EQ(truth.positions.size(), 42u);
    ASSERT_EQ(shell.positions.size(), truth.positions.size());
    std::vector<bool> taken(truth.positions.size(), false);
    for (std::size_t v = 0; v < shell.positions.size(); ++v) {
        const auto distance = [&](const Vec3& p) { return length(p - shell.positions[v]); };
        const auto nearest = std::min_element(truth.positions.begin(), truth.positions.end(),
                                              [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
        const auto i = static_cast<std::size_t>(nearest - truth.positions.begin());
        EXPECT_LE(distance(*nearest), tolerance);
        EXPECT_FALSE(taken[i]);
        taken[i] = true;
        EXPECT_EQ(shell.locked[v], truth.locked[i]) << "vertex " << i;
    }
    EXPECT_EQ(result.report.locked, 15u);
    ASSERT_EQ(result.report.components.size(), 1u);
    EXPECT_TRUE(result.report.components[0].is_closed);
    EXPECT_FALSE(result.report.components[0].is_inward);
    EXPECT_NEAR(result.report.components[0].volume, 2.058, 0.001);
}

TEST(Blender, GlbOfTheVertexDomainIsExact) {
    expect_truth(import_shell(fixture("blender.byte_point.glb")), 0);
    expect_truth(import_shell(fixture("blender.float_point.glb")), 0);
}

// Its exporter reads corner colours by vertex number: the file itself is wrong, so all one can do is to say so.
TEST(Blender, GlbOfTheCornerDomainIsWarnedOf) {
    for (const char* name : {"blender.byte_corner.glb", "blender.float_corner.glb"}) {
        const Report report = import_shell(fixture(name)).report;
        EXPECT_NE(report.locked, 15u) << name;
        const Finding* finding = find(report.findings, "COLOR_MAYBE_SCRAMBLED");
        ASSERT_NE(finding, nullptr) << name;
        EXPECT_TRUE(test::contains(finding->message, "Face Corner"));
        EXPECT_TRUE(test::contains(report.shell.generator, "Blender"));
    }
}

TEST(Blender, FbxInCentimetresAndTurnedByItsNodeIsRight) {
    for (const char* name : {"byte_corner", "byte_point", "float_corner", "float_point"}) {
        const Result result = import_shell(fixture(std::string("blender.") + name + ".fbx"));
        expect_truth(result, 1e-6);  // its rotation of 90 degrees is a product of floats
        EXPECT_EQ(result.report.shell.unit, 0.01);
        EXPECT_EQ(result.report.components.at(0).name, "blob");
    }
}

TEST(Blender, FilesWithZUpAreTurned) {
    const Result collada = import_shell(fixture("blender.z_up.dae"));
    expect_truth(collada, 1e-6);
    EXPECT_EQ(collada.report.shell.up, "z");
    EXPECT_EQ(collada.report.shell.unit, 1);
    Params params;
    params.unit = 0.1;  // exported at a tenth of its size, and FBX would say centimetres
    const Result fbx = import_shell(fixture("blender.z_up.fbx"), params);
    expect_truth(fbx, 1e-6);
    EXPECT_EQ(fbx.report.shell.up, "z");
}

// Bytes changed, cut out and repeated at random places: read or refused, never worse.
TEST(Blender, DamagedExportsAreReadOrRefused) {
    const test::TempFolder folder;
    for (const char* name : {"blender.byte_point.glb", "blender.byte_point.fbx", "blender.z_up.dae"}) {
        std::ifstream file(fixture(name), std::ios::binary);
        const std::string good((std::istreambuf_iterator<char>(file)), {});
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            Rng rng(seed);
            std::string bytes = good;
            for (std::uint32_t changes = 1 + rng.next_below(6); changes > 0; --changes) {
                const std::size_t at = rng.next_below(static_cast<std::uint32_t>(bytes.size()));
                const std::uint32_t kind = rng.next_below(3);
                const std::size_t length = rng.next_below(64);
                if (kind == 0) bytes[at] = static_cast<char>(rng.next_below(256));
                if (kind == 1) bytes.erase(at, length);
                if (kind == 2) bytes.insert(at, bytes.substr(at, length));
            }
            const std::string path =
                folder.write("damaged" + std::string(name).substr(std::string(name).size() - 4), bytes);
            const auto refusal = test::refusal_of_file(path);
            EXPECT_TRUE(refusal.message.empty() || refusal.kind == ErrorKind::bad_input)
                << name << " seed " << seed << ": " << refusal.message;
        }
    }
}

TEST(Blender, ObjIsExactToItsSixDecimals) {
    for (const char* name : {"byte_corner", "byte_point", "float_corner", "float_point"}) {
        expect_truth(import_shell(fixture(std::string("blender.") + name + ".obj")), 1e-6);
    }
}

TEST(Blender, PlyOfByteCornersIsExact) { expect_truth(import_shell(fixture("blender.byte_corner.ply")), 0); }

// Its PLY exporter leaves every other kind of colour attribute out.
TEST(Blender, PlyWithoutItsColoursSaysThatNothingIsLocked) {
    for (const char* name : {"byte_point", "float_corner", "float_point"}) {
        const Report report = import_shell(fixture(std::string("blender.") + name + ".ply")).report;
        EXPECT_TRUE(has(report, "LOCK_NOTHING_PAINTED")) << name;
    }
}

}
}
