// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/rigid_body.h"

#include <cmath>

namespace crumple::study {
namespace {

using solver::Mat3d;

Mat3d rotation_of(solver::Quaternion q) {
    const solver::Mat3 narrow = to_matrix(q);
    Mat3d wide;
    for (std::size_t i = 0; i < 9; ++i) wide.m[i] = narrow.m[i];
    return wide;
}

Mat3d inverse(const Mat3d& a) { return transpose(cofactor(a)) * (1 / determinant(a)); }

}

RigidBody::RigidBody(const Bundle& bundle, Vec3 velocity, Vec3 angular_velocity) : angular_velocity_(angular_velocity) {
    for (std::size_t i = 0; i < bundle.mass.size(); ++i) {
        const double m = bundle.mass[i];
        mass_ += m;
        centre_ += widen(bundle.rest_positions[i]) * m;
    }
    centre_ = centre_ / mass_;
    for (std::size_t i = 0; i < bundle.mass.size(); ++i) {
        const Vec3 r = widen(bundle.rest_positions[i]) - centre_;
        const double m = bundle.mass[i];
        inertia_ = inertia_ + (Mat3d::identity() * dot(r, r) - solver::outer(r, r)) * m;
    }
    position_ = centre_;
    velocity_ = velocity;
    spin_ = inertia_ * angular_velocity;
}

Vec3 RigidBody::arm() const { return rotation_of(orientation_) * centre_; }

solver::CarrierMotion RigidBody::motion() const {
    solver::CarrierMotion m;
    m.position = position_ - arm();
    m.orientation = orientation_;
    m.velocity = velocity_ - cross(angular_velocity_, arm());
    m.angular_velocity = angular_velocity_;
    return m;
}

// Velocities first: the solver counts on it, for where a node goes is its new velocity plus that of the frame.
void RigidBody::step(const solver::CarrierLoad& load, Vec3 gravity, double dt) {
    spin_ += (load.torque - cross(arm(), load.force)) * dt;
    velocity_ += (load.force / mass_ + gravity) * dt;
    const Mat3d before = rotation_of(orientation_);
    angular_velocity_ = inverse(before * inertia_ * transpose(before)) * spin_;
    position_ += velocity_ * dt;
    const double angle = length(angular_velocity_) * dt;
    if (angle > 0) {
        const Vec3 n = angular_velocity_ * (std::sin(angle / 2) * dt / angle);
        const solver::Quaternion by{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z),
                                    static_cast<float>(std::cos(angle / 2))};
        orientation_ = solver::to_quaternion(to_matrix(by) * to_matrix(orientation_));
    }
    const Mat3d turn = rotation_of(orientation_);
    angular_velocity_ = inverse(turn * inertia_ * transpose(turn)) * spin_;
}

}
