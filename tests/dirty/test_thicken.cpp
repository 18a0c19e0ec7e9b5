// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/thicken.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dirty/dirty_shell.h"
#include "geometry/measures.h"
#include "mesh/boundary.h"
#include "mesh/shapes.h"
#include "mesh/watertight.h"

namespace crumple {
namespace {

using test::cook_shell;
using test::Cooked;

importer::Params thickness(double t) {
    importer::Params params;
    params.thicken = t;
    return params;
}

double enclosed(const Shell& shell) {
    double sum = 0;
    for (const auto& [a, b, c] : shell.triangles)
        sum += signed_volume({0, 0, 0}, shell.positions[a], shell.positions[b], shell.positions[c]);
    return sum;
}

TEST(Thicken, LeavesClosedShellsAsTheyAre) {
    const Cooked plain = cook_shell(shapes::icosphere(1, 2));
    const Cooked asked = cook_shell(shapes::icosphere(1, 2), thickness(0.1));
    EXPECT_EQ(asked.asset.shell.positions, plain.asset.shell.positions);
    EXPECT_EQ(asked.asset.shell.triangles, plain.asset.shell.triangles);
    EXPECT_FALSE(asked.has("SHELL_THICKENED"));
    EXPECT_EQ(asked.import.thickened_triangles, 0u);
}

TEST(Thicken, AHalfSphereBecomesABowlOfThatThickness) {
    Shell half = shapes::icosphere(1, 3);
    std::erase_if(half.triangles, [&](const Triangle& t) {
        return half.positions[t[0]].y + half.positions[t[1]].y + half.positions[t[2]].y > 0;
    });
    half.component.assign(half.triangles.size(), 0);
    double area = 0;
    for (const auto& [a, b, c] : half.triangles)
        area += length(area_vector(half.positions[a], half.positions[b], half.positions[c])) / 2;
    const Cooked cooked = cook_shell(half, thickness(0.1));
    ASSERT_EQ(cooked.refusal, "");
    const Shell& bowl = cooked.asset.shell;
    EXPECT_TRUE(is_watertight(bowl.triangles));
    EXPECT_TRUE(non_manifold(bowl.triangles).edges.empty());
    EXPECT_TRUE(non_manifold(bowl.triangles).vertices.empty());
    EXPECT_NEAR(enclosed(bowl) / (0.1 * area), 1, 0.01);
    for (const Vec3& p : bowl.positions) EXPECT_NEAR(std::fabs(length(p) - 1), 0.05, 0.002);
}

TEST(Thicken, LocksGoToBothSides) {
    Shell square;
    square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    const Cooked cooked = cook_shell(square, thickness(0.5), [](std::size_t v) { return v < 2 ? 0.0 : 1.0; });
    ASSERT_EQ(cooked.refusal, "");
    const std::vector<Vec3> expected{{0, 0, -0.25}, {0, 0, 0.25}, {1, 0, -0.25}, {1, 0, 0.25}};
    EXPECT_EQ(cooked.asset.locked_positions, expected);
    EXPECT_NEAR(enclosed(cooked.asset.shell), 0.5, 1e-12);
    // Every copy knows the vertex of the file it was made of, and the tets hold each.
    const Shell& shell = cooked.asset.shell;
    std::vector<Index> locked_sources;
    for (std::size_t v = 0; v < shell.positions.size(); ++v) {
        if (shell.locked[v]) locked_sources.push_back(shell.source_vertex[v]);
    }
    std::sort(locked_sources.begin(), locked_sources.end());
    EXPECT_EQ(locked_sources, (std::vector<Index>{0, 0, 1, 1}));
    EXPECT_EQ(cooked.import.locked, 4u);
    for (Index v = 0; v < shell.positions.size(); ++v) {
        const bool is_used = std::any_of(cooked.mesh.tets.begin(), cooked.mesh.tets.end(),
                                         [&](const Tet& t) { return std::find(t.begin(), t.end(), v) != t.end(); });
        EXPECT_TRUE(is_used) << v;
    }
}

TEST(Thicken, SheetsThatMeetAtAnEdgeOrAVertexOverlap) {
    Shell fins;  // three sheets along one edge
    fins.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {-0.5, 0.8, 0.5}, {-0.5, -0.8, 0.5}};
    fins.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    const Cooked three = cook_shell(fins, thickness(0.1));
    ASSERT_EQ(three.refusal, "");
    EXPECT_EQ(three.asset.shell.components.size(), 3u);
    for (const Component& component : three.asset.shell.components) EXPECT_TRUE(component.is_closed);
    EXPECT_EQ(test::fault_of(three), "");
    Shell bow;  // two sheets at one vertex
    bow.positions = {{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}};
    bow.triangles = {{0, 1, 2}, {0, 4, 3}};
    const Cooked two = cook_shell(bow, thickness(0.1));
    ASSERT_EQ(two.refusal, "");
    EXPECT_EQ(two.asset.shell.components.size(), 1u);
    EXPECT_TRUE(two.asset.shell.components.at(0).is_closed);
    EXPECT_EQ(two.asset.shell.positions.size(), 10u);
    EXPECT_EQ(test::fault_of(two), "");
}

TEST(Thicken, AThicknessThatFloatsCannotShowIsAUsageError) {
    Shell square;
    square.positions = {{100, 0, 0}, {101, 0, 0}, {101, 1, 0}, {100, 1, 0}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    try {
        (void)cook_shell(square, thickness(1e-7));
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("import.thicken"), std::string::npos);
    }
}

}
}
