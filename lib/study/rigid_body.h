// SPDX-License-Identifier: GPL-3.0-or-later
// The simplest thing a game's physics could be: one rigid body, semi-implicit Euler.
#pragma once
#include "bundle/bundle.h"
#include "solver/carrier.h"

namespace crumple::study {

class RigidBody {
public:
    // With the mass and inertia of the whole bundle, its frame that of the bundle's positions, moving as given.
    RigidBody(const Bundle& bundle, Vec3 velocity, Vec3 angular_velocity);

    // Of the frame, whose origin need not be the centre of mass.
    [[nodiscard]] solver::CarrierMotion motion() const;
    void step(const solver::CarrierLoad& load, Vec3 gravity, double dt);

private:
    [[nodiscard]] Vec3 arm() const;  // from the frame's origin to the centre of mass, in the world

    double mass_ = 0;
    Vec3 centre_;            // of mass, in the frame
    solver::Mat3d inertia_;  // about it, in the frame
    Vec3 position_;          // of the centre of mass
    Vec3 velocity_;
    Vec3 spin_;  // angular momentum
    solver::Quaternion orientation_;
    Vec3 angular_velocity_;
};

}
