// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/delaunay.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "delaunay/cgal_oracle.h"
#include "delaunay/checks.h"
#include "delaunay/workloads.h"

namespace crumple {
namespace {

using checks::tetrahedralize;

struct Workload {
    std::string name;
    workloads::Points points;
};

// Up to 10k points; the sizes of the table when CRUMPLE_FULL_TESTS is set.
std::vector<Workload> table_workloads() {
    std::vector<Workload> list{
        {"uniform_1k", workloads::uniform(1000)}, {"uniform_10k", workloads::uniform(10000)},
        {"grid_10", workloads::grid(10)},         {"grid_20", workloads::grid(20)},
        {"sphere_2k", workloads::sphere(2000)},   {"clusters_5k", workloads::clusters(5000)},
        {"car_2k", workloads::car(2000)},         {"integer_sphere_65", workloads::integer_sphere(65)},
        {"lines_60", workloads::lines(60)},
    };
    if (std::getenv("CRUMPLE_FULL_TESTS") != nullptr) {
        list.push_back({"uniform_100k", workloads::uniform(100000)});
        list.push_back({"grid_47", workloads::grid(47)});
        list.push_back({"sphere_10k", workloads::sphere(10000)});
        list.push_back({"sphere_100k", workloads::sphere(100000)});
        list.push_back({"clusters_20k", workloads::clusters(20000)});
        list.push_back({"clusters_100k", workloads::clusters(100000)});
        list.push_back({"car_20k", workloads::car(20000)});
        list.push_back({"car_100k", workloads::car(100000)});
        list.push_back({"integer_sphere_1105", workloads::integer_sphere(1105)});
        list.push_back({"lines_2k", workloads::lines(2000)});
    }
    return list;
}

TEST(Delaunay, HasTheSameTetsAsCgalOnEveryWorkload) {
    for (const Workload& workload : table_workloads()) {
        SCOPED_TRACE(workload.name);
        const auto result = tetrahedralize(workload.points);
        EXPECT_TRUE(checks::sorted_tets(result.mesh) == oracle::cgal_tets(workload.points));
    }
}

TEST(Delaunay, GivesTheSameBytesInEveryOrder) {
    for (const Workload& workload : table_workloads()) {
        const auto expected = tetrahedralize(workload.points, delaunay::Order::quickhull);
        for (const auto order : checks::every_order) {
            SCOPED_TRACE(workload.name + " " + std::string(name_of(order)));
            checks::expect_same_mesh(tetrahedralize(workload.points, order).mesh, expected.mesh);
        }
    }
}

TEST(Delaunay, DoesNotDependOnTheOrderOfThePoints) {
    for (const Workload& workload : table_workloads()) {
        SCOPED_TRACE(workload.name);
        const auto expected = tetrahedralize(workload.points);
        const auto other_points = workloads::shuffled(workload.points, 5);
        const auto other = tetrahedralize(other_points);
        ASSERT_EQ(other.mesh.tets.size(), expected.mesh.tets.size());
        EXPECT_TRUE(other.mesh.neighbours == expected.mesh.neighbours);
        std::size_t moved = 0;
        for (Index tet = 0; tet < other.mesh.tets.size(); ++tet) {
            for (int corner = 0; corner < 4; ++corner) {
                const Vec3 here = other_points[other.mesh.tets[tet][corner]];
                moved += !(here == workload.points[expected.mesh.tets[tet][corner]]);
            }
        }
        EXPECT_EQ(moved, 0u) << "corners at another place";
    }
}

TEST(Delaunay, MatchesNeighboursAndKeepsSpheresEmpty) {
    for (const Workload& workload : table_workloads()) {
        SCOPED_TRACE(workload.name);
        const auto result = tetrahedralize(workload.points);
        checks::expect_positive_tets(result.mesh);
        checks::expect_delaunay_neighbours(result.mesh);
    }
}

TEST(Delaunay, CutsEveryCubeOfAGridTheSameWay) {
    const auto result = tetrahedralize(workloads::grid(6));
    EXPECT_EQ(result.mesh.tets.size(), 5u * 5u * 5u * 6u);
    double six_volumes = 0;  // integers: exact
    for (const Tet& t : result.mesh.tets) {
        const auto& p = result.mesh.positions;
        six_volumes += dot(p[t[1]] - p[t[0]], cross(p[t[2]] - p[t[0]], p[t[3]] - p[t[0]]));
    }
    EXPECT_EQ(six_volumes, 6 * 125.0);
}

TEST(Delaunay, KeepsEveryNodeAtItsIndex) {
    PointSet points;
    points.positions = workloads::car(500);
    points.shell_vertex_count = 100;
    const auto result = delaunay::tetrahedralize(points);
    EXPECT_TRUE(result.mesh.positions == points.positions);
    EXPECT_EQ(result.mesh.shell_vertex_count, 100u);
    std::vector<bool> used(points.positions.size());
    for (const Tet& tet : result.mesh.tets) {
        for (const Index node : tet) used[node] = true;
    }
    EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
}

TEST(Delaunay, FillsTheConvexHull) {
    checks::expect_convex_boundary(tetrahedralize(workloads::uniform(300)).mesh);
    checks::expect_convex_boundary(tetrahedralize(workloads::car(300)).mesh);
}

TEST(Delaunay, ReportsWhatItMade) {
    const auto result = tetrahedralize(workloads::uniform(1000));
    EXPECT_EQ(result.report.points, 1000u);
    EXPECT_EQ(result.report.duplicates, 0u);
    EXPECT_EQ(result.report.dimension, 3);
    EXPECT_EQ(result.report.tets, result.mesh.tets.size());
    // Euler: boundary edges are 3/2 of boundary faces, so interior and boundary counts fit together.
    std::size_t open_faces = 0;
    for (const auto& n : result.mesh.neighbours) open_faces += std::count(n.begin(), n.end(), none);
    EXPECT_EQ(result.report.hull_faces, open_faces);
    EXPECT_NE(result.report.order, delaunay::Order::automatic);
    EXPECT_TRUE(result.duplicate_of.empty());
    EXPECT_TRUE(result.report.findings.empty());
}

TEST(Delaunay, StopsWhenCancelled) {
    PointSet points;
    points.positions = workloads::uniform(100);
    const std::atomic<bool> cancelled = true;
    Context context;
    context.cancelled = &cancelled;
    for (const auto order : checks::every_order) {
        EXPECT_THROW(static_cast<void>(delaunay::tetrahedralize(points, {order}, context)), Error);
    }
}

}
}
