// SPDX-License-Identifier: GPL-3.0-or-later
// The policy on real shells, where the shared data is there.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/random.h"
#include "dirty/dirty_shell.h"
#include "shared_data.h"

namespace crumple {
namespace {

using test::cook_text;
using test::Cooked;
using test::fault_of;

std::filesystem::path quality_folder() { return test::data_folder() / "quality"; }

std::string text_of(const std::string& name) {
    std::ifstream file(quality_folder() / name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// The same file with a share of its triangles facing the other way.
std::string flipped(const std::string& text, double share) {
    std::istringstream lines(text);
    std::ostringstream result;
    Rng random(3, 0);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string keyword, a, b, c;
        words >> keyword >> a >> b >> c;
        const bool is_turned = keyword == "f" && random.next_unit() < share;
        result << (is_turned ? "f " + a + " " + c + " " + b : line) << '\n';
    }
    return result.str();
}

class DirtyAssets : public testing::Test {
protected:
    void SetUp() override { CRUMPLE_NEEDS_DATA(); }
};

TEST_F(DirtyAssets, AThirdOfSpotsFacesFlippedGivesTheMeshOfSpot) {
    const Cooked clean = cook_text(text_of("spot.obj"));
    const Cooked cooked = cook_text(flipped(text_of("spot.obj"), 0.3));
    ASSERT_EQ(cooked.refusal, "");
    EXPECT_GT(cooked.import.flipped_triangles, 400u);
    EXPECT_TRUE(cooked.warns("SHELL_INCONSISTENT"));
    EXPECT_EQ(cooked.mesh.positions, clean.mesh.positions);
    EXPECT_EQ(cooked.mesh.tets, clean.mesh.tets);
    EXPECT_EQ(fault_of(cooked), "");
}

TEST_F(DirtyAssets, WithAHoleSpotIsStillSpot) {
    const std::string text = text_of("spot.obj");
    const std::size_t first_face = text.find("\nf ") + 1;
    const std::size_t second_face = text.find('\n', first_face) + 1;
    const Cooked cooked = cook_text(text.substr(0, first_face) + text.substr(second_face));
    ASSERT_EQ(cooked.refusal, "");
    EXPECT_TRUE(cooked.warns("SHELL_HOLES"));
    EXPECT_NEAR(cooked.cull.volume / cook_text(text).cull.volume, 1, 0.01);
    EXPECT_EQ(fault_of(cooked), "");
}

TEST_F(DirtyAssets, EachIsAcceptedWithTheWarningsItDeserves) {
    const struct {
        const char* name;
        std::vector<const char*> warnings;
        std::vector<const char*> information;
    } shells[] = {{"cow.obj", {"SHELL_SELF_INTERSECTING"}, {}},
                  {"suzanne.obj", {"SHELL_OPEN", "SHELL_HOLES", "SHELL_NON_MANIFOLD", "SHELL_SELF_INTERSECTING"}, {}},
                  {"boxnest.obj", {}, {"SHELL_NESTED"}},
                  {"carbody.obj", {"SAMPLE_THIN"}, {"SHELL_NESTED"}},
                  {"fandisk.obj", {"SHELL_NEEDLE"}, {}},
                  {"bonnet.obj", {}, {"SAMPLE_THIN", "SAMPLE_NO_INTERIOR"}},
                  {"carhood.obj", {}, {"SAMPLE_THIN", "SAMPLE_NO_INTERIOR"}}};
    for (const auto& shell : shells) {
        SCOPED_TRACE(shell.name);
        const Cooked cooked = cook_text(text_of(shell.name));
        ASSERT_EQ(cooked.refusal, "");
        EXPECT_EQ(fault_of(cooked), "");
        for (const char* code : shell.warnings) EXPECT_TRUE(cooked.warns(code)) << code;
        for (const char* code : shell.information) EXPECT_TRUE(cooked.informs(code)) << code;
    }
}

}
}
