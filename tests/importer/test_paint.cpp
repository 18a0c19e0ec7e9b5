// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/paint.h"

#include <cmath>
#include <limits>

#include "importer/import_checks.h"
#include "importer/make_surface.h"

namespace crumple::importer {
namespace {

using test::find;

const formats::Format& format_named(const char* path) { return formats::format_of(path); }

// One vertex a colour.
Surface painted_surface(const std::vector<Color>& colors) {
    Surface surface = test::surface_of(std::vector<Vec3>(colors.size()), {});
    surface.colors = colors;
    surface.parts[0].has_color = true;
    return surface;
}

std::vector<Paint> paint_of(Surface surface, const char* path = "a.ply") {
    return read_paint(Scene{}, format_named(path), {}, surface).paint;
}

Color red(float value) { return {value, 1, 1, 1}; }

TEST(Paint, WithoutColoursNothingIsSaid) {
    Surface surface = test::surface_of(std::vector<Vec3>(2), {});
    surface.colors.assign(2, red(1));
    const auto painted = read_paint(Scene{}, format_named("a.ply"), {}, surface);
    EXPECT_EQ(painted.paint, (std::vector<Paint>{Paint::none, Paint::none}));
    EXPECT_TRUE(surface.colors.empty());
    EXPECT_EQ(painted.locked_count, 0u);
}

TEST(Paint, ThresholdIsHalfAnEightBitStep) {
    const float below = std::nextafter(formats::locked_below, 0.0f);
    const auto paint = paint_of(
        painted_surface({red(0), red(-0.0f), red(below), red(formats::locked_below), red(1.0f / 255), red(1.0f / 65535)}));
    EXPECT_EQ(paint, (std::vector<Paint>{Paint::locked, Paint::locked, Paint::locked, Paint::free, Paint::free,
                                         Paint::locked}));
}

TEST(Paint, RedThatIsNoNumberLocksNothing) {
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(paint_of(painted_surface({red(std::nanf("")), red(inf), red(-inf), red(-1)})),
              (std::vector<Paint>{Paint::free, Paint::free, Paint::free, Paint::locked}));
}

TEST(Paint, WholeNumbersUpTo255AreBytesWhereTheFormatMayHoldThem) {
    const std::vector<Color> bytes = {{1, 255, 0, 1}, {0, 7, 3, 1}, {254, 1, 2, 255}};
    EXPECT_EQ(paint_of(painted_surface(bytes), "a.obj"), (std::vector<Paint>{Paint::free, Paint::locked, Paint::free}));
    Surface surface = painted_surface(bytes);
    (void)read_paint(Scene{}, format_named("a.off"), {}, surface);
    EXPECT_EQ(surface.colors[0], (Color{1.0f / 255, 1, 0, 1}));
    EXPECT_EQ(surface.colors[2][3], 1);
    Surface ply = painted_surface(bytes);
    (void)read_paint(Scene{}, format_named("a.ply"), {}, ply);
    EXPECT_EQ(ply.colors[0], bytes[0]);
}

// Scaled by 255, a red of 0.4 would lock.
TEST(Paint, HighDynamicRangeIsNotBytes) {
    EXPECT_EQ(paint_of(painted_surface({{0.4f, 1.5f, 0, 1}, {3, 0, 0, 1}}), "a.obj"),
              (std::vector<Paint>{Paint::free, Paint::free}));
    EXPECT_EQ(paint_of(painted_surface({{1, 300, 0, 1}}), "a.obj"), (std::vector<Paint>{Paint::free}));
}

TEST(Paint, ZerosAndOnesMeanTheSameEitherWay) {
    EXPECT_EQ(paint_of(painted_surface({red(0), red(1)}), "a.obj"), (std::vector<Paint>{Paint::locked, Paint::free}));
}

TEST(Paint, LocksAreJudgedOnStoredValuesInEitherColourSpace) {
    Params params;
    params.color_space = ColorSpace::srgb;
    Surface surface = painted_surface({{1.0f / 255, 0.5f, 1, 0.5f}, {0, 0, 0, 1}});
    const auto painted = read_paint(Scene{}, format_named("a.ply"), params, surface);
    EXPECT_EQ(painted.paint, (std::vector<Paint>{Paint::free, Paint::locked}));
    EXPECT_NEAR(surface.colors[0][0], 1.0 / 255 / 12.92, 1e-9);
    EXPECT_NEAR(surface.colors[0][1], 0.21404114, 1e-6);
    EXPECT_EQ(surface.colors[0][2], 1);
    EXPECT_EQ(surface.colors[0][3], 0.5f);
}

// OBJ makes a copy for each corner, and an instance for each node.
TEST(Paint, CopiesOfAVertexCountOnce) {
    Surface surface = painted_surface({red(0.0015f), red(0.0015f), red(0), red(0), red(NAN), red(NAN), red(1)});
    surface.source_vertex = {0, 0, 1, 1, 2, 2, 3};
    surface.source_vertex_count = 4;
    const auto painted = read_paint(Scene{}, format_named("a.obj"), {}, surface);
    EXPECT_EQ(find(painted.findings, "LOCK_NEARLY_ZERO")->count, 1u);
    EXPECT_EQ(find(painted.findings, "COLOR_NOT_FINITE")->count, 1u);
    EXPECT_EQ(painted.locked_count, 2u);
}

TEST(Paint, NearlyZeroRedsAreReported) {
    Surface surface = painted_surface({red(0.0015f), red(0), red(1)});
    const auto painted = read_paint(Scene{}, format_named("a.glb"), {}, surface);
    EXPECT_EQ(find(painted.findings, "LOCK_NEARLY_ZERO")->count, 1u);
    EXPECT_EQ(find(painted.findings, "LOCK_NEARLY_ZERO")->places.at(0).element, 0u);
}

}
}
