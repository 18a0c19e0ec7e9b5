// SPDX-License-Identifier: MIT
// R <- (g R + R^-T / g) / 2 until it stands still, g = sqrt(|R^-T| / |R|)
// [Higham 1986, "Computing the polar decomposition - with applications"]. A mirrored F gives the nearest reflection:
// that is what the method is, and why it needs a treatment of degenerate elements before it.
#include "solver/rotation.h"

namespace crumple::solver {

Mat3 rotation_polar(const Mat3& f, const Mat3& last) {
    constexpr int max_steps = 20;
    const float size = norm(f);
    if (!(size > 0)) return last;
    Mat3 r = f * (1 / size);
    for (int step = 0; step < max_steps; ++step) {
        const float det = determinant(r);
        if (!(std::fabs(det) > 1e-18f)) return last;
        const Mat3 inverse_transposed = cofactor(r) * (1 / det);
        const float g = std::sqrt(norm(inverse_transposed) / norm(r));
        const Mat3 next = (r * g + inverse_transposed * (1 / g)) * 0.5f;
        const float change = norm(next - r);
        r = next;
        if (!(change > 1e-6f)) break;
    }
    return std::isfinite(norm(r)) ? r : last;
}

}
