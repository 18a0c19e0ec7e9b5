// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of flawed shell: what is accepted with which warning, what is refused with which advice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "dirty/dirty_shell.h"
#include "geometry/measures.h"
#include "importer/judge.h"
#include "mesh/shapes.h"

namespace crumple {
namespace {

using test::cook_shell;
using test::Cooked;
using test::fault_of;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Takes away the triangles whose middle lies within `radius` of a place: a round hole.
Shell with_hole(Shell shell, Vec3 place, double radius) {
    std::erase_if(shell.triangles, [&](const Triangle& t) {
        const Vec3 middle = (shell.positions[t[0]] + shell.positions[t[1]] + shell.positions[t[2]]) / 3.0;
        return length(middle - place) < radius;
    });
    shell.component.assign(shell.triangles.size(), 0);
    return shell;
}

double volume_of(const Cooked& cooked) { return cooked.cull.volume; }

TEST(Dirty, UnweldedDuplicatedAndDegenerateTrianglesAreMendedAndTold) {
    const Shell sphere = shapes::icosphere(1, 2);
    std::string text;  // every triangle with vertices of its own, moved by less than the weld tolerance
    std::size_t count = 0;
    Rng random(5, 0);
    for (const Triangle& t : sphere.triangles) {
        for (const Index v : t) {
            const Vec3 p = sphere.positions[v] * (1 + 1e-7 * random.next_unit());
            char line[96];
            std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", p.x, p.y, p.z);
            text += line;
        }
        count += 3;
        const std::string face =
            "f " + std::to_string(count - 2) + " " + std::to_string(count - 1) + " " + std::to_string(count) + "\n";
        text += count == 30 ? face + face : face;
    }
    text += "f 1 1 2\n";
    const Cooked cooked = test::cook_text(text);
    ASSERT_EQ(cooked.refusal, "");
    EXPECT_EQ(fault_of(cooked), "");
    EXPECT_EQ(cooked.asset.shell.positions.size(), sphere.positions.size());
    EXPECT_TRUE(cooked.informs("SHELL_DUPLICATE"));
    EXPECT_EQ(cooked.import.repeated_index_triangles, 1u);
    EXPECT_EQ(cooked.import.open_edges, 0u);
    EXPECT_GT(cooked.import.welded_by_tolerance + cooked.import.welded, 0u);
}

TEST(Dirty, AThirdOfTheFacesFlippedGivesTheMeshOfTheCleanShell) {
    const Shell clean = shapes::torus(1, 0.4, 24, 12);
    Shell flipped = clean;
    Rng random(7, 0);
    std::uint64_t turned = 0;
    for (Triangle& t : flipped.triangles) {
        if (random.next_unit() >= 0.3) continue;
        std::swap(t[1], t[2]);
        ++turned;
    }
    const Cooked expected = cook_shell(clean);
    const Cooked cooked = cook_shell(flipped);
    ASSERT_EQ(cooked.refusal, "");
    EXPECT_TRUE(cooked.warns("SHELL_INCONSISTENT"));
    EXPECT_EQ(cooked.import.flipped_triangles, turned);
    EXPECT_EQ(cooked.mesh.positions, expected.mesh.positions);
    EXPECT_EQ(cooked.mesh.tets, expected.mesh.tets);
    EXPECT_EQ(fault_of(cooked), "");
}

TEST(Dirty, NestedAndOverlappingShellsAreAUnionWithoutTheirCavities) {
    const Shell outer = shapes::subdivided_box(4, {0, 0, 0}, {4, 4, 4});
    const Shell inner = shapes::subdivided_box(2, {1, 1, 1}, {3, 3, 3});
    const Cooked block = cook_shell(shapes::joined(outer, inner));
    EXPECT_NEAR(volume_of(block), 64, 1e-9);
    EXPECT_TRUE(block.informs("SHELL_NESTED"));
    EXPECT_EQ(block.import.components.at(1).role, Role::solid);
    EXPECT_EQ(fault_of(block), "");
    const Cooked cabin = cook_shell(shapes::joined(outer, shapes::inverted(inner)));
    EXPECT_NEAR(volume_of(cabin), 56, 1e-9);
    EXPECT_EQ(cabin.import.components.at(1).role, Role::cavity);
    EXPECT_EQ(fault_of(cabin), "");
    const Cooked both = cook_shell(shapes::joined(outer, shapes::moved(outer, {2, 0.25, 0.25})));
    ASSERT_EQ(both.refusal, "");
    EXPECT_TRUE(both.warns("SHELL_OVERLAPPING"));
    EXPECT_NEAR(volume_of(both) / (128 - 2 * 3.75 * 3.75), 1, 0.05);
    EXPECT_EQ(fault_of(both), "");
}

// A sphere pulled through itself: closed, crossing, and still decided everywhere.
TEST(Dirty, ASelfIntersectingShellIsAcceptedWhenTheWindingNumberIsDecisive) {
    Shell shell = shapes::icosphere(1, 3);
    for (Vec3& p : shell.positions) {
        if (p.x > 0.6) p = round_to_float({1.2 - 2 * (p.x - 0.6), p.y, p.z});
    }
    const Cooked cooked = cook_shell(shell);
    ASSERT_EQ(cooked.refusal, "");
    EXPECT_EQ(fault_of(cooked), "");
    const Shell crossed = shapes::joined(shapes::icosphere(1, 2), shapes::icosphere(1, 2, {0.9, 0.05, 0.02}));
    Shell one = crossed;  // as one component: joined at a vertex
    for (Triangle& t : one.triangles) {
        for (Index& v : t) v = v == 162 ? 0 : v;
    }
    const Cooked joined = cook_shell(one);
    ASSERT_EQ(joined.refusal, "");
    EXPECT_TRUE(joined.warns("SHELL_SELF_INTERSECTING"));
    EXPECT_LT(joined.cull.leak_share, 0.02);
    EXPECT_EQ(fault_of(joined), "");
}

TEST(Dirty, ASmallHoleIsAcceptedWithAWarning) {
    const Shell sphere = shapes::icosphere(1, 3);
    const auto& [a, b, c] = sphere.triangles[100];
    const Vec3 place = (sphere.positions[a] + sphere.positions[b] + sphere.positions[c]) / 3.0;
    const Cooked cooked = cook_shell(with_hole(sphere, place, 0.01));
    ASSERT_EQ(cooked.refusal, "");
    EXPECT_EQ(fault_of(cooked), "");
    EXPECT_TRUE(cooked.warns("SHELL_OPEN"));
    ASSERT_TRUE(cooked.warns("SHELL_HOLES"));
    EXPECT_EQ(cooked.import.holes, 1u);
    EXPECT_LT(cooked.import.largest_hole, 0.1);
    EXPECT_LT(length(cooked.find("SHELL_HOLES")->places.front().position - place), 0.05);
    EXPECT_NEAR(volume_of(cooked), volume_of(cook_shell(sphere)), 0.01);
}

TEST(Dirty, ALargerHoleIsAcceptedWhileItHardlyLeaks) {
    const Cooked cooked = cook_shell(with_hole(shapes::icosphere(1, 3), {0, 0, 1}, 0.25));
    ASSERT_EQ(cooked.refusal, "");
    EXPECT_GT(cooked.import.largest_hole, 0.1);
    EXPECT_LT(cooked.import.leak_share, 0.02);
    EXPECT_TRUE(cooked.warns("SHELL_HOLES"));
    EXPECT_EQ(fault_of(cooked), "");
}

TEST(Dirty, BetweenHarmlessAndHopelessTheWarningNamesTheWaysOut) {
    const Cooked cooked = cook_shell(with_hole(shapes::icosphere(1, 3), {0, 0, 1}, 0.55));
    ASSERT_EQ(cooked.refusal, "");
    EXPECT_GT(cooked.import.leak_share, 0.02);
    ASSERT_TRUE(cooked.warns("SHELL_LEAKS"));
    EXPECT_TRUE(contains(cooked.find("SHELL_LEAKS")->message, "import.cage"));
    EXPECT_EQ(fault_of(cooked), "");
}

TEST(Dirty, AnOpenBowlIsRefusedWithWhatToTry) {
    const Cooked bowl = cook_shell(with_hole(shapes::icosphere(1, 3), {0, 0, 1}, 1.5));
    ASSERT_NE(bowl.refusal, "");
    for (const char* part : {"SHELL_LEAKS", "1 hole, ", "of the diagonal", "close it", "import.thicken", "import.cage"})
        EXPECT_TRUE(contains(bowl.refusal, part)) << bowl.refusal;
}

Shell sheet(int cells) {
    Shell shell;
    for (int x = 0; x <= cells; ++x) {
        for (int y = 0; y <= cells; ++y) {
            const double u = double(x) / cells;
            const double v = double(y) / cells;
            shell.positions.push_back(round_to_float({u, v, 0.2 * u * (1 - u)}));
        }
    }
    const auto number = [&](int x, int y) { return static_cast<Index>(x * (cells + 1) + y); };
    for (int x = 0; x < cells; ++x) {
        for (int y = 0; y < cells; ++y) {
            shell.triangles.push_back({number(x, y), number(x + 1, y), number(x + 1, y + 1)});
            shell.triangles.push_back({number(x, y), number(x + 1, y + 1), number(x, y + 1)});
        }
    }
    return shell;
}

TEST(Dirty, ASheetWithoutThicknessIsRefusedAndThickenedOnRequest) {
    const Cooked refused = cook_shell(sheet(6));
    EXPECT_TRUE(contains(refused.refusal, "import.thicken")) << refused.refusal;
    Shell plane = sheet(6);
    for (Vec3& p : plane.positions) p.z = 0;
    EXPECT_TRUE(contains(cook_shell(plane).refusal, "import.thicken"));
    importer::Params params;
    params.thicken = 0.05;
    for (const Shell& shell : {sheet(6), plane}) {
        const Cooked cooked = cook_shell(shell, params);
        ASSERT_EQ(cooked.refusal, "");
        EXPECT_TRUE(cooked.warns("SHELL_THICKENED"));
        EXPECT_EQ(fault_of(cooked), "");
        EXPECT_NEAR(volume_of(cooked), 0.05, 0.003);
    }
}

TEST(Dirty, NonManifoldEdgesAreAcceptedWhenBothSidesAreDecided) {
    const Shell boxes = shapes::joined(shapes::subdivided_box(3, {0, 0, 0}, {1, 1, 1}),
                                       shapes::subdivided_box(3, {1, 1, 0}, {2, 2, 1}));  // touch along an edge
    const Cooked cooked = cook_shell(boxes);
    ASSERT_EQ(cooked.refusal, "");
    EXPECT_TRUE(cooked.warns("SHELL_NON_MANIFOLD"));
    EXPECT_EQ(fault_of(cooked), "");
    EXPECT_NEAR(volume_of(cooked), 2, 1e-9);
    Shell walled = shapes::subdivided_box(4, {0, 0, 0}, {1, 1, 1});  // and one with an inner wall
    const auto at = [&](Vec3 p) {
        return static_cast<Index>(std::find(walled.positions.begin(), walled.positions.end(), p) -
                                  walled.positions.begin());
    };
    walled.triangles.push_back({at({0, 0, 0}), at({1, 0, 0.5}), at({0, 0.25, 0})});
    const Cooked with_wall = cook_shell(walled);
    ASSERT_EQ(with_wall.refusal, "");
    EXPECT_TRUE(with_wall.warns("SHELL_NON_MANIFOLD"));
    EXPECT_EQ(fault_of(with_wall), "");
}

TEST(Dirty, NeedlesAndTJunctionsAreListed) {
    Shell needle = shapes::box({0, 0, 0}, {100, 1, 1});
    const Cooked sharp = cook_shell(needle);
    ASSERT_EQ(sharp.refusal, "");
    ASSERT_TRUE(sharp.warns("SHELL_NEEDLE"));
    EXPECT_EQ(sharp.find("SHELL_NEEDLE")->count, 8u);
    EXPECT_EQ(fault_of(sharp), "");
    EXPECT_FALSE(cook_shell(shapes::box()).has("SHELL_NEEDLE"));
    // One of the two triangles at an edge is split there, the other is not.
    Shell split = shapes::box();
    const Triangle first = split.triangles[0];
    const Vec3 middle = (split.positions[first[0]] + split.positions[first[1]]) * 0.5;
    split.positions.push_back(middle);
    const Index m = 8;
    split.triangles[0] = {first[0], m, first[2]};
    split.triangles.push_back({m, first[1], first[2]});
    const Cooked cooked = cook_shell(split);
    ASSERT_TRUE(cooked.warns("SHELL_T_JUNCTION")) << cooked.refusal;
    EXPECT_EQ(cooked.find("SHELL_T_JUNCTION")->places.front().position, middle);
    EXPECT_EQ(fault_of(cooked), "");
}

// The same split closed by a triangle without area: it goes, and nothing is left to warn of.
TEST(Dirty, ATriangleWithoutAreaIsMergedIntoItsNeighbours) {
    Shell split = shapes::box();
    const Triangle first = split.triangles[0];
    split.positions.push_back((split.positions[first[0]] + split.positions[first[1]]) * 0.5);
    split.triangles[0] = {first[0], 8, first[2]};
    split.triangles.push_back({8, first[1], first[2]});
    split.triangles.push_back({first[0], first[1], 8});
    const Cooked cooked = cook_shell(split);
    ASSERT_EQ(cooked.refusal, "");
    EXPECT_TRUE(cooked.informs("SHELL_DEGENERATE"));
    EXPECT_FALSE(cooked.has("SHELL_T_JUNCTION") || cooked.has("SHELL_OPEN"));
    EXPECT_EQ(fault_of(cooked), "");
    EXPECT_NEAR(volume_of(cooked), 1, 1e-12);
}

TEST(Dirty, ThinPartsAreMeshedInOneLayerAndSaid) {
    const Cooked thin = cook_shell(shapes::thin_plate(0.02, 6));
    ASSERT_EQ(thin.refusal, "");
    ASSERT_TRUE(thin.informs("SAMPLE_THIN"));
    EXPECT_FALSE(thin.find("SAMPLE_THIN")->places.empty());
    EXPECT_NEAR(volume_of(thin), 0.02, 1e-6);
    EXPECT_EQ(fault_of(thin), "");
    const Cooked thinner = cook_shell(shapes::thin_plate(0.01, 6));  // a twentieth of the edges
    EXPECT_TRUE(thinner.warns("SAMPLE_THIN"));
    EXPECT_EQ(fault_of(thinner), "");
    EXPECT_FALSE(cook_shell(shapes::subdivided_box(4)).has("SAMPLE_THIN"));
}

TEST(Dirty, WhatCannotBeAShellIsRefused) {
    const auto refusal = [](const std::string& text) { return test::cook_text(text).refusal; };
    const std::string tet = "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";
    EXPECT_TRUE(contains(refusal("v nan 0 0\n" + tet), "not a number"));
    EXPECT_TRUE(contains(refusal("v inf 0 0\n" + tet), "not finite"));
    EXPECT_TRUE(contains(refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n"), "SHELL_FLAT"));
    EXPECT_TRUE(contains(refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n"), "SHELL_FLAT"));
    EXPECT_TRUE(contains(cook_shell(shapes::moved(shapes::box(), {3e6, 0, 0})).refusal, "SHELL_FAR_FROM_ORIGIN"));
    EXPECT_EQ(fault_of(cook_shell(shapes::moved(shapes::box(), {1e5, 0, 0}))), "");
}

TEST(Dirty, MoreThanAMillionTrianglesAreRefused) {
    EXPECT_NO_THROW(importer::check_triangle_count(1'000'000));
    EXPECT_THROW(importer::check_triangle_count(1'000'001), Error);
}

TEST(Dirty, AComponentThatGetsNoTetsIsNamed) {
    Shell shell = shapes::icosphere(1, 3);
    Shell scrap;  // a scrap of sheet beside it, small enough to be accepted
    scrap.positions = {{1.1, 0, 0}, {1.15, 0, 0}, {1.15, 0.05, 0}};
    scrap.triangles = {{0, 1, 2}};
    scrap.component = {0};
    scrap.locked = {0, 0, 0};
    scrap.source_vertex = {0, 1, 2};
    scrap.components.push_back({"scrap", "", Role::solid, "", 0, false, false, none});
    const Cooked cooked = cook_shell(shapes::joined(shell, scrap));
    ASSERT_EQ(cooked.refusal, "");
    ASSERT_TRUE(cooked.warns("CULL_COMPONENT_WITHOUT_TETS"));
    EXPECT_EQ(cooked.find("CULL_COMPONENT_WITHOUT_TETS")->count, 1u);
    EXPECT_EQ(fault_of(cooked), "");
}

}
}
