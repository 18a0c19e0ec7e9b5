// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/shapes.h"

#include <gtest/gtest.h>

#include "geometry/measures.h"
#include "geometry/predicates.h"

namespace crumple {
namespace {

double volume_of(const Shell& shell) {
    double sum = 0;
    for (const auto& [a, b, c] : shell.triangles) {
        sum += signed_volume({}, shell.positions[a], shell.positions[b], shell.positions[c]);
    }
    return sum;
}

TEST(Shapes, NoCompilerOptimizesRoundingAway) {
    for (int count = 1; count < 20; ++count) {
        std::vector<Vec3> positions(count, Vec3{1.0 / 3, 2.0 / 3, 1.0 / 7});
        for (Vec3& p : positions) p = round_to_float(p);
        const auto x = static_cast<float>(1.0 / 3);
        for (const Vec3& p : positions) EXPECT_EQ(p.x, double{x});
        EXPECT_EQ(positions.back().y, double{static_cast<float>(2.0 / 3)});
        EXPECT_EQ(positions.back().z, double{static_cast<float>(1.0 / 7)});
    }
}

TEST(Shapes, BoxesAreWoundOutwards) {
    EXPECT_DOUBLE_EQ(volume_of(shapes::box()), 1.0);
    EXPECT_DOUBLE_EQ(volume_of(shapes::subdivided_box(4, {-1, -1, -1}, {1, 2, 3})), 24.0);
    EXPECT_EQ(shapes::subdivided_box(4).positions.size(), 98u);
    EXPECT_EQ(shapes::subdivided_box(4).triangles.size(), 192u);
    EXPECT_DOUBLE_EQ(volume_of(shapes::inverted(shapes::box())), -1.0);
}

TEST(Shapes, RoundOnesComeNearTheirVolume) {
    const double ball = 4.0 / 3 * 3.14159265358979;
    EXPECT_NEAR(volume_of(shapes::icosphere(1, 3)), ball, 0.01 * ball);
    EXPECT_EQ(shapes::icosphere(1, 3).positions.size(), 642u);
    const double ring = 2 * 3.14159265358979 * 3.14159265358979 * 0.16;
    EXPECT_NEAR(volume_of(shapes::torus(1, 0.4, 64, 32)), ring, 0.02 * ring);
}

TEST(Shapes, JoinedShellsKeepBothComponents) {
    const Shell shell = shapes::joined(shapes::box(), shapes::box({5, 5, 5}, {6, 6, 6}));
    ASSERT_EQ(shell.components.size(), 2u);
    EXPECT_NE(shell.components[0].name, shell.components[1].name);
    EXPECT_EQ(shell.component.back(), 1u);
    EXPECT_DOUBLE_EQ(volume_of(shell), 2.0);
}

TEST(Shapes, TetGridIsPositiveAndFillsItsBox) {
    const TetMesh mesh = shapes::tet_grid(3, {-1, 0, 0}, {2, 1, 1});
    EXPECT_EQ(mesh.tets.size(), 162u);
    double sum = 0;
    for (const auto& [a, b, c, d] : mesh.tets) {
        EXPECT_EQ(orient3d(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]), 1);
        sum += signed_volume(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]);
    }
    EXPECT_NEAR(sum, 3.0, 1e-6);
}

}
}
