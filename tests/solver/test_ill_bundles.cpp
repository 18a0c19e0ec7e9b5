// SPDX-License-Identifier: MIT
// S9: bundles whose arrays are sound and whose meshes are not. What has no volume or no mass is refused; the rest moves
// as physics says, whatever its neighbours in the arrays do.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/body.h"
#include "solver/instance.h"

namespace crumple::solver::test {
namespace {

Material jelly() {
    Material m = elastic_material(1e6);
    m.alpha_per_s = 0.15;
    m.beta_s = 0.004;
    return m;
}

const Vec3f down{0, -9.81f, 0};

Bundle bar() { return grid_body({4, 2, 2}, {0.25f, 0.25f, 0.25f}, jelly()); }
bool is_at_wall(Vec3f p) { return p.x == 0; }

// A bundle of both, the second moved. Locked is what `is_locked` says of the whole.
Bundle side_by_side(const Bundle& a, Bundle b, Vec3f by, const std::function<bool(Vec3f)>& is_locked = {}) {
    const auto offset = static_cast<Index>(a.rest_positions.size());
    std::vector<Vec3f> positions = a.rest_positions;
    std::vector<Tet> tets = a.tets;
    for (const Vec3f p : b.rest_positions) positions.push_back(p + by);
    for (Tet tet : b.tets) {
        for (Index& node : tet) node += offset;
        tets.push_back(tet);
    }
    return bundle_of(positions, tets, jelly(), is_locked);
}

Vec3 momentum_of_nodes(const Body& body, std::size_t begin, std::size_t end) {
    Vec3 sum;
    for (std::size_t i = begin; i < end; ++i) {
        sum += widen(velocity(body.state, i)) * static_cast<double>(body.bundle.mass[i]);
    }
    return sum;
}

double mass_of_nodes(const Body& body, std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += static_cast<double>(body.bundle.mass[i]);
    return sum;
}

// Truths hold of what is solved, not of what a budget leaves.
Settings solved() {
    Settings settings;
    settings.max_iterations = 300;
    settings.tolerance = 1e-6;
    return settings;
}

StepInput falling() {
    StepInput input;
    input.gravity = down;
    return input;
}

}

TEST(S9DuplicateNodes, ATetWithTwoCornersAtOnePlaceIsRefused) {
    const Bundle good = bar();
    std::vector<Vec3f> positions = good.rest_positions;
    positions[good.tets[7][1]] = positions[good.tets[7][2]];
    EXPECT_NE(first_problem(view_of(bundle_of(positions, good.tets, jelly()))), nullptr);
    std::vector<Tet> tets = good.tets;
    tets[7][1] = tets[7][2];
    EXPECT_NE(first_problem(view_of(bundle_of(good.rest_positions, tets, jelly()))), nullptr);
}

TEST(S9DuplicateNodes, TwoBodiesOnTheSamePlacesHangLikeOne) {
    const Bundle one = bundle_of(bar().rest_positions, bar().tets, jelly(), is_at_wall);
    Body alone(one);
    Body both(side_by_side(bar(), bar(), {}, is_at_wall));
    for (int i = 0; i < 120; ++i) {
        alone.step(falling());
        both.step(falling());
    }
    const std::size_t count = alone.node_count();
    double sag = 0;
    for (std::size_t n = 0; n < count; ++n) {
        sag = std::max(sag, static_cast<double>(length(alone.x(n) - alone.rest(n))));
        EXPECT_LT(length(both.x(n) - alone.x(n)), 1e-5f);
        EXPECT_LT(length(both.x(count + n) - alone.x(n)), 1e-5f);
    }
    EXPECT_GT(sag, 0.01);
}

// Welding missed them: a tet as thin as float can tell, between a corner of the bar and its copy.
TEST(S9DuplicateNodes, CopiesAHairApartStayFiniteAndAreToldOf) {
    for (const float hair : {0.3f, 1e-3f, 1e-5f, 1e-7f}) {
        const Bundle good = bar();
        std::vector<Vec3f> positions = good.rest_positions;
        std::vector<Tet> tets = good.tets;
        const Tet tet = tets.back();
        const Vec3f to_first = positions[tet[0]] - positions[tet[1]];
        positions.push_back(positions[tet[1]] + to_first * hair);
        tets.push_back({static_cast<Index>(positions.size() - 1), tet[1], tet[2], tet[3]});
        Body body(bundle_of(positions, tets, jelly(), is_at_wall));
        std::uint32_t warnings = 0;
        double most = 0;
        for (int i = 0; i < 240; ++i) {
            const StepReport report = body.step(falling());
            warnings |= report.warnings;
            most = std::max(most, report.energy);
        }
        EXPECT_TRUE(body.is_finite()) << hair;
        // All the weight there is, fallen by all the length there is.
        EXPECT_LT(most, mass_of_nodes(body, 0, body.node_count()) * 9.81 * 1.0) << hair;
        EXPECT_EQ((warnings & step_too_stiff) != 0, hair < 0.1f) << hair;
    }
}

TEST(S9Islands, AFreeOneFallsWhileAnotherHangs) {
    Body body(side_by_side(bar(), bar(), {5, 0, 0}, is_at_wall), solved());
    Body hung(bundle_of(bar().rest_positions, bar().tets, jelly(), is_at_wall), solved());
    const std::size_t count = hung.node_count();
    constexpr int steps = 60;
    for (int i = 0; i < steps; ++i) {
        body.step(falling());
        hung.step(falling());
    }
    for (std::size_t n = 0; n < count; ++n) EXPECT_LT(length(body.x(n) - hung.x(n)), 1e-4f);
    // Semi-implicit Euler of v' = g - alpha v, without a strain.
    double v = 0, y = 0;
    const double dt = 1.0 / 60;
    for (int i = 0; i < steps; ++i) {
        v = (v - 9.81 * dt) / (1 + 0.15 * dt);
        y += v * dt;
    }
    for (std::size_t n = count; n < 2 * count; ++n) {
        EXPECT_NEAR(body.x(n).y - body.rest(n).y, y, 1e-4 * -y);
        EXPECT_NEAR(body.x(n).x, body.rest(n).x, 1e-4);
    }
}

// What holds a body together as a whole must not hold islands together.
TEST(S9Islands, AWallThatOneHitsIsNothingToTheOther) {
    Material free = jelly();
    free.alpha_per_s = 0;
    Bundle two = side_by_side(bar(), bar(), {5, 0, 0});
    two.materials[0] = free;
    Body body(std::move(two), solved());
    const std::size_t count = body.node_count() / 2;
    body.set_velocities([](Vec3f p) { return p.x > 3 ? Vec3f{0, 1, 0} : Vec3f{-5, 0, 0}; });
    const Vec3 before = momentum_of_nodes(body, count, 2 * count);
    Obstacle wall;
    wall.axis = {1, 0, 0};
    wall.position = {-0.2, 0, 0};
    std::vector<Constraint> room(body.node_count());
    InstanceInput input;
    input.gravity = {};
    input.obstacles = {&wall, 1};
    input.room = room;
    input.may_sleep = false;
    std::size_t contacts = 0;
    for (int i = 0; i < 60; ++i) {
        contacts += step_instance(body.model, body.state, body.workspace, input, body.settings).contacts;
        ASSERT_TRUE(body.is_finite());
    }
    EXPECT_GT(contacts, 0u);
    EXPECT_GT(momentum_of_nodes(body, 0, count).x, -0.5 * mass_of_nodes(body, 0, count));
    const Vec3 after = momentum_of_nodes(body, count, 2 * count);
    EXPECT_LT(length(after - before), 1e-3 * 5 * mass_of_nodes(body, 0, count));
}

TEST(S9UnreferencedNodes, AFreeOneIsRefusedAndALockedOneStaysWhereItIs) {
    const Bundle good = bar();
    std::vector<Vec3f> positions = good.rest_positions;
    const Vec3f away{7, 7, 7};
    positions.insert(positions.begin() + 3, away);
    std::vector<Tet> tets = good.tets;
    for (Tet& tet : tets) {
        for (Index& node : tet) node += node >= 3 ? 1u : 0u;
    }
    EXPECT_NE(first_problem(view_of(bundle_of(positions, tets, jelly()))), nullptr);
    Body body(bundle_of(positions, tets, jelly(), [&](Vec3f p) { return p.x == 0 || p == away; }));
    Body without(bundle_of(good.rest_positions, good.tets, jelly(), is_at_wall));
    for (int i = 0; i < 60; ++i) {
        body.step(falling());
        without.step(falling());
    }
    ASSERT_TRUE(body.is_finite());
    EXPECT_EQ(body.x(3), away);
    for (std::size_t n = 0; n < without.node_count(); ++n) {
        EXPECT_LT(length(body.x(n < 3 ? n : n + 1) - without.x(n)), 1e-5f);
    }
}

}
