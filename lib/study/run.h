// SPDX-License-Identifier: GPL-3.0-or-later
// What a simulation tells: how the body was at each frame, and what became of it.
#pragma once
#include <cstdint>
#include <vector>

#include "core/finding.h"
#include "core/vec3.h"
#include "solver/mat3.h"

namespace crumple::study {

struct SensorFrame {
    solver::Quaternion orientation;  // in the world
    Vec3 origin;
    float deformation = 0;
    float plastic_strain = 0;
    float acceleration = 0;  // m/s^2, in the world, mean since the frame before
};

// At a time; everything in the world, in doubles rounded to float around the body's start.
struct Frame {
    double time_s = 0;
    std::vector<Vec3f> nodes;                  // N
    std::vector<std::vector<Vec3f>> vertices;  // one list a visual mesh
    std::vector<float> plastic_strain;         // T: norm; 0 where not simulated
    std::vector<SensorFrame> sensors;
    double kinetic_j = 0;  // relative to the carrier
    double elastic_j = 0;
    std::uint32_t iterations = 0;
    std::uint32_t contacts = 0;
    std::uint32_t inverted = 0;  // tets with det F <= 0
    bool is_asleep = false;
};

struct StepTimes {
    double median_ms = 0;
    double p99_ms = 0;
    double longest_ms = 0;
};

struct Run {
    std::vector<Frame> frames;
    // Largest way of a locked node from its place in the carrier's frame, over the body's size.
    double locked_drift = 0;
    // Largest way of a node from its place at the end: in the carrier's frame, or that of the whole where nothing is
    // locked.
    double deepest_dent_m = 0;
    std::uint32_t inverted_at_end = 0;
    std::uint32_t driven_inside_out = 0;  // of these, without a free node: handles cross each other or locked nodes
    std::uint32_t steps = 0;
    std::uint32_t warned_steps = 0;
    StepTimes times;  // of steps awake, without drawing; no part of any file
    std::vector<Finding> findings;
};

}
