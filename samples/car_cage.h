// SPDX-License-Identifier: MIT
// The roll cage: joints, and bars from a face of one joint to a face of another. The control shell makes square tubes
// of it, the visual mesh round ones along the same lines.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "samples/model.h"

namespace crumple::samples::car {

struct Joint {
    Vec3 centre;
    bool is_foot;  // stands on the floor: locked
};

// One of the six faces of a joint's cube.
struct Face {
    int axis;
    int side;  // -1 or 1
};

struct Bar {
    std::size_t from, to;  // joints
    Face leaves, arrives;  // through which of their faces
};

inline constexpr double half_bar = 0.048;  // half the width of a square tube

[[nodiscard]] std::span<const Joint> cage_joints();
[[nodiscard]] std::span<const Bar> cage_bars();

// The bar's middle line: joint, face, face, joint.
[[nodiscard]] std::array<Vec3, 4> middle_line(const Bar& bar);

// One closed surface of all joints and bars.
[[nodiscard]] Part cage_shell();

}
