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
        : mesh(shapes::filled(shell, count)), space(shell) {
        for (const Vec3 p : shapes::interior_of(mesh)) spots.push_back(space.look_at(p));
        stars = find_stars(mesh, std::vector<std::uint8_t>(mesh.tets.size(), 1));
    }
    [[nodiscard]] Moves move(TargetFunction target) const {
        return choose_moves(mesh, stars, spots, target, space, {});
    }

    TetMesh mesh;
    MaterialSpace space;
    std::vector<Spot> spots;
    Stars stars;
};

void expect_distinct(const TetMesh& mesh, const std::vector<Spot>& spots) {
    std::vector<Vec3> places(mesh.positions.begin(), mesh.positions.begin() + mesh.shell_vertex_count);
    for (const Spot& spot : spots) places.push_back(spot.position);
    std::sort(places.begin(), places.end(), lexicographic_less<double>);
    EXPECT_EQ(std::unique(places.begin(), places.end()), places.end());
}

TEST(MoveNodes, NoInteriorNodesMeansNoMoves) {
    const Scene scene(shapes::subdivided_box(3), "0");
    const Moves moves = scene.move(target_cpt);
    EXPECT_TRUE(moves.spots.empty());
    EXPECT_EQ(moves.max_move, 0);
}

TEST(MoveNodes, ATargetThatIsNotFiniteHoldsTheNode) {
    const Scene scene(shapes::subdivided_box(3));
    const Moves moves = scene.move([](const Star&) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return Vec3{nan, 0, 0};
    });
    EXPECT_EQ(moves.max_move, 0);
    EXPECT_EQ(moves.held, scene.spots.size());
}

TEST(MoveNodes, ATargetOutsideIsApproachedOnlyAsFarAsTheMaterialGoes) {
    const Scene scene(shapes::subdivided_box(3));
    const Moves moves = scene.move([](const Star& star) { return star.mesh.positions[star.node] + Vec3{1.5, 0, 0}; });
    int moved = 0;
    for (std::size_t n = 0; n < moves.spots.size(); ++n) {
        EXPECT_LT(moves.spots[n].position.x, 1);
        moved += moves.spots[n].position != scene.spots[n].position ? 1 : 0;
    }
    EXPECT_EQ(moves.held, scene.spots.size());
    EXPECT_GT(moved, 0);
}

TEST(MoveNodes, NoNodeEntersACavityOrAnotherPart) {
    for (const Role role : {Role::cavity, Role::rigid}) {
        const Scene scene(shapes::nested_boxes(role), "60");
        ASSERT_FALSE(scene.spots.empty());
        const Moves moves = scene.move([](const Star&) { return Vec3{1.5, 1.5, 1.5}; });
        for (const Spot& spot : moves.spots) {
            const Vec3 p = spot.position;
            EXPECT_FALSE(p.x > 1 && p.x < 2 && p.y > 1 && p.y < 2 && p.z > 1 && p.z < 2);
            EXPECT_EQ(spot.material, scene.spots[0].material);
        }
    }
}

TEST(MoveNodes, NodesWithOneTargetDoNotMeet) {
    const Scene scene(shapes::subdivided_box(3));
    ASSERT_GT(scene.spots.size(), 5u);
    const Moves moves = scene.move([](const Star&) { return Vec3{0.5, 0.5, 0.5}; });
    expect_distinct(scene.mesh, moves.spots);
}

TEST(MoveNodes, ANodeSentBackDoesNotMeetOneThatTakesItsPlace) {
    // Each node wants the place of the next one, the last one wants where the first but one goes.
    const Scene scene(shapes::subdivided_box(3));
    ASSERT_GT(scene.spots.size(), 5u);
    const Moves moves = scene.move([](const Star& star) {
        const auto last = static_cast<Index>(star.mesh.positions.size() - 1);
        return star.mesh.positions[star.node == last ? last - 1 : star.node + 1];
    });
    expect_distinct(scene.mesh, moves.spots);
    for (std::size_t n = 0; n < moves.spots.size(); ++n) EXPECT_EQ(moves.spots[n].position, scene.spots[n].position);
}

TEST(MoveNodes, NodesMayTradePlaces) {
    const Scene scene(shapes::subdivided_box(3));
    ASSERT_GT(scene.spots.size(), 5u);
    const Moves moves = scene.move([](const Star& star) {
        const Index first = star.mesh.shell_vertex_count;
        if (star.node == first) return star.mesh.positions[first + 1];
        if (star.node == first + 1) return star.mesh.positions[first];
        return star.mesh.positions[star.node];
    });
    EXPECT_EQ(moves.spots[0].position, scene.spots[1].position);
    EXPECT_EQ(moves.spots[1].position, scene.spots[0].position);
    EXPECT_EQ(moves.held, 0u);
}

TEST(MoveNodes, NoNodeLandsOnAShellVertexOrTheShell) {
    const Scene scene(shapes::subdivided_box(3));
    const Moves moves = scene.move([](const Star& star) { return star.mesh.positions[0]; });
    for (const Spot& spot : moves.spots) EXPECT_GT(spot.clear, 0);
    expect_distinct(scene.mesh, moves.spots);
}

TEST(MoveNodes, PlacesAreRoundedToFloat) {
    const Scene scene(shapes::subdivided_box(3));
    const Moves moves = scene.move(target_cpt);
    for (const Spot& spot : moves.spots) EXPECT_EQ(round_to_float(spot.position), spot.position);
    EXPECT_GT(moves.max_move, 0);
}

}
