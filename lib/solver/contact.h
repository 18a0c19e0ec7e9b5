// SPDX-License-Identifier: MIT
// Contact of nodes with solid things that move as they please. A node that would go through a surface in this step gets
// a constraint for this step: along the normal n it leaves at least with v' = -k_r v_n where it comes in faster than
// `rebound_from`, else it stops at the surface; along the surface it is free [Shapira 2009]. Contacts push and never
// pull: one that the rest of the body keeps from getting there lets go while the step is solved.
#pragma once
#include "solver/carrier.h"
#include "solver/step.h"

namespace crumple::solver {

enum class ObstacleShape : std::uint8_t {
    plane,    // solid on the side away from `axis`
    capsule,  // from position - axis to position + axis, `radius` thick; a sphere when axis is 0
    box,      // half its edges in `axis`, turned by `orientation`, rounded by `radius`
};

// In the world.
struct Obstacle {
    ObstacleShape shape = ObstacleShape::plane;
    Vec3 position;
    Vec3 axis{0, 1, 0};
    double radius = 0;
    Quaternion orientation;
    Vec3 velocity;
    Vec3 angular_velocity;
    float restitution = 0;  // k_r, 0 to 1
};

inline constexpr float rebound_from = 0.5f;   // m/s: slower contact rests
inline constexpr float push_out_part = 0.2f;  // of the depth, a step
inline constexpr float push_out_speed = 2;    // m/s, at most

// Signed distance of a point of the world to the surface, negative inside, and the normal out of the solid there.
struct SurfacePoint {
    double distance;
    Vec3 normal;
};
[[nodiscard]] SurfacePoint nearest_surface(const Obstacle& obstacle, Vec3 point);

struct ContactCounts {
    std::size_t found = 0;
    std::size_t written = 0;  // less where `room` was too small
};

// Writes a contact constraint, in the frame, for every node in contact that is not locked and whose `is_taken` (N) is
// 0, and sets that. Of several obstacles the deepest counts. Where an obstacle comes through a boundary face between
// its nodes, at the middle of the face or of an edge, the nodes there are held as if they touched. `pull` is gravity in
// the frame; `clearance` (N) is to work with.
ContactCounts find_contacts(const Model& model, const State& state, const Frame& frame,
                            std::span<const Obstacle> obstacles, Vec3f pull, float dt, std::span<std::uint8_t> is_taken,
                            std::span<float> clearance, std::span<Constraint> room);

// A blow: momentum at a place of the body.
struct Hit {
    Vec3 position;  // world
    Vec3 momentum;  // N s, world
};

// Gives the momentum to the corners of the nearest tet around the nearest node, by the weights of the place in it,
// which keeps the angular momentum too; what falls on locked corners is the carrier's alone. Point and momentum in the
// frame.
void strike(const Model& model, State& state, Vec3f point, Vec3f momentum);

}
