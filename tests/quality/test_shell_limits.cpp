// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/shell_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/measures.h"
#include "mesh/boundary.h"
#include "mesh/neighbours.h"
#include "mesh/shapes.h"
#include "quality/tet_measures.h"

using namespace crumple;
using namespace crumple::quality;

namespace {

std::vector<ShellLimit> limits_of(const TetMesh& mesh) {
    const std::vector<Triangle> faces = boundary_of(mesh).faces;
    return find_limits({mesh.positions, faces}, mesh.positions, mesh.tets);
}

double least_angle(const TetMesh& mesh) {
    double least = 180;
    for (const auto& [a, b, c, d] : mesh.tets) {
        least = std::min(least, degrees_of(min_dihedral_key(mesh.positions[a], mesh.positions[b], mesh.positions[c],
                                                            mesh.positions[d])));
    }
    return least;
}

// A layer of cells, side x thickness x side each.
TetMesh layer(int cells, double side, double thickness) {
    TetMesh mesh = shapes::tet_grid(cells, {0, 0, 0}, {side * cells, side * cells, side * cells});
    std::erase_if(mesh.tets, [&](const Tet& tet) {
        for (const Index v : tet) {
            if (mesh.positions[v].y > 1.5 * side) return true;
        }
        return false;
    });
    for (Vec3& p : mesh.positions) p.y *= thickness / side;
    mesh.neighbours = neighbours_of(mesh.tets);
    return mesh;
}

TEST(ShellLimits, NoTetsHaveNone) { EXPECT_TRUE(limits_of(TetMesh{}).empty()); }

TEST(ShellLimits, GoodTetsNeedNoExcuse) {
    const TetMesh mesh = shapes::tet_grid(3);
    EXPECT_EQ(limits_of(mesh), std::vector<ShellLimit>(mesh.tets.size(), ShellLimit::none));
}

TEST(ShellLimits, ASheetThinForItsEdgesExcusesTheTetsThatReachWhatItAllows) {
    const double thickness = 0.1;
    const TetMesh mesh = layer(8, 1, thickness);
    ASSERT_LT(least_angle(mesh), 10);
    const std::vector<ShellLimit> limits = limits_of(mesh);
    for (std::size_t t = 0; t < limits.size(); ++t) {
        const auto& [a, b, c, d] = mesh.tets[t];
        const double angle =
            degrees_of(min_dihedral_key(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]));
        EXPECT_EQ(limits[t], angle < 10 ? ShellLimit::thin : ShellLimit::none) << angle;
    }
}

TEST(ShellLimits, ASliverInAThinSheetHasNoExcuseWhenTheSheetAllowsBetter) {
    TetMesh mesh = layer(8, 1, 0.1);
    const std::vector<Triangle> faces = boundary_of(mesh).faces;
    const std::vector<Vec3> sound = mesh.positions;
    const auto [a, b, c, d] = mesh.tets[mesh.tets.size() / 2];
    const Vec3 normal = area_vector(sound[a], sound[b], sound[c]);
    const double height = dot(sound[d] - sound[a], normal) / dot(normal, normal);
    mesh.positions[d] -= normal * (0.9 * height);
    const std::vector<ShellLimit> limits = find_limits({sound, faces}, mesh.positions, mesh.tets);
    EXPECT_EQ(limits[mesh.tets.size() / 2], ShellLimit::none);
}

TEST(ShellLimits, ATetOnANeedleOfTheShellIsNamedSo) {
    TetMesh mesh;
    const double width = std::tan(4 * std::numbers::pi / 180);
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, width, 0}, {0.7, 0, 0.7}};
    mesh.tets = {{0, 1, 2, 3}};
    mesh.neighbours = {{none, none, none, none}};
    ASSERT_LT(least_angle(mesh), 10);
    EXPECT_NE(limits_of(mesh)[0], ShellLimit::none);
    // As part of a thick shell it is the needle alone.
    const Shell box = shapes::box({-2, -2, 0}, {2, 2, 4});
    std::vector<Vec3> positions = mesh.positions;
    std::vector<Triangle> triangles{{0, 2, 1}};
    for (const Vec3 p : box.positions) positions.push_back(p);
    for (const Triangle& t : box.triangles) triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
    EXPECT_EQ(find_limits({positions, triangles}, mesh.positions, mesh.tets)[0], ShellLimit::needle);
}

TEST(ShellLimits, ASliverOnAThickShellHasNoExcuse) {
    TetMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.01}};
    mesh.tets = {{0, 1, 2, 3}};
    Shell box = shapes::subdivided_box(4, {-1.5, -1.5, -4}, {1.5, 1.5, 0});
    std::vector<Vec3> positions = mesh.positions;
    std::vector<Triangle> triangles;
    for (const Vec3 p : box.positions) positions.push_back(p);
    for (const Triangle& t : box.triangles) {
        const bool is_top = box.positions[t[0]].z == 0 && box.positions[t[1]].z == 0 && box.positions[t[2]].z == 0;
        if (!is_top) triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
    }
    triangles.push_back({0, 1, 2});
    EXPECT_EQ(find_limits({positions, triangles}, mesh.positions, mesh.tets)[0], ShellLimit::none);
}

TEST(ShellLimits, OtherAnglesThanTenDegreesCanBeAskedFor) {
    const TetMesh mesh = layer(6, 1, 0.2);  // atan 0.2 is 11.3 degrees
    const std::vector<Triangle> faces = boundary_of(mesh).faces;
    const std::vector<ShellLimit> below_10 = find_limits({mesh.positions, faces}, mesh.positions, mesh.tets);
    const std::vector<ShellLimit> below_20 = find_limits({mesh.positions, faces}, mesh.positions, mesh.tets, {}, 20);
    EXPECT_EQ(std::count(below_10.begin(), below_10.end(), ShellLimit::none), std::ssize(below_10));
    EXPECT_GT(std::count(below_20.begin(), below_20.end(), ShellLimit::thin), std::ssize(below_20) / 2);
}

// A box, and the same one inside it, the gap between them filled by layers of tets on each face.
struct Doubled {
    Shell shell;
    TetMesh mesh;
};

Doubled doubled(double gap) {
    const TetMesh inner = shapes::tet_grid(3);
    Doubled made;
    made.mesh.positions = inner.positions;
    const std::vector<Triangle> faces = boundary_of(inner).faces;
    const Vec3 centre{0.5, 0.5, 0.5};
    for (const Vec3 p : inner.positions) made.mesh.positions.push_back(centre + (p - centre) * (1 + 2 * gap));
    const auto offset = static_cast<Index>(inner.positions.size());
    made.shell.positions = made.mesh.positions;
    for (const Triangle& t : faces) {
        made.shell.triangles.push_back(t);
        made.shell.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
        made.mesh.tets.push_back({t[0], t[1], t[2], t[0] + offset});
    }
    return made;
}

TEST(ShellLimits, SurfacesThatNearlyCoincideForceTheTetsBetweenThem) {
    for (const double gap : {1e-7, 1e-4, 0.01}) {
        const Doubled made = doubled(gap);
        const std::vector<ShellLimit> limits =
            find_limits({made.shell.positions, made.shell.triangles}, made.mesh.positions, made.mesh.tets);
        for (const ShellLimit limit : limits) EXPECT_EQ(limit, ShellLimit::gap) << gap;
    }
}

TEST(ShellLimits, AThinSheetIsThinHoweverLarge) {
    for (const double thickness : {1e-2, 1e-4, 1e-6}) {
        const TetMesh mesh = layer(16, 1, thickness);
        const std::vector<ShellLimit> limits = limits_of(mesh);
        EXPECT_GT(std::count(limits.begin(), limits.end(), ShellLimit::thin), std::ssize(limits) / 2) << thickness;
        EXPECT_EQ(std::count(limits.begin(), limits.end(), ShellLimit::none), 0) << thickness;
    }
}

}
