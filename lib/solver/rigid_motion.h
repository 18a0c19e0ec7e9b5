// SPDX-License-Identifier: MIT
// Motions of rigid bodies, and of what is to move like one, as six numbers: a velocity and an angular velocity about
// the frame's origin, or the force and torque that belong to them.
#pragma once
#include <array>

#include "solver/mat3.h"

namespace crumple::solver {

using Six = std::array<double, 6>;
using Matrix6 = std::array<double, 36>;  // row-major

[[nodiscard]] inline Vec3 linear_part(const Six& v) { return {v[0], v[1], v[2]}; }
[[nodiscard]] inline Vec3 angular_part(const Six& v) { return {v[3], v[4], v[5]}; }

[[nodiscard]] inline double dot6(const Six& a, const Six& b) {
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
    return sum;
}

// a += s b
inline void add_to(Six& a, double s, const Six& b) {
    for (std::size_t i = 0; i < 6; ++i) a[i] += s * b[i];
}

[[nodiscard]] inline Vec3 rigid_velocity(const Six& v, Vec3 x) { return linear_part(v) + cross(angular_part(v), x); }

// A push at x: its force and its torque.
[[nodiscard]] inline Six push_at(Vec3 x, Vec3 push) {
    const Vec3 torque = cross(x, push);
    return {push.x, push.y, push.z, torque.x, torque.y, torque.z};
}

[[nodiscard]] Six times(const Matrix6& m, const Six& v);

// Sum of B_j T_j over some j, with T = [I, -[x]], the velocity at x that a motion has.
struct RowMotion {
    Mat3d blocks;  // sum of B_j
    Mat3d turned;  // sum of B_j [x_j]
    void add(const Mat3d& b, Vec3 x);
};

// m += s T^T (row), T at x.
void add_row(Matrix6& m, Vec3 x, const RowMotion& row, double s);

// Points of mass as one rigid body.
class PointMasses {
public:
    void add(double mass, Vec3 x) {
        mass_ += mass;
        first_ += x * mass;
        squares_ += Vec3{x.x * x.x, x.y * x.y, x.z * x.z} * mass;
        products_ += Vec3{x.y * x.z, x.z * x.x, x.x * x.y} * mass;
    }
    [[nodiscard]] double mass() const { return mass_; }
    [[nodiscard]] Vec3 centre() const { return first_ / mass_; }
    [[nodiscard]] Matrix6 matrix() const;  // sum of m T^T T

private:
    double mass_ = 0;
    Vec3 first_, squares_, products_;
};

// Of a matrix whose symmetric part is positive definite; all zeros where a pivot tells that it is not. A point or a
// line turns freely about itself: `floor` of the largest entry is added to the diagonal.
[[nodiscard]] Matrix6 inverse_of(Matrix6 m, double floor);

}
