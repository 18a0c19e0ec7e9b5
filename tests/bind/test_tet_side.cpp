// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/tet_side.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace crumple::bind {
namespace {

constexpr std::array<Vec3, 4> unit_tet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

TEST(TetSide, CornersEdgesAndFacesAreBorder) {
    for (int i = 0; i < 4; ++i) {
        const TetSide at = side_of_tet(unit_tet, unit_tet[i]);
        EXPECT_EQ(at.side, Side::border);
        for (int j = 0; j < 4; ++j) EXPECT_EQ(at.weights[j], i == j ? 1 : 0);
    }
    EXPECT_EQ(side_of_tet(unit_tet, {0.5, 0.25, 0}).side, Side::border);
    EXPECT_EQ(side_of_tet(unit_tet, {0.5, 0.5, 0}).side, Side::border);
}

TEST(TetSide, AnUlpBesideAFaceIsTold) {
    const double tiny = 1e-300;
    EXPECT_EQ(side_of_tet(unit_tet, {0.25, 0.25, tiny}).side, Side::inside);
    EXPECT_EQ(side_of_tet(unit_tet, {0.25, 0.25, -tiny}).side, Side::outside);
    const double past = std::nextafter(0.25, 1);
    EXPECT_EQ(side_of_tet(unit_tet, {0.25, 0.25, 0.5}).side, Side::border);
    EXPECT_EQ(side_of_tet(unit_tet, {past, 0.25, 0.5}).side, Side::outside);
    EXPECT_EQ(side_of_tet(unit_tet, {std::nextafter(0.25, 0), 0.25, 0.5}).side, Side::inside);
}

TEST(TetSide, WeightsDescribeThePointAndAreNeverNegative) {
    Rng rng(4);
    const auto random = [&] {
        const double x = rng.next_unit();
        const double y = rng.next_unit();
        return Vec3{x, y, rng.next_unit()};
    };
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
        std::array<Vec3, 4> tet{random(), random(), random(), random()};
        if (orient3d(tet[0], tet[1], tet[2], tet[3]) < 0) std::swap(tet[0], tet[1]);
        const Vec3 p = (tet[0] + tet[1] + tet[2] + tet[3]) * 0.25 + (random() - Vec3{0.5, 0.5, 0.5}) * 0.3;
        const TetSide at = side_of_tet(tet, p);
        if (at.side == Side::outside) continue;
        ++inside;
        Vec3 sum;
        for (int corner = 0; corner < 4; ++corner) {
            EXPECT_GE(at.weights[corner], 0);
            sum += tet[corner] * at.weights[corner];
        }
        EXPECT_LT(length(sum - p), 1e-11);
    }
    EXPECT_GT(inside, 300);
}

TEST(TetSide, ExactlyOneOfNeighboursHasAPointOffTheirFace) {
    // Two tets on a face whose plane no double can hit.
    const std::array<Vec3, 3> face{{{0.1, 0.2, 0.3}, {0.7, 0.1, 0.4}, {0.3, 0.9, 0.6}}};
    const std::array<Vec3, 4> below{face[0], face[1], face[2], {0.5, 0.5, 2}};
    const std::array<Vec3, 4> above{face[0], face[2], face[1], {0.5, 0.5, -2}};
    ASSERT_GT(orient3d(below[0], below[1], below[2], below[3]), 0);
    ASSERT_GT(orient3d(above[0], above[1], above[2], above[3]), 0);
    Rng rng(9);
    for (int i = 0; i < 500; ++i) {
        const double u = 0.8 * rng.next_unit() + 0.05;
        const double v = (0.9 - u) * rng.next_unit() + 0.02;
        const Vec3 p = face[0] * (1 - u - v) + face[1] * u + face[2] * v;
        const Side one = side_of_tet(below, p).side;
        const Side other = side_of_tet(above, p).side;
        EXPECT_NE(one == Side::inside, other == Side::inside);
        EXPECT_EQ(one == Side::border, other == Side::border);
    }
}

TEST(TetSide, ScaleDoesNotMatter) {
    for (const double scale : {0x1p-100, 0x1p100}) {
        std::array<Vec3, 4> tet = unit_tet;
        for (Vec3& corner : tet) corner = corner * scale;
        EXPECT_EQ(side_of_tet(tet, Vec3{0.25, 0.25, 0.25} * scale).side, Side::inside);
        EXPECT_EQ(side_of_tet(tet, Vec3{0.25, 0.25, 0.5} * scale).side, Side::border);
        EXPECT_EQ(side_of_tet(tet, Vec3{0.25, 0.25, 0.51} * scale).side, Side::outside);
    }
}

}
}
