// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs on which Delaunay programs crash, hang or answer wrongly.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "delaunay/cgal_oracle.h"
#include "delaunay/checks.h"
#include "delaunay/delaunay.h"
#include "delaunay/workloads.h"

namespace crumple {
namespace {

using checks::tetrahedralize;
using workloads::Points;

void expect_flat(const Points& points, int dimension) {
    for (const auto order : checks::every_order) {
        const auto result = tetrahedralize(points, order);
        EXPECT_TRUE(result.mesh.tets.empty());
        EXPECT_TRUE(result.mesh.neighbours.empty());
        EXPECT_TRUE(result.mesh.positions == points);
        EXPECT_EQ(result.report.dimension, dimension);
        ASSERT_FALSE(result.report.findings.empty());
        EXPECT_EQ(result.report.findings[0].code, "POINTS_FLAT");
    }
}

void expect_true_delaunay(const Points& points) {
    const std::vector<Tet> expected = oracle::cgal_tets(points);
    ASSERT_FALSE(expected.empty());
    for (const auto order : checks::every_order) {
        SCOPED_TRACE(name_of(order));
        const auto result = tetrahedralize(points, order);
        EXPECT_EQ(result.report.dimension, 3);
        EXPECT_TRUE(checks::sorted_tets(result.mesh) == expected);
        checks::expect_positive_tets(result.mesh);
        checks::expect_delaunay_neighbours(result.mesh);
    }
}

TEST(DelaunayTraps, NoPoints) { expect_flat({}, -1); }
TEST(DelaunayTraps, OnePoint) { expect_flat({{1, 2, 3}}, 0); }
TEST(DelaunayTraps, TwoPoints) { expect_flat({{1, 2, 3}, {4, 5, 6}}, 1); }
TEST(DelaunayTraps, ThreePoints) { expect_flat({{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}, 2); }

TEST(DelaunayTraps, FourPointsAreOneTet) {
    const auto result = tetrahedralize({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}});
    ASSERT_EQ(result.mesh.tets.size(), 1u);
    checks::expect_positive_tets(result.mesh);
    EXPECT_EQ(result.report.hull_faces, 4u);
}

TEST(DelaunayTraps, AllPointsEqual) {
    const Points points(50, Vec3{0.1, 0.2, 0.3});
    expect_flat(points, 0);
    EXPECT_EQ(tetrahedralize(points).report.duplicates, 49u);
}

TEST(DelaunayTraps, Collinear) {
    Points along_axis, along_diagonal;
    for (int i = 0; i < 100; ++i) {
        along_axis.push_back({double(i), 0, 0});
        along_diagonal.push_back({0.5 * i, 0.25 * i, -3.0 * i});
    }
    expect_flat(workloads::shuffled(along_axis), 1);
    expect_flat(workloads::shuffled(along_diagonal), 1);
}

TEST(DelaunayTraps, ExactlyCoplanar) {
    Points points = workloads::uniform(200);
    for (Vec3& p : points) p.z = 0.1;
    expect_flat(points, 2);
    Points tilted;
    for (int i = 0; i < 15; ++i) {
        for (int j = 0; j < 15; ++j) tilted.push_back({double(i), double(j), 2.0 * i - 3.0 * j});
    }
    expect_flat(workloads::shuffled(tilted), 2);
}

TEST(DelaunayTraps, CoplanarButOne) {
    Points points = workloads::scaled(workloads::grid(8), {1, 1, 0});
    points.push_back({3, 3, 1});
    expect_true_delaunay(points);
}

TEST(DelaunayTraps, CoplanarToRounding) { expect_true_delaunay(workloads::nearly_coplanar(300)); }
TEST(DelaunayTraps, SlabOneUnitInTheLastPlaceThick) { expect_true_delaunay(workloads::thin_slab(300)); }

TEST(DelaunayTraps, HalfThePointsDuplicated) {
    const Points points = workloads::half_duplicated(400);
    expect_true_delaunay(points);
    const auto result = tetrahedralize(points);
    EXPECT_EQ(result.report.duplicates, 200u);
    ASSERT_EQ(result.duplicate_of.size(), points.size());
    for (Index i = 0; i < points.size(); ++i) {
        const Index first = result.duplicate_of[i];
        EXPECT_LE(first, i);
        EXPECT_EQ(result.duplicate_of[first], first);
        EXPECT_TRUE(points[first] == points[i]);
    }
    EXPECT_EQ(result.report.findings.at(0).code, "POINTS_DUPLICATE");
    EXPECT_EQ(result.report.findings.at(0).count, 200u);
}

TEST(DelaunayTraps, NegativeZeroIsZero) {
    const auto result = tetrahedralize({{0.0, 0, 0}, {-0.0, 0, 0}, {1, 0, 0}, {0, 1, -0.0}, {-0.0, -0.0, 1}});
    EXPECT_EQ(result.report.duplicates, 1u);
    EXPECT_EQ(result.duplicate_of.at(1), 0u);
    EXPECT_EQ(result.mesh.tets.size(), 1u);
}

TEST(DelaunayTraps, AspectRatioOfATrillion) {
    expect_true_delaunay(workloads::scaled(workloads::uniform(300), {1e12, 1, 1}));
    expect_true_delaunay(workloads::scaled(workloads::uniform(300), {1, 1, 1e-12}));
    expect_true_delaunay(workloads::scaled(workloads::grid(6), {1e12, 1, 1e-12}));
}

TEST(DelaunayTraps, FarFromTheOrigin) {
    expect_true_delaunay(workloads::scaled(workloads::uniform(300), {100, 100, 100}, {1e15, 1e15, 1e15}));
    expect_true_delaunay(workloads::scaled(workloads::grid(6), {1, 1, 1}, {1e15, -1e15, 0}));
}

TEST(DelaunayTraps, EveryScaleOfDouble) {
    for (const double scale : {1e-300, 1e-160, 1e-60, 1e100, 1e150, 1e300}) {
        SCOPED_TRACE(scale);
        expect_true_delaunay(workloads::scaled(workloads::uniform(60), scale));
        expect_true_delaunay(workloads::scaled(workloads::grid(4), scale));
    }
    // The largest doubles: even differences overflow.
    const double huge = std::numeric_limits<double>::max();
    const auto result = tetrahedralize(workloads::scaled(workloads::octahedron(), huge));
    EXPECT_EQ(result.mesh.tets.size(), 4u);
    checks::expect_positive_tets(result.mesh);
    checks::expect_delaunay_neighbours(result.mesh);
}

TEST(DelaunayTraps, PowersOfTwoChangeNothing) {
    const Points points = workloads::car(400);
    const auto expected = tetrahedralize(points);
    for (const double scale : {0x1p-300, 0x1p-20, 0x1p500}) {
        checks::expect_same_mesh(tetrahedralize(workloads::scaled(points, scale)).mesh, expected.mesh);
    }
}

TEST(DelaunayTraps, Denormals) { expect_true_delaunay(workloads::denormals(60)); }
TEST(DelaunayTraps, MixedMagnitudes) { expect_true_delaunay(workloads::mixed_magnitudes(60)); }

TEST(DelaunayTraps, HugeAndTinyTogether) {
    Points points = workloads::scaled(workloads::uniform(20), 1e200);
    for (const Vec3& p : workloads::scaled(workloads::uniform(20), 1e-200)) points.push_back(p);
    expect_true_delaunay(points);
}

TEST(DelaunayTraps, NotANumberIsRefusedByIndex) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        Points points = workloads::uniform(10);
        points[7].y = bad;
        try {
            static_cast<void>(tetrahedralize(points));
            ADD_FAILURE() << "accepted " << bad;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::bad_input);
            EXPECT_NE(std::string(error.what()).find("point 7"), std::string::npos) << error.what();
        }
    }
}

TEST(DelaunayTraps, OctahedronCubeAndConeRing) {
    expect_true_delaunay(workloads::octahedron());
    expect_true_delaunay(workloads::cube());
    expect_true_delaunay(workloads::cone_ring(48));
}

TEST(DelaunayTraps, ExactlyCosphericalIntegers) {
    expect_true_delaunay(workloads::integer_sphere(45));
    Points with_centre = workloads::integer_sphere(25);
    with_centre.push_back({0, 0, 0});
    expect_true_delaunay(with_centre);
}

TEST(DelaunayTraps, TwoSkewLines) { expect_true_delaunay(workloads::lines(80)); }

TEST(DelaunayTraps, ALargeStarIsJoinedToo) {
    // One point in the middle of a sphere sees every tet: a star of more vertices than the direct edge table takes.
    Points points = workloads::sphere(700);
    points.push_back({0.01, 0.02, 0.03});
    expect_true_delaunay(points);
}

TEST(DelaunayTraps, SmallRandomGridsOfEveryKind) {
    // Few places, many points: every mixture of coplanar, collinear, cospherical and equal.
    for (std::uint64_t round = 0; round < 300; ++round) {
        SCOPED_TRACE(round);
        Rng rng(workloads::seed, 1000 + round);
        const std::uint32_t side = 2 + rng.next_below(4);
        Points points(4 + rng.next_below(30));
        for (Vec3& p : points) {
            for (int axis = 0; axis < 3; ++axis) p[axis] = 0.3 * rng.next_below(side);
        }
        const auto result = tetrahedralize(points, checks::every_order[round % 3]);
        EXPECT_EQ(result.report.dimension, oracle::cgal_dimension(points));
        EXPECT_TRUE(checks::sorted_tets(result.mesh) == oracle::cgal_tets(points));
    }
}

}
}
