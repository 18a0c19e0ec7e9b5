// SPDX-License-Identifier: MIT
// The rigid body a deforming one rides on. Positions and velocities of the nodes are in its frame, so that a car at
// 100 m/s ten kilometres from the origin deforms like one at rest; locked nodes stand still in it.
#pragma once
#include "solver/mat3.h"

namespace crumple::solver {

// In the world; what the game's rigid body does during this step. `position` is that of the frame's origin.
struct CarrierMotion {
    Vec3 position;           // m
    Quaternion orientation;  // turns the frame's axes into the world's
    Vec3 velocity;           // m/s
    Vec3 angular_velocity;   // rad/s
    Vec3 acceleration;       // m/s^2; this and the next only for inertial forces
    Vec3 angular_acceleration;
};

// What the deforming part does to the rigid body, in the world, the torque about the frame's origin. The rigid body has
// the mass of the whole, as it lies at rest, and bears its weight itself. With P the momentum that the nodes have
// beside it, since they move in the frame and have moved from their places, and J what obstacles, hits and forces gave:
// force dt = J - change of P,  both seen from the world, so no momentum is lost between the two.
struct CarrierLoad {
    Vec3 force;   // N
    Vec3 torque;  // N m
};

// A CarrierMotion with its rotation as a matrix.
class Frame {
public:
    explicit Frame(const CarrierMotion& motion);
    [[nodiscard]] Vec3f point(Vec3 world) const { return narrow(turn_back_ * (world - motion_.position)); }
    [[nodiscard]] Vec3 from_world(Vec3 vector) const { return turn_back_ * vector; }
    [[nodiscard]] Vec3f vector(Vec3 world) const { return narrow(from_world(world)); }
    // The velocity, seen from the frame, of something at a place of the world.
    [[nodiscard]] Vec3f velocity(Vec3 place, Vec3 world) const {
        return vector(world - motion_.velocity - cross(motion_.angular_velocity, place - motion_.position));
    }
    [[nodiscard]] Vec3 to_world(Vec3 vector) const { return turn_ * vector; }
    [[nodiscard]] Vec3 point_to_world(Vec3f point) const {
        return motion_.position + turn_ * Vec3{point.x, point.y, point.z};
    }

private:
    const CarrierMotion& motion_;
    Mat3d turn_;
    Mat3d turn_back_;
};

}
