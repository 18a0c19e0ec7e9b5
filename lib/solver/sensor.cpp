// SPDX-License-Identifier: MIT
#include "solver/sensor.h"

#include <algorithm>
#include <cmath>

#include "solver/measure.h"

namespace crumple::solver {
namespace {

struct Cluster {
    Vec3f centre;
    Vec3f rest_centre;
    Vec3f velocity;
    Mat3 mixed;  // sum w (x - c)(X - C)^T
    Mat3 rest;   // sum w (X - C)(X - C)^T
};

Cluster gather(const Model& model, const State& state, const SensorView& s) {
    Cluster c;
    for (std::size_t i = 0; i < s.node.size(); ++i) {
        c.centre += position(state, s.node[i]) * s.weight[i];
        c.rest_centre += model.bundle.rest_positions[s.node[i]] * s.weight[i];
        c.velocity += velocity(state, s.node[i]) * s.weight[i];
    }
    for (std::size_t i = 0; i < s.node.size(); ++i) {
        const Vec3f p = position(state, s.node[i]) - c.centre;
        const Vec3f q = model.bundle.rest_positions[s.node[i]] - c.rest_centre;
        c.mixed = c.mixed + outer(p, q) * s.weight[i];
        c.rest = c.rest + outer(q, q) * s.weight[i];
    }
    return c;
}

// Clusters in a plane lack a direction, which is the cross product of the others and stands in the cofactors; adding
// these changes no rotation. A cluster on a line turns about itself like the last reading.
Mat3 turn_of(const Cluster& c, const Mat3& last) {
    const float size = trace(c.rest);
    const Mat3 across = cofactor(c.mixed) * (1 / size);
    const bool is_line = !(norm(across) > 1e-6f * norm(c.mixed));
    return rotation_apd(c.mixed + across + (is_line ? last * (1e-5f * size) : Mat3{}), last);
}

// |A - R|, of a cluster made a little thick where it has no extent.
float deformation_of(const Cluster& c, const Mat3& turn) {
    const Mat3 rest = c.rest + Mat3::identity() * (1e-3f * trace(c.rest));
    const float det = determinant(rest);
    return det > 0 ? norm((c.mixed - turn * c.rest) * (transpose(cofactor(rest)) * (1 / det))) : 0;
}

// Its change is all acceleration there is: the carrier's, Euler's, centripetal, Coriolis and the nodes' own.
Vec3 world_velocity(const Cluster& c, const CarrierMotion& carrier, const Frame& frame) {
    const Vec3 arm = frame.to_world(widen(c.centre));
    return carrier.velocity + cross(carrier.angular_velocity, arm) + frame.to_world(widen(c.velocity));
}

float largest_plastic_strain(const Model& model, const State& state, const SensorView& s) {
    float largest = 0;
    for (const Index node : s.node) {
        for (Index k = model.node_start[node]; k < model.node_start[node + 1]; ++k) {
            const std::size_t tet = model.node_corner[k] / 4;
            largest = std::max(largest, plastic_strain(model, state, tet));
        }
    }
    return largest;
}

}

SensorView view_of(const BundleSensor& sensor) {
    return {sensor.node, sensor.weight, sensor.rest_origin, sensor.rest_axes};
}

const char* first_problem(const SensorView& v, std::size_t node_count) {
    if (v.node.empty() || v.node.size() != v.weight.size()) return "sensor: nodes and weights differ in length";
    if (std::any_of(v.node.begin(), v.node.end(), [&](Index n) { return n >= node_count; })) {
        return "sensor: a node does not exist";
    }
    if (!std::all_of(v.weight.begin(), v.weight.end(), [](float w) { return std::isfinite(w) && w >= 0; })) {
        return "sensor: a weight is not a number from 0 on";
    }
    return nullptr;
}

SensorReading read_sensor(const Model& model, const State& state, const SensorView& sensor, SensorMemory& memory,
                          float dt, const CarrierMotion& carrier) noexcept {
    const Cluster c = gather(model, state, sensor);
    const Mat3 turn = turn_of(c, to_matrix(memory.turn));
    SensorReading reading;
    reading.orientation = to_quaternion(turn * Mat3{sensor.rest_axes});
    reading.origin = c.centre + turn * (sensor.rest_origin - c.rest_centre);
    reading.velocity = c.velocity;
    const Frame frame(carrier);
    const Vec3 moving = world_velocity(c, carrier, frame);
    if (memory.has_read && dt > 0) reading.acceleration = frame.vector(moving - memory.world_velocity) / dt;
    reading.deformation = deformation_of(c, turn);
    reading.plastic_strain = largest_plastic_strain(model, state, sensor);
    memory.turn = to_quaternion(turn);
    memory.world_velocity = moving;
    memory.has_read = true;
    return reading;
}

bool trigger(SensorMemory& memory, float value, float on, float off) noexcept {
    const bool was = memory.is_triggered;
    memory.is_triggered = value >= on || (was && value >= off);
    return memory.is_triggered && !was;
}

}
