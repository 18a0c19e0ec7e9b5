// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bake/grid_input.h"
#include "core/error.h"

using namespace crumple;
using bake::SensorBy;
using bake::SensorParams;

namespace {

bake::Result bake_sensor(const SensorParams& sensor, test::BakeInput input = test::grid_input(4, 0)) {
    bake::Params params;
    params.sensors = {sensor};
    return test::bake_input(input, params);
}

SensorParams box_sensor(Vec3 low, Vec3 high) { return {"probe", SensorBy::box, low, high, "", {}, 0.01}; }

}

TEST(Sensors, OneThatFindsNoNodeIsLeftOutWithAFinding) {
    const bake::Result result = bake_sensor(box_sensor({5, 5, 5}, {6, 6, 6}));
    EXPECT_TRUE(result.bundle.sensors.empty());
    ASSERT_EQ(result.report.findings.size(), 1u);
    EXPECT_EQ(result.report.findings[0].code, "SENSOR_EMPTY");
}

TEST(Sensors, TheFindingSaysWhyNothingFits) {
    const auto message = [](const SensorParams& sensor) { return bake_sensor(sensor).report.findings.at(0).message; };
    EXPECT_EQ(message(box_sensor({5, 5, 5}, {6, 6, 6})),
              "sensor 'probe' is left out: no node lies in its box; widen it");
    EXPECT_EQ(message({"a", SensorBy::component, {}, {}, "wheel", {}, 0}),
              "sensor 'a' is left out: the shell has no component 'wheel'");
    EXPECT_EQ(message({"b", SensorBy::color, {}, {}, "", {0, 1, 0}, 0}),
              "sensor 'b' is left out: the shell has no colours");
}

TEST(Sensors, NodesOnALineAreAFinding) {
    const bake::Result result = bake_sensor(box_sensor({0, 1, 0}, {1, 1, 0}));
    ASSERT_EQ(result.bundle.sensors.size(), 1u);
    EXPECT_EQ(result.bundle.sensors[0].node.size(), 5u);
    ASSERT_EQ(result.report.findings.size(), 1u);
    EXPECT_EQ(result.report.findings[0].code, "SENSOR_STRAIGHT");
}

TEST(Sensors, ABoxAroundAllSitsAtTheCentreOfMass) {
    const bake::Result result = bake_sensor(box_sensor({0, 0, 0}, {1, 1, 1}));
    EXPECT_TRUE(result.report.findings.empty());
    const BundleSensor& sensor = result.bundle.sensors[0];
    EXPECT_EQ(sensor.node.size(), result.bundle.rest_positions.size());
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(sensor.rest_origin[axis], 0.5, 1e-6);
    EXPECT_EQ(sensor.rest_axes, (std::array<float, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
}

TEST(Sensors, AComponentBringsItsVerticesAndTheNodesInside) {
    test::BakeInput input = test::grid_input(4, 0);
    input.asset.shell.components.push_back({"block", "", Role::rigid, "", 1, true, false, 0});
    input.mesh.region.assign(input.mesh.tets.size(), 0);
    input.mesh.region[7] = 1;
    input.asset.shell.component[0] = 1;
    const bake::Result result = bake_sensor({"block", SensorBy::component, {}, {}, "block", {}, 0.01}, input);
    std::vector<Index> expected(input.mesh.tets[7].begin(), input.mesh.tets[7].end());
    expected.push_back(0);
    for (Index& node : expected) node = result.bundle.mesh_to_node[node];
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    EXPECT_EQ(result.bundle.sensors.at(0).node, expected);
}

TEST(Sensors, AColourChoosesThePaintedVertices) {
    test::BakeInput input = test::grid_input(4, 0);
    input.asset.shell.color.assign(input.asset.shell.positions.size(), {1, 1, 1, 1});
    for (const Index vertex : {3u, 10u, 20u, 30u}) input.asset.shell.color[vertex] = {1, 0.505f, 0, 1};
    const bake::Result result = bake_sensor({"horn", SensorBy::color, {}, {}, "", {1, 0.5, 0}, 0.01}, input);
    EXPECT_EQ(result.bundle.sensors.at(0).node.size(), 4u);
    input.asset.shell.color.clear();
    EXPECT_TRUE(bake_sensor({"horn", SensorBy::color, {}, {}, "", {1, 0.5, 0}, 0.01}, input).bundle.sensors.empty());
}

TEST(Sensors, NamesMustBeTheirOwn) {
    bake::Params params;
    params.sensors = {box_sensor({0, 0, 0}, {1, 1, 1}), box_sensor({0, 0, 0}, {1, 1, 1})};
    EXPECT_THROW((void)test::bake_input(test::grid_input(1), params), Error);
    params.sensors = {SensorParams{}};
    EXPECT_THROW((void)test::bake_input(test::grid_input(1), params), Error);
}
