// SPDX-License-Identifier: MIT
// The default: two or three Newton steps from the last rotation, and where those do not arrive, the quartic that needs
// no history. Always the nearest rotation, for mirrored F as well.
// - warm: analytic polar decomposition, a Newton step on the rotation followed by a Cayley map
//   [Kugelstadt, Koschier, Bender 2018, "Fast corotated FEM using operator splitting"].
// - cold: the largest eigenvalue of the quaternion form q^T K q of tr(R^T F) [Horn 1987, "Closed-form solution of
//   absolute orientation using unit quaternions"], as the largest root of its characteristic quartic.
// The lanes of kernel_rotation.h do the same arithmetic.
#include "solver/rotation.h"

namespace crumple::solver {
namespace {

constexpr int warm_steps = 3;
constexpr int cold_steps = 8;
constexpr int polish_steps = 3;

// A step squares the skew part of R^T F over its trace, so from here it arrives.
constexpr float nearly_symmetric = 2e-3f;

Quaternion product(Quaternion a, Quaternion b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

Quaternion normalized(Quaternion q) {
    const float scale = 1 / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
}

// Twice the axial vector of the skew part: 0 where B is symmetric.
Vec3f skew_part(const Mat3& b) { return {b(1, 2) - b(2, 1), b(2, 0) - b(0, 2), b(0, 1) - b(1, 0)}; }

// REQUIRES: |F| = 1, so that the small numbers below are relative.
Quaternion newton_step(const Mat3& f, Quaternion q) {
    const Mat3 b = transpose(to_matrix(q)) * f;
    const Vec3f g = skew_part(b);
    const Mat3 h = Mat3::identity() * trace(b) - (b + transpose(b)) * 0.5f;
    const float det = determinant(h);
    // |w| = tan(turn / 4). Where H is singular or the step would climb, go down the gradient instead.
    Vec3f w = cofactor(h) * g * (-0.25f / det);
    if (!(std::fabs(det) > 1e-7f) || dot(w, g) > 0) w = g * -0.125f;
    const float ww = dot(w, w);
    return normalized(product(q, {2 * w.x, 2 * w.y, 2 * w.z, 1 - ww}));
}

// Symmetric R^T F is not enough: half a turn about a principal axis has that too. Only at the nearest rotation is H
// positive definite.
bool will_arrive(const Mat3& f, Quaternion q) {
    const Mat3 b = transpose(to_matrix(q)) * f;
    const Mat3 h = Mat3::identity() * trace(b) - (b + transpose(b)) * 0.5f;
    const bool is_maximum = h(0, 0) > 0 && h(0, 0) * h(1, 1) > h(0, 1) * h(0, 1) && determinant(h) > 0;
    return is_maximum && length(skew_part(b)) <= nearly_symmetric * trace(b);
}

// Column of adj(K - L I) with the largest diagonal element: an eigenvector of the symmetric 4 x 4 K.
Quaternion largest_adjugate_column(const float (&k)[4][4]) {
    const auto minor3 = [&](int row, int column) {
        Mat3 m;
        for (int r = 0, i = 0; r < 4; ++r) {
            if (r == row) continue;
            for (int c = 0, j = 0; c < 4; ++c) {
                if (c == column) continue;
                m(i, j++) = k[r][c];
            }
            ++i;
        }
        return ((row + column) % 2 ? -1 : 1) * determinant(m);
    };
    int best = 0;
    for (int i = 1; i < 4; ++i) {
        if (std::fabs(minor3(i, i)) > std::fabs(minor3(best, best))) best = i;
    }
    // K is ordered w, x, y, z.
    return {minor3(1, best), minor3(2, best), minor3(3, best), minor3(0, best)};
}

float determinant4(const float (&k)[4][4]) {
    const auto two = [&](int r, int a, int b) { return k[r][a] * k[r + 1][b] - k[r][b] * k[r + 1][a]; };
    return two(0, 0, 1) * two(2, 2, 3) - two(0, 0, 2) * two(2, 1, 3) + two(0, 0, 3) * two(2, 1, 2) +
           two(0, 1, 2) * two(2, 0, 3) - two(0, 1, 3) * two(2, 0, 2) + two(0, 2, 3) * two(2, 0, 1);
}

// REQUIRES: |F| = 1.
Quaternion cold_start(const Mat3& f) {
    float k[4][4] = {{f(0, 0) + f(1, 1) + f(2, 2), f(2, 1) - f(1, 2), f(0, 2) - f(2, 0), f(1, 0) - f(0, 1)},
                     {f(2, 1) - f(1, 2), f(0, 0) - f(1, 1) - f(2, 2), f(0, 1) + f(1, 0), f(0, 2) + f(2, 0)},
                     {f(0, 2) - f(2, 0), f(0, 1) + f(1, 0), f(1, 1) - f(0, 0) - f(2, 2), f(1, 2) + f(2, 1)},
                     {f(1, 0) - f(0, 1), f(0, 2) + f(2, 0), f(1, 2) + f(2, 1), f(2, 2) - f(0, 0) - f(1, 1)}};
    // L^4 - 2 L^2 - 8 det(F) L + det(K) for |F| = 1; its largest root is at most sqrt(3).
    const float c1 = -8 * determinant(f);
    const float c0 = determinant4(k);
    float root = std::sqrt(3.0f);
    for (int i = 0; i < cold_steps; ++i) {
        const float r2 = root * root;
        const float slope = 4 * root * (r2 - 1) + c1;
        if (!(slope > 1e-6f)) break;
        root -= ((r2 - 2) * r2 + c1 * root + c0) / slope;
    }
    for (int i = 0; i < 4; ++i) k[i][i] -= root;
    return largest_adjugate_column(k);
}

}

Mat3 rotation_apd(const Mat3& f_any_size, const Mat3& last) {
    const float size = norm(f_any_size);
    if (!(size > 0) || !std::isfinite(size)) return last;
    const Mat3 f = f_any_size * (1 / size);
    Quaternion q = newton_step(f, to_quaternion(last));
    for (int i = 1; i < warm_steps; ++i) {
        const bool arrives = will_arrive(f, q);
        q = newton_step(f, q);
        if (arrives) return to_matrix(q);
    }
    const Quaternion cold = cold_start(f);
    if (!(cold.x * cold.x + cold.y * cold.y + cold.z * cold.z + cold.w * cold.w > 1e-20f)) return last;
    q = normalized(cold);
    for (int i = 0; i < polish_steps; ++i) q = newton_step(f, q);
    return std::isfinite(q.w) ? to_matrix(q) : last;
}

}
