// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/error.h"
#include "solver/body.h"
#include "study/load_scene.h"
#include "study/place.h"

namespace crumple::study {
namespace {

std::string complaint(const std::string& json) {
    try {
        (void)read_scene(json, "s.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        return error.what();
    }
    return "none";
}

Bundle bar() { return solver::test::grid_body({4, 2, 2}, {0.5f, 0.5f, 0.5f}, solver::test::elastic_material()); }

}

TEST(Scene, ABrokenSceneSaysWhereAndWhat) {
    EXPECT_NE(complaint("{").find("s.json"), std::string::npos);
    EXPECT_NE(complaint(R"({"secnds": 1})").find("seconds"), std::string::npos);
    EXPECT_NE(complaint(R"({"seconds": -1})").find("seconds"), std::string::npos);
    EXPECT_NE(complaint(R"({"obstacles": [{"shape": "bal"}]})").find("obstacles[0].shape"), std::string::npos);
    EXPECT_NE(complaint(R"({"obstacles": [{"shape": "capsule"}]})").find("obstacles[0].radius_m"), std::string::npos);
    EXPECT_NE(complaint(R"({"obstacles": [{"axis": [0, 0, 0]}]})").find("obstacles[0].axis"), std::string::npos);
    EXPECT_NE(complaint(R"({"obstacles": [{"axis": [-1e200, 0, 0]}]})").find("obstacles[0].axis"), std::string::npos);
    EXPECT_NE(complaint(R"({"obstacles": [{"velocity": [0, 1e308, 0]}]})").find("obstacles[0].velocity"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"obstacles": [{"position": [0, 1e6, 0]}]})").find("obstacles[0].position"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"velocity": [0, 0, 1e5]})").find("velocity"), std::string::npos);
    EXPECT_NE(complaint(R"({"angular_velocity_deg": [0, 0, 1e7]})").find("angular_velocity_deg"), std::string::npos);
    EXPECT_NE(complaint(R"({"gravity": [0, -1e308, 0]})").find("gravity"), std::string::npos);
    EXPECT_NE(complaint(R"({"handles": [{"times_s": [0], "shift_m": [[1e9, 0, 0]]}]})").find("handles[0].shift_m"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"handles": [{}]})").find("handles[0].times_s"), std::string::npos);
    EXPECT_NE(complaint(R"({"handles": [{"times_s": [1, 1]}]})").find("ascend"), std::string::npos);
    EXPECT_NE(complaint(R"({"handles": [{"times_s": [0, 1], "shift_m": [[0, 0, 0]]}]})").find("handles[0].shift_m"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"frames_per_s": 1000, "steps_per_s": 60})").find("frames_per_s"), std::string::npos);
    EXPECT_NE(complaint(R"({"seconds": 3600, "steps_per_s": 100000})").find("too long"), std::string::npos);
}

TEST(Scene, AllBuiltinScenesRead) {
    EXPECT_GE(builtin_scenes().size(), 6u);
    for (const BuiltinScene& scene : builtin_scenes()) {
        EXPECT_FALSE(load_scene(std::string(scene.name)).description.empty()) << scene.name;
    }
    EXPECT_THROW((void)load_scene("pool"), Error);
    EXPECT_THROW((void)load_scene("nowhere/s.json"), Error);
}

TEST(Scene, AnObstacleStandsBackByItsGap) {
    const Bundle bundle = bar();
    for (const auto shape :
         {solver::ObstacleShape::plane, solver::ObstacleShape::capsule, solver::ObstacleShape::box}) {
        SceneObstacle o;
        o.shape = shape;
        o.axis = shape == solver::ObstacleShape::plane ? Vec3{1, 0, 0} : Vec3{0.1, 2, 0.1};
        o.radius_m = shape == solver::ObstacleShape::capsule ? 0.2 : 0;
        o.gap_m = 0.3;
        const solver::Obstacle placed = place_obstacle(o, bundle, {-10, 0, 0});
        double nearest = 1e30;
        for (const Vec3f p : bundle.rest_positions) {
            nearest = std::min(nearest, nearest_surface(placed, Vec3{p.x, p.y, p.z}).distance);
        }
        EXPECT_NEAR(nearest, 0.3, 1e-4);
        EXPECT_LT(placed.position.x, 0);  // in front of a body that moves to -x
    }
}

TEST(Scene, OnlyTheDirectionOfAPlanesAxisCounts) {
    const Bundle bundle = bar();
    SceneObstacle o;
    o.gap_m = 0.3;
    o.axis = {-1, 0, 0};
    const solver::Obstacle placed = place_obstacle(o, bundle, {10, 0, 0});
    for (const double length : {1e-300, 3.0, 1e6, 1e30, 1e300}) {
        o.axis = {-length, 0, 0};
        const solver::Obstacle other = place_obstacle(o, bundle, {10, 0, 0});
        EXPECT_EQ(other.axis, placed.axis) << length;
        EXPECT_EQ(other.position, placed.position) << length;
    }
}

TEST(Scene, AHandleTakesTheNodesOfItsBox) {
    SceneHandle h;
    h.box_low = {0.9, -1, -1};
    h.times_s = {0, 1};
    h.shift_m = {{0, 0, 0}, {1, 0, 0}};
    const PlacedHandle placed(h, bar());
    EXPECT_EQ(placed.nodes.size(), 9u);
    EXPECT_EQ(placed.handle.pivot, (Vec3f{2, 0.5f, 0.5f}));
    EXPECT_FLOAT_EQ(solver::value_at(placed.handle.shift, 0.5f).x, 0.5f);
}

}
