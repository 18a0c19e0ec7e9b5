// SPDX-License-Identifier: MIT
// Gram-Schmidt on the columns of F: cheap, but not the nearest rotation. R^T F is upper triangular rather than
// symmetric, so an element turns itself (ghost torque) and the answer depends on which corner is called 1.
// [Nesme, Payan, Faure 2005, "Efficient, physically plausible finite elements"]
#include "solver/rotation.h"

namespace crumple::solver {

Mat3 rotation_qr(const Mat3& f, const Mat3& last) {
    const Vec3f a = f.column(0);
    const float a_length = length(a);
    const Vec3f x = a / a_length;
    const Vec3f b = f.column(1) - x * dot(x, f.column(1));
    const float b_length = length(b);
    // Negated so that a NaN lands here too.
    if (!(a_length > 0) || !(b_length > 1e-6f * length(f.column(1)))) return last;
    const Vec3f y = b / b_length;
    return Mat3::from_columns(x, y, cross(x, y));
}

}
