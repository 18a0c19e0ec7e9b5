// SPDX-License-Identifier: GPL-3.0-or-later
// The truth the runtime solver is tested against: the same equations in double, a direct solve in place of iterations,
// the matrix scattered element by element through the bundle's slots, written to be read. Slow on purpose.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "bundle/bundle.h"

namespace crumple::reference {

using Matrix3 = std::array<double, 9>;  // row-major

struct Body {
    const Bundle* bundle = nullptr;  // outlives the body
    std::vector<Vec3> positions;     // N
    std::vector<Vec3> velocities;    // N
    std::vector<Matrix3> rotations;  // S: as of the last step
    std::vector<Matrix3> plastic;    // S: plastic strain, symmetric
};

[[nodiscard]] Body body_at_rest(const Bundle& bundle);

// A node that is not free; locked nodes are fixed at velocity 0 unless listed.
struct Prescribed {
    Index node;
    Vec3 velocity;
};

struct StepInput {
    double dt = 1.0 / 60;
    Vec3 gravity;
    std::span<const Vec3> forces;  // N or empty, newtons
    std::span<const Prescribed> prescribed;
    bool has_plasticity = false;  // additive, without hardening
    bool is_linear = false;       // R = I: linear elasticity, for comparison
};

// Advances the body and returns the reactions at nodes that are not free, newtons (N, zero elsewhere).
std::vector<Vec3> step(Body& body, const StepInput& input);

// Moves the body to static equilibrium under the forces (Newton steps with R frozen); locked nodes stay where they are.
// Done when a step is this small beside the whole way from rest. Returns the steps taken, nothing when it did not end.
std::optional<int> settle(Body& body, std::span<const Vec3> forces, double relative_tolerance = 1e-9,
                          bool is_linear = false);

// The same for Green's strain and its conjugate stress (Saint Venant-Kirchhoff) instead of corotated strain: what other
// programs mean by large displacements. The load comes in equal parts, each settled by Newton's method.
[[nodiscard]] std::optional<int> settle_by_green(Body& body, std::span<const Vec3> forces,
                                                 double relative_tolerance = 1e-9, int load_steps = 10);

// The rotation nearest to F (row-major), the sign on the smallest singular value.
[[nodiscard]] Matrix3 nearest_rotation(const Matrix3& f);

[[nodiscard]] Matrix3 deformation_gradient(const Body& body, std::size_t tet);

// Elastic forces at the present positions with nearest rotations (N).
[[nodiscard]] std::vector<Vec3> elastic_forces(const Body& body);

// sum of V R K R^T over the tets, each scaled by scale_of_tet, at 9 doubles (column-major) per block of the bundle.
[[nodiscard]] std::vector<double> stiffness_by_slots(const Bundle& bundle, std::span<const Matrix3> rotations,
                                                     std::span<const double> scale_of_tet);

}
