// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/move_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "filled_shell.h"
#include "mesh/shapes.h"

using namespace crumple;
using namespace crumple::relax;

namespace {

struct Scene {
    explicit Scene(const Shell& shell, const std::string& count = "30")
        : mesh(shapes::filled(shell, count)), interior(shell) {
        for (const Vec3 p : shapes::interior_of(mesh)) materials.push_back(interior.material_at(p));
        stars = find_stars(mesh, std::vector<std::uint8_t>(mesh.tets.size(), 1));
    }
    [[nodiscard]] Moves move(TargetFunction target) const {
        return choose_moves(mesh, stars, materials, target, interior, {});
    }

    TetMesh mesh;
    ShellInterior interior;
    std::vector<Index> materials;
    Stars stars;
};

void expect_distinct(const TetMesh& mesh, const std::vector<Vec3>& interior) {
    std::vector<Vec3> places(mesh.positions.begin(), mesh.positions.begin() + mesh.shell_vertex_count);
    places.insert(places.end(), interior.begin(), interior.end());
    std::sort(places.begin(), places.end(), lexicographic_less<double>);
    EXPECT_EQ(std::unique(places.begin(), places.end()), places.end());
}

TEST(MoveNodes, NoInteriorNodesMeansNoMoves) {
    const Scene scene(shapes::subdivided_box(3), "0");
    const Moves moves = scene.move(target_cpt);
    EXPECT_TRUE(moves.places.empty());
    EXPECT_EQ(moves.max_move, 0);
}

TEST(MoveNodes, ATargetThatIsNotFiniteHoldsTheNode) {
    const Scene scene(shapes::subdivided_box(3));
    const Moves moves = scene.move([](const Star&) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return Vec3{nan, 0, 0};
    });
    EXPECT_EQ(moves.max_move, 0);
    EXPECT_EQ(moves.held, scene.materials.size());
}

TEST(MoveNodes, ATargetOutsideIsApproachedOnlyAsFarAsTheMaterialGoes) {
    const Scene scene(shapes::subdivided_box(3));
    const Moves moves = scene.move([](const Star& star) { return star.mesh.positions[star.node] + Vec3{1.5, 0, 0}; });
    int moved = 0;
    for (std::size_t n = 0; n < moves.places.size(); ++n) {
        EXPECT_LT(moves.places[n].x, 1);
        moved += moves.places[n] != shapes::interior_of(scene.mesh)[n] ? 1 : 0;
    }
    EXPECT_EQ(moves.held, scene.materials.size());
    EXPECT_GT(moved, 0);
}

TEST(MoveNodes, NoNodeEntersACavityOrAnotherPart) {
    for (const Role role : {Role::cavity, Role::rigid}) {
        const Scene scene(shapes::nested_boxes(role), "60");
        ASSERT_FALSE(scene.materials.empty());
        const Moves moves = scene.move([](const Star&) { return Vec3{1.5, 1.5, 1.5}; });
        for (const Vec3 p : moves.places) {
            EXPECT_FALSE(p.x > 1 && p.x < 2 && p.y > 1 && p.y < 2 && p.z > 1 && p.z < 2);
            EXPECT_EQ(scene.interior.material_at(p), scene.materials[0]);
        }
    }
}

TEST(MoveNodes, NodesWithOneTargetDoNotMeet) {
    const Scene scene(shapes::subdivided_box(3));
    ASSERT_GT(scene.materials.size(), 5u);
    const Moves moves = scene.move([](const Star&) { return Vec3{0.5, 0.5, 0.5}; });
    expect_distinct(scene.mesh, moves.places);
}

TEST(MoveNodes, ANodeSentBackDoesNotMeetOneThatTakesItsPlace) {
    // Each node wants the place of the next one, the last one wants where the first but one goes.
    const Scene scene(shapes::subdivided_box(3));
    ASSERT_GT(scene.materials.size(), 5u);
    const Moves moves = scene.move([](const Star& star) {
        const auto last = static_cast<Index>(star.mesh.positions.size() - 1);
        return star.mesh.positions[star.node == last ? last - 1 : star.node + 1];
    });
    expect_distinct(scene.mesh, moves.places);
    for (std::size_t n = 0; n < moves.places.size(); ++n)
        EXPECT_EQ(moves.places[n], shapes::interior_of(scene.mesh)[n]);
}

TEST(MoveNodes, NodesMayTradePlaces) {
    const Scene scene(shapes::subdivided_box(3));
    ASSERT_GT(scene.materials.size(), 5u);
    const Moves moves = scene.move([](const Star& star) {
        const Index first = star.mesh.shell_vertex_count;
        if (star.node == first) return star.mesh.positions[first + 1];
        if (star.node == first + 1) return star.mesh.positions[first];
        return star.mesh.positions[star.node];
    });
    EXPECT_EQ(moves.places[0], shapes::interior_of(scene.mesh)[1]);
    EXPECT_EQ(moves.places[1], shapes::interior_of(scene.mesh)[0]);
    EXPECT_EQ(moves.held, 0u);
}

TEST(MoveNodes, NoNodeLandsOnAShellVertexOrTheShell) {
    const Scene scene(shapes::subdivided_box(3));
    const Moves moves = scene.move([](const Star& star) { return star.mesh.positions[0]; });
    for (const Vec3 p : moves.places) EXPECT_NE(scene.interior.material_at(p), none);
    expect_distinct(scene.mesh, moves.places);
}

TEST(MoveNodes, NoNodeComesToLieOnTheWallOfACavity) {
    // Half the way is exactly the wall of the hole: neither outside nor in it.
    Shell shell = shapes::nested_boxes(Role::cavity);
    PointSet points = shapes::points_of(shell);
    points.positions.push_back({0.5, 1.5, 1.5});
    const TetMesh mesh = delaunay::tetrahedralize(points).mesh;
    const ShellInterior interior(shell);
    const Stars stars = find_stars(mesh, std::vector<std::uint8_t>(mesh.tets.size(), 1));
    const std::vector<Index> materials{interior.material_at(points.positions.back())};
    const auto target = [](const Star&) { return Vec3{1.5, 1.5, 1.5}; };
    EXPECT_EQ(choose_moves(mesh, stars, materials, target, interior, {}).places[0], (Vec3{0.75, 1.5, 1.5}));
}

TEST(MoveNodes, PlacesAreRoundedToFloat) {
    const Scene scene(shapes::subdivided_box(3));
    const Moves moves = scene.move(target_cpt);
    for (const Vec3 p : moves.places) EXPECT_EQ(round_to_float(p), p);
    EXPECT_GT(moves.max_move, 0);
}

}
