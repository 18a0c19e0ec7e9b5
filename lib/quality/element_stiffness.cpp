// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/element_stiffness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/index.h"

namespace crumple::quality {

namespace {

using Symmetric3 = std::array<std::array<double, 3>, 3>;

// Zeroes m[p][q] by a rotation [Golub and Van Loan, Matrix Computations, section 8.5].
void rotate(Symmetric3& m, int p, int q) {
    if (m[p][q] == 0) return;
    const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
    const double t = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
    const double c = 1 / std::sqrt(t * t + 1);
    const double s = t * c;
    const int other = 3 - p - q;
    const double to_p = m[other][p];
    const double to_q = m[other][q];
    m[p][p] -= t * m[p][q];
    m[q][q] += t * m[p][q];
    m[p][q] = m[q][p] = 0;
    m[other][p] = m[p][other] = c * to_p - s * to_q;
    m[other][q] = m[q][other] = s * to_p + c * to_q;
}

// Cyclic Jacobi converges quadratically: six sweeps leave nothing of a 3 x 3 matrix's off-diagonal.
std::array<double, 3> eigenvalues(Symmetric3 m) {
    for (int sweep = 0; sweep < 6; ++sweep) {
        rotate(m, 0, 1);
        rotate(m, 0, 2);
        rotate(m, 1, 2);
    }
    return {m[0][0], m[1][1], m[2][2]};
}

// S = sum of g g^T over the gradients g of the four shape functions.
Symmetric3 sum_of_gradient_products(const std::array<Vec3, 4>& corners, double six_volumes) {
    Symmetric3 sum{};
    for (const auto& face : tet_face_corners) {
        const Vec3 first = corners[face[0]];
        const Vec3 gradient = cross(corners[face[2]] - first, corners[face[1]] - first) / six_volumes;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) sum[i][j] += gradient[i] * gradient[j];
        }
    }
    return sum;
}

}

// The nonzero eigenvalues of K = V B^T D B are those of V D B B^T, and B B^T maps a stress s to (S s + s S) / 2. Along
// S's own axes the shear stresses decouple, with smaller eigenvalues than the normal ones, whose 3 x 3 block is 2 mu
// diag(S) + lambda sqrt(S_i S_j).
ElementStiffness measure_stiffness(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const double six_volumes = dot(b - a, cross(c - a, d - a));
    if (!(six_volumes > 0)) return {};
    const std::array<double, 3> axes = eigenvalues(sum_of_gradient_products({a, b, c, d}, six_volumes));
    Symmetric3 normal{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) normal[i][j] = lame_lambda * std::sqrt(std::max(axes[i] * axes[j], 0.0));
        normal[i][i] += 2 * lame_mu * axes[i];
    }
    const std::array<double, 3> values = eigenvalues(normal);
    const double per_volume = *std::max_element(values.begin(), values.end());
    return {per_volume * six_volumes / 6, 1 / std::sqrt(per_volume)};
}

double regular_step(double volume) {
    // Corners of a cube of side s span a regular tet of volume s^3 / 3.
    const double s = std::cbrt(3 * volume);
    return measure_stiffness({0, 0, 0}, {s, 0, s}, {s, s, 0}, {0, s, s}).step;
}

}
