// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/predicates.h"

#include <algorithm>
#include <cmath>

#include "geometry/exact_predicates.h"

namespace crumple {
namespace {

constexpr double unit_roundoff = 0x1p-53;

// Both filters evaluate a polynomial whose every monomial passes through at most k roundings, so that
// |computed - true| <= ((1 + u)^k - 1) * (sum of |monomials|), plus what underflow loses.
// orient3d: 3 differences, 2 products, 1 + 2 sums: k = 8. in_sphere: 5 differences, a square and its 2 sums, the
// 5 of the minor, 1 product, 3 sums: k = 17. The computed sum of magnitudes is short by (1 + u)^k at most, hence the
// spare units.
constexpr double orient3d_bound = 10 * unit_roundoff;
constexpr double in_sphere_bound = 20 * unit_roundoff;

// While no difference exceeds 2^150, an underflow (2^-1075) is multiplied by at most three further differences and
// there are fewer than 100 of them: together less than 2^-610. Smaller determinants go to the exact rung.
constexpr double largest_difference = 0x1p150;
constexpr double underflow_bound = 0x1p-600;

// Differences of at most this many grains are integers whose determinant, partial sums included, stays below 2^53:
// 6 x 2^48 and 72 x 2^45. The plain evaluation is then exact.
constexpr double exact_orient3d_grains = 0x1p16;
constexpr double exact_in_sphere_grains = 0x1p9;

int sign_of(double value) { return (value > 0) - (value < 0); }

double largest_component(Vec3 a) { return std::max(std::max(std::fabs(a.x), std::fabs(a.y)), std::fabs(a.z)); }

// The plain sum of products and the sum of their magnitudes.
struct Sum {
    double value;
    double magnitude;
};

Sum difference_of_products(double a, double b, double c, double d) {
    const double ab = a * b;
    const double cd = c * d;
    return {ab - cd, std::fabs(ab) + std::fabs(cd)};
}

Sum determinant3(Vec3 a, Sum bc, Vec3 b, Sum ca, Vec3 c, Sum ab) {
    return {a.z * bc.value + b.z * ca.value + c.z * ab.value,
            std::fabs(a.z) * bc.magnitude + std::fabs(b.z) * ca.magnitude + std::fabs(c.z) * ab.magnitude};
}

Sum cross_xy(Vec3 a, Vec3 b) { return difference_of_products(a.x, b.y, a.y, b.x); }
Sum negated(Sum a) { return {-a.value, a.magnitude}; }

}

int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d, double grain) {
    const Vec3 p = b - a;
    const Vec3 q = c - a;
    const Vec3 r = d - a;
    const Sum det = determinant3(p, cross_xy(q, r), q, cross_xy(r, p), r, cross_xy(p, q));
    const double bound = orient3d_bound * det.magnitude + underflow_bound;
    const double largest = std::max(largest_component(p), std::max(largest_component(q), largest_component(r)));
    if (largest <= largest_difference) {
        if (det.value > bound) return 1;
        if (det.value < -bound) return -1;
        if (largest <= exact_orient3d_grains * grain) return sign_of(det.value);
    }
    return exact::orient3d(a, b, c, d);
}

int in_sphere(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 e, double grain) {
    const Vec3 p = a - e;
    const Vec3 q = b - e;
    const Vec3 r = c - e;
    const Vec3 s = d - e;
    const Sum pq = cross_xy(p, q), qr = cross_xy(q, r), rs = cross_xy(r, s), sp = cross_xy(s, p);
    const Sum pr = cross_xy(p, r), qs = cross_xy(q, s);
    const Sum qrs = determinant3(q, rs, r, negated(qs), s, qr);
    const Sum psr = determinant3(p, negated(rs), s, negated(pr), r, negated(sp));
    const Sum pqs = determinant3(p, qs, q, sp, s, pq);
    const Sum prq = determinant3(p, negated(qr), r, negated(pq), q, pr);
    const double det = dot(p, p) * qrs.value + dot(q, q) * psr.value + dot(r, r) * pqs.value + dot(s, s) * prq.value;
    const double magnitude =
        dot(p, p) * qrs.magnitude + dot(q, q) * psr.magnitude + dot(r, r) * pqs.magnitude + dot(s, s) * prq.magnitude;
    const double bound = in_sphere_bound * magnitude + underflow_bound;
    const double largest = std::max(std::max(largest_component(p), largest_component(q)),
                                     std::max(largest_component(r), largest_component(s)));
    if (largest <= largest_difference) {
        if (det > bound) return 1;
        if (det < -bound) return -1;
        if (largest <= exact_in_sphere_grains * grain) return sign_of(det);
    }
    return exact::in_sphere(a, b, c, d, e);
}

bool are_collinear(Vec3 a, Vec3 b, Vec3 c) { return exact::are_collinear(a, b, c); }

}
