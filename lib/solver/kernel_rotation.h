// SPDX-License-Identifier: MIT
// The rotation of rotation_apd.cpp (papers there), as many elements at a time as there are lanes.
// Included once per instruction set, with CRUMPLE_LANES naming its namespace.
#pragma once

namespace crumple::solver::CRUMPLE_LANES {

struct Rotor {
    Lanes x, y, z, w;
};

inline Rotor select(Mask m, const Rotor& a, const Rotor& b) {
    return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z), select(m, a.w, b.w)};
}

inline Rotor load_rotor(const float (*q)[16], int lane) {
    return {Lanes::load(q[0] + lane), Lanes::load(q[1] + lane), Lanes::load(q[2] + lane), Lanes::load(q[3] + lane)};
}

inline void store_rotor(const Rotor& q, float (*to)[16], int lane) {
    q.x.store(to[0] + lane);
    q.y.store(to[1] + lane);
    q.z.store(to[2] + lane);
    q.w.store(to[3] + lane);
}

inline void to_matrix(const Rotor& q, Lanes (&r)[9]) {
    const Lanes one = Lanes::all(1);
    const Lanes x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
    const Lanes xx = x2 * q.x, yy = y2 * q.y, zz = z2 * q.z;
    const Lanes wx = x2 * q.w, wy = y2 * q.w, wz = z2 * q.w;
    r[0] = one - (yy + zz);
    r[1] = fnma(z2, q.w, x2 * q.y);
    r[2] = fma(x2, q.z, wy);
    r[3] = fma(x2, q.y, wz);
    r[4] = one - (xx + zz);
    r[5] = fnma(x2, q.w, y2 * q.z);
    r[6] = fnma(y2, q.w, x2 * q.z);
    r[7] = fma(y2, q.z, wx);
    r[8] = one - (xx + yy);
}

// a^T b, row-major.
inline void transposed_times(const Lanes (&a)[9], const Lanes (&b)[9], Lanes (&c)[9]) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) c[3 * i + j] = fma(a[i], b[j], fma(a[3 + i], b[3 + j], a[6 + i] * b[6 + j]));
    }
}

inline Lanes dot3(Lanes ax, Lanes ay, Lanes az, Lanes bx, Lanes by, Lanes bz) {
    return fma(ax, bx, fma(ay, by, az * bz));
}

inline Lanes determinant(const Lanes (&f)[9]) {
    return dot3(f[0], f[1], f[2], fnma(f[5], f[7], f[4] * f[8]), fnma(f[3], f[8], f[5] * f[6]),
                fnma(f[4], f[6], f[3] * f[7]));
}

inline Lanes squared_norm(const Lanes (&f)[9]) {
    Lanes sum = f[0] * f[0];
    for (int i = 1; i < 9; ++i) sum = fma(f[i], f[i], sum);
    return sum;
}

inline Rotor normalized(const Rotor& q) {
    const Lanes scale = Lanes::all(1) / root(fma(q.x, q.x, fma(q.y, q.y, fma(q.z, q.z, q.w * q.w))));
    return {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
}

// Of the trace: what a step leaves of it is its square or less.
inline constexpr float nearly_symmetric = 2e-3f;
inline constexpr int polish_steps = 3;  // after a cold start

inline constexpr unsigned everyone = (1u << Lanes::width) - 1;

struct NewtonStep {
    Rotor q;
    // R^T F was nearly symmetric before the step, so that a step that squares the error arrives, and no turn makes its
    // trace larger: H is positive definite, which tells the nearest rotation from the other places where the skew part
    // vanishes. False for what is not finite.
    Mask arrives;
};

// REQUIRES: ff = |F|^2 inside the bounds below, so that nothing overflows.
inline NewtonStep newton_step(const Lanes (&f)[9], Lanes ff, const Rotor& q) {
    Lanes r[9], b[9];
    to_matrix(q, r);
    transposed_times(r, f, b);
    const Lanes zero = Lanes::all(0);
    const Lanes gx = b[5] - b[7], gy = b[6] - b[2], gz = b[1] - b[3];
    // H = tr(B) I - sym(B), symmetric: diagonal (a, e, i), the rest (d, c, h) for (01, 02, 12).
    const Lanes half = Lanes::all(-0.5f);
    const Lanes a = b[4] + b[8], e = b[0] + b[8], i = b[0] + b[4];
    const Lanes d = (b[1] + b[3]) * half, c = (b[2] + b[6]) * half, h = (b[5] + b[7]) * half;
    const Lanes ca = fnma(h, h, e * i), cd = fnma(d, i, c * h), cc = fnma(c, e, d * h);
    const Lanes ce = fnma(c, c, a * i), ch = fnma(a, h, c * d), ci = fnma(d, d, a * e);
    const Lanes det = dot3(a, d, c, ca, cd, cc);
    // omega = n / under
    Lanes nx = dot3(ca, cd, cc, gx, gy, gz);
    Lanes ny = dot3(cd, ce, ch, gx, gy, gz);
    Lanes nz = dot3(cc, ch, ci, gx, gy, gz);
    const Lanes limit = (b[0] + e + b[4]) * Lanes::all(nearly_symmetric);
    const Mask arrives =
        (dot3(gx, gy, gz, gx, gy, gz) <= limit * limit) & (limit > zero) & (a > zero) & (ci > zero) & (det > zero);
    // Where H is singular or the step would climb, go down the gradient instead.
    const Mask is_good = (det * det > Lanes::all(1e-14f) * ff * ff * ff) & (zero <= dot3(nx, ny, nz, gx, gy, gz) * det);
    Lanes under = det * Lanes::all(-4);
    if (bits(is_good) != everyone) {
        nx = select(is_good, nx, zero - gx);
        ny = select(is_good, ny, zero - gy);
        nz = select(is_good, nz, zero - gz);
        under = select(is_good, under, Lanes::all(8) * root(ff));
    }
    // q (1 - w.w, 2 w) / (1 + w.w) over under^2, which keeps the length; the other factor takes off what rounding does
    // to it.
    const Lanes nn = dot3(nx, ny, nz, nx, ny, nz);
    const Lanes qq = fma(q.w, q.w, dot3(q.x, q.y, q.z, q.x, q.y, q.z));
    const Lanes scale = fma(Lanes::all(-0.5f), qq, Lanes::all(1.5f)) / fma(under, under, nn);
    const Lanes s = fnma(nn, scale, under * under * scale);
    const Lanes twice = (under + under) * scale;
    nx = nx * twice;
    ny = ny * twice;
    nz = nz * twice;
    return {{fma(q.w, nx, fma(q.x, s, fnma(q.z, ny, q.y * nz))), fma(q.w, ny, fma(q.y, s, fnma(q.x, nz, q.z * nx))),
             fma(q.w, nz, fma(q.z, s, fnma(q.y, nx, q.x * ny))),
             fma(q.w, s, fnma(q.x, nx, fnma(q.y, ny, zero - q.z * nz)))},
            arrives};
}

// The 2 x 2 minors of two rows of a 4 x 4 matrix, columns 01 02 03 12 13 23.
struct Minors {
    Lanes m01, m02, m03, m12, m13, m23;
};
inline Minors minors(const Lanes (&a)[4], const Lanes (&b)[4]) {
    const auto two = [&](int i, int j) { return fnma(a[j], b[i], a[i] * b[j]); };
    return {two(0, 1), two(0, 2), two(0, 3), two(1, 2), two(1, 3), two(2, 3)};
}

inline Lanes three(Lanes a, Lanes p, Lanes b, Lanes q, Lanes c, Lanes r) { return fma(a, p, fnma(b, q, c * r)); }

// Keeps the column of the adjugate with the largest diagonal.
inline void keep_larger(Lanes& best, Rotor& q, Lanes diagonal, const Rotor& candidate) {
    const Mask is_larger = abs(diagonal) > best;
    best = select(is_larger, abs(diagonal), best);
    q = select(is_larger, candidate, q);
}

// An eigenvector of the symmetric k (ordered w x y z) to an eigenvalue that was taken off its diagonal.
inline Rotor largest_adjugate_column(const Lanes (&k)[4][4]) {
    const Lanes zero = Lanes::all(0);
    const Minors s = minors(k[0], k[1]);
    const Minors c = minors(k[2], k[3]);
    const Lanes a00 = three(k[1][1], c.m23, k[1][2], c.m13, k[1][3], c.m12);
    const Lanes a01 = zero - three(k[0][1], c.m23, k[0][2], c.m13, k[0][3], c.m12);
    const Lanes a02 = three(k[3][1], s.m23, k[3][2], s.m13, k[3][3], s.m12);
    const Lanes a03 = zero - three(k[2][1], s.m23, k[2][2], s.m13, k[2][3], s.m12);
    const Lanes a11 = three(k[0][0], c.m23, k[0][2], c.m03, k[0][3], c.m02);
    const Lanes a12 = zero - three(k[3][0], s.m23, k[3][2], s.m03, k[3][3], s.m02);
    const Lanes a13 = three(k[2][0], s.m23, k[2][2], s.m03, k[2][3], s.m02);
    const Lanes a22 = three(k[3][0], s.m13, k[3][1], s.m03, k[3][3], s.m01);
    const Lanes a23 = zero - three(k[2][0], s.m13, k[2][1], s.m03, k[2][3], s.m01);
    const Lanes a33 = three(k[2][0], s.m12, k[2][1], s.m02, k[2][2], s.m01);
    Lanes best = abs(a00);
    Rotor q = {a01, a02, a03, a00};
    keep_larger(best, q, a11, {a11, a12, a13, a01});
    keep_larger(best, q, a22, {a12, a22, a23, a02});
    keep_larger(best, q, a33, {a13, a23, a33, a03});
    return q;
}

// REQUIRES: |F| = 1.
inline Rotor cold_start(const Lanes (&f)[9]) {
    const Lanes xy = f[7] - f[5], yz = f[2] - f[6], zx = f[3] - f[1];
    const Lanes pxy = f[1] + f[3], pxz = f[2] + f[6], pyz = f[5] + f[7];
    Lanes k[4][4] = {{f[0] + f[4] + f[8], xy, yz, zx},
                     {xy, f[0] - f[4] - f[8], pxy, pxz},
                     {yz, pxy, f[4] - f[0] - f[8], pyz},
                     {zx, pxz, pyz, f[8] - f[0] - f[4]}};
    const Minors s = minors(k[0], k[1]);
    const Minors c = minors(k[2], k[3]);
    const Lanes c0 =
        fma(s.m01, c.m23, fnma(s.m02, c.m13, fma(s.m03, c.m12, fma(s.m12, c.m03, fnma(s.m13, c.m02, s.m23 * c.m01)))));
    const Lanes c1 = Lanes::all(-8) * determinant(f);
    Lanes largest = Lanes::all(1.7320508f);
    for (int i = 0; i < 8; ++i) {
        const Lanes r2 = largest * largest;
        const Lanes slope = fma(Lanes::all(4) * largest, r2 - Lanes::all(1), c1);
        const Lanes value = fma(r2 - Lanes::all(2), r2, fma(c1, largest, c0));
        largest = select(slope > Lanes::all(1e-6f), largest - value / slope, largest);
    }
    for (int i = 0; i < 4; ++i) k[i][i] = k[i][i] - largest;
    return normalized(largest_adjugate_column(k));
}

// Scales the lanes of f to norm 1 (polar factors do not change).
inline void scale_to_one(Lanes (&f)[9], Lanes ff) {
    const Lanes scale = Lanes::all(1) / root(ff);
    for (Lanes& value : f) value = value * scale;
}

// Between these squared norms the sixth power of |F| neither overflows nor vanishes.
inline constexpr float least_squared = 1e-5f;
inline constexpr float largest_squared = 1e5f;

// The rotation nearest to F, from the last one; the last one where F has none.
inline Rotor nearest_rotation(const Lanes (&f_any_size)[9], const Rotor& last) {
    Lanes f[9];
    for (int i = 0; i < 9; ++i) f[i] = f_any_size[i];
    Lanes ff = squared_norm(f);
    if (bits((ff > Lanes::all(least_squared)) & (Lanes::all(largest_squared) > ff)) != everyone) {
        scale_to_one(f, ff);
        ff = Lanes::all(1);
    }
    NewtonStep step = newton_step(f, ff, newton_step(f, ff, last).q);
    if (bits(step.arrives) == everyone) return step.q;
    step = newton_step(f, ff, step.q);
    if (bits(step.arrives) == everyone) return step.q;
    scale_to_one(f, ff);
    Rotor cold = cold_start(f);
    for (int i = 0; i < polish_steps; ++i) cold = newton_step(f, Lanes::all(1), cold).q;
    const Rotor q = select(step.arrives, step.q, cold);
    const Lanes size = dot3(q.x, q.y, q.z, q.x, q.y, q.z) + q.w * q.w;
    return select(size > Lanes::all(0.5f), q, last);  // false for NaN
}

}
