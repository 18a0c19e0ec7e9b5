// SPDX-License-Identifier: MIT
// Rigid frames carried by clusters of nodes: where a light, a door or a number plate is now, how bent its surroundings
// are, and triggers for effects.
#pragma once
#include "solver/carrier.h"
#include "solver/step.h"

namespace crumple::solver {

// A bundle's sensor (see bundle.h). K nodes.
struct SensorView {
    std::span<const Index> node;    // K
    std::span<const float> weight;  // K, sum 1
    Vec3f rest_origin;
    std::array<float, 9> rest_axes{};  // rotation, row-major
};
[[nodiscard]] SensorView view_of(const BundleSensor& sensor);
[[nodiscard]] const char* first_problem(const SensorView& view, std::size_t node_count);

// What a sensor remembers between readings; the caller keeps it.
struct SensorMemory {
    Quaternion turn;      // of the last reading
    Vec3 world_velocity;  // m/s
    bool has_read = false;
    bool is_triggered = false;
};

struct SensorReading {
    Quaternion orientation;  // of the sensor's axes in the carrier's frame: never mirrored
    Vec3f origin;            // m
    Vec3f velocity;          // m/s, mean of its nodes, in the carrier's frame
    // m/s^2, mean of its nodes since the last reading, against the world and along the carrier's axes: the carrier's
    // own acceleration and turning are in it, so a locked cluster feels the crash too. Gravity is not taken out: 0 at
    // rest.
    Vec3f acceleration;
    float deformation = 0;     // |A - R| of the cluster's best linear map A: 0 while it moves rigidly
    float plastic_strain = 0;  // the largest in the tets around its nodes
};

// Turn and place of the cluster [Mueller et al. 2005, "Meshless deformations based on shape matching"]:
//     A_pq = sum w (x - c)(X - C)^T,  R its rotation, found from the last reading's. `dt` is the time since then.
// `carrier` is the frame as it is now: one that gave way has taken the load of the step. Only its orientation and
// velocities are used, and only for the acceleration.
SensorReading read_sensor(const Model& model, const State& state, const SensorView& sensor, SensorMemory& memory,
                          float dt, const CarrierMotion& carrier = {}) noexcept;

// On when the value reaches `on`, off when it falls below `off`, as it was in between. True when it just went on.
bool trigger(SensorMemory& memory, float value, float on, float off) noexcept;

}
