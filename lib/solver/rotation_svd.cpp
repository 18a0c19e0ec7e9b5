// SPDX-License-Identifier: MIT
// R = U V^T from the singular value decomposition; for a mirrored F one singular value must carry the sign:
// - svd_smallest: the smallest one, which gives the nearest rotation [Irving, Teran, Fedkiw 2004, "Invertible finite
//   elements for robust simulation of large deformation"]; jumps where the two smallest cross.
// - svd_last: the one that leaves R nearest to the rotation of the step before.
#include "solver/rotation.h"

namespace crumple::solver {
namespace {

// One-sided Jacobi: turns columns p and q of b (and of v alike) until they are orthogonal [Hestenes 1958].
void orthogonalize(Mat3T<double>& b, Mat3T<double>& v, int p, int q) {
    const double pq = dot(b.column(p), b.column(q));
    if (pq == 0) return;
    const double difference = dot(b.column(q), b.column(q)) - dot(b.column(p), b.column(p));
    const double tau = difference / (2 * pq);
    const double t = (tau >= 0 ? 1 : -1) / (std::fabs(tau) + std::sqrt(1 + tau * tau));
    const double c = 1 / std::sqrt(1 + t * t);
    const double s = t * c;
    for (auto* a : {&b, &v}) {
        const Vec3 old_p = a->column(p);
        const Vec3 old_q = a->column(q);
        a->set_column(p, old_p * c - old_q * s);
        a->set_column(q, old_p * s + old_q * c);
    }
}

void sort_columns(Mat3T<double>& b, Mat3T<double>& v, int p, int q) {
    if (dot(b.column(p), b.column(p)) >= dot(b.column(q), b.column(q))) return;
    for (auto* a : {&b, &v}) {
        const Vec3 old = a->column(p);  // one column changes sign, so the swap stays a rotation
        a->set_column(p, a->column(q));
        a->set_column(q, -old);
    }
}

Vec3 any_orthogonal(Vec3 a) {
    const Vec3 axis = std::fabs(a.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 b = cross(a, axis);
    return b / length(b);
}

template <class To, class From>
Mat3T<To> convert(const Mat3T<From>& a) {
    Mat3T<To> result;
    for (std::size_t i = 0; i < 9; ++i) result.m[i] = static_cast<To>(a.m[i]);
    return result;
}

bool is_finite(const Mat3& f) { return std::isfinite(norm(f)); }

}

Svd singular_values(const Mat3& f) {
    constexpr int sweeps = 8;  // quadratic at the end: 5 are enough for random F in double, 8 for any
    auto b = convert<double>(f);
    auto v = Mat3T<double>::identity();
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        orthogonalize(b, v, 0, 1);
        orthogonalize(b, v, 0, 2);
        orthogonalize(b, v, 1, 2);
    }
    sort_columns(b, v, 0, 1);
    sort_columns(b, v, 1, 2);
    sort_columns(b, v, 0, 1);
    const double s0 = length(b.column(0));
    const Vec3 u0 = s0 > 0 ? b.column(0) / s0 : Vec3{1, 0, 0};
    const double s1 = length(b.column(1));
    const Vec3 u1 = s1 > 1e-14 * s0 ? b.column(1) / s1 : any_orthogonal(u0);
    const Vec3 u2 = cross(u0, u1);
    const double s2 = dot(u2, b.column(2));
    const auto u = Mat3T<double>::from_columns(u0, u1, u2);
    return {
        convert<float>(u), {static_cast<float>(s0), static_cast<float>(s1), static_cast<float>(s2)}, convert<float>(v)};
}

Mat3 rotation_svd_smallest(const Mat3& f, const Mat3& last) {
    if (!is_finite(f)) return last;
    const Svd svd = singular_values(f);
    if (!(svd.s.y > 1e-6f * svd.s.x)) return last;
    return svd.u * transpose(svd.v);
}

Mat3 rotation_svd_last(const Mat3& f, const Mat3& last) {
    if (!is_finite(f)) return last;
    const Svd svd = singular_values(f);
    if (!(svd.s.y > 1e-6f * svd.s.x)) return last;
    if (svd.s.z >= 0) return svd.u * transpose(svd.v);
    // Moving the sign from the third to the first or second direction turns U by half a turn about the other one.
    Mat3 best = svd.u * transpose(svd.v);
    for (const int other : {0, 1}) {
        Mat3 u = svd.u;
        u.set_column(other, -u.column(other));
        u.set_column(2, -u.column(2));
        const Mat3 candidate = u * transpose(svd.v);
        if (norm(candidate - last) < norm(best - last)) best = candidate;
    }
    return best;
}

}
