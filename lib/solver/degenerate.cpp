// SPDX-License-Identifier: MIT
#include "solver/degenerate.h"

#include <cmath>

#include "solver/rotation.h"

namespace crumple::solver {
namespace {

// c[0] + c[1] t + c[2] t^2 + c[3] t^3
using Cubic = std::array<double, 4>;

double value_at(const Cubic& c, double t) { return ((c[3] * t + c[2]) * t + c[1]) * t + c[0]; }

// det[a1 + t d1, a2 + t d2, a3 + t d3] - level
Cubic volume_on_the_way(const CollapsePath& path, double level) {
    std::array<Vec3, 3> a;
    std::array<Vec3, 3> d;
    for (std::size_t k = 0; k < 3; ++k) {
        a[k] = widen(path.from[k + 1]) - widen(path.from[0]);
        d[k] = widen(path.to[k + 1]) - widen(path.to[0]) - a[k];
    }
    const auto det = [](Vec3 p, Vec3 q, Vec3 r) { return dot(p, cross(q, r)); };
    return {det(a[0], a[1], a[2]) - level, det(d[0], a[1], a[2]) + det(a[0], d[1], a[2]) + det(a[0], a[1], d[2]),
            det(a[0], d[1], d[2]) + det(d[0], a[1], d[2]) + det(d[0], d[1], a[2]), det(d[0], d[1], d[2])};
}

// The root between two places of opposite sign with no turning point between them: Newton's steps, halving where one
// leaves the bracket.
double root_between(const Cubic& c, double low, double high) {
    const bool is_low_positive = value_at(c, low) > 0;
    double t = 0.5 * (low + high);
    for (int i = 0; i < 60; ++i) {
        const double value = value_at(c, t);
        (value > 0) == is_low_positive ? low = t : high = t;
        double next = t - value / ((3 * c[3] * t + 2 * c[2]) * t + c[1]);
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const double change = std::fabs(next - t);
        t = next;
        if (change <= 1e-12) break;
    }
    return t;
}

// Where the slope of the cubic vanishes inside (0, 1), in rising order; returns how many.
int turning_points(const Cubic& c, double (&t)[2]) {
    const double a = 3 * c[3], b = 2 * c[2], d = c[1];
    const double inside = b * b - 4 * a * d;
    if (!(inside > 0)) return 0;
    const double s = -0.5 * (b + (b >= 0 ? 1 : -1) * std::sqrt(inside));
    double candidate[2] = {a != 0 ? s / a : 2, s != 0 ? d / s : 2};
    if (candidate[0] > candidate[1]) std::swap(candidate[0], candidate[1]);
    int count = 0;
    for (const double value : candidate) {
        if (value > 0 && value < 1) t[count++] = value;
    }
    return count;
}

// Direction in which the four corners are thinnest: the left singular vector of the smallest singular value of
// [q10 q20 q30].
Vec3f thin_direction(const std::array<Vec3, 4>& q) {
    const Vec3 e1 = q[1] - q[0], e2 = q[2] - q[0], e3 = q[3] - q[0];
    const double size = std::sqrt(dot(e1, e1) + dot(e2, e2) + dot(e3, e3));
    const auto narrow = [&](Vec3 a) {
        return Vec3f{static_cast<float>(a.x / size), static_cast<float>(a.y / size), static_cast<float>(a.z / size)};
    };
    if (!(size > 0)) return {0, 0, 1};
    return singular_values(Mat3::from_columns(narrow(e1), narrow(e2), narrow(e3))).u.column(2);
}

// A tet seen along its thin direction is a triangle with a point in it, or two crossing segments: which of the two, and
// whose corners, is told by the signs of the projected areas of its faces (their Radon partition).
Collapse classify_flat(const std::array<Vec3, 4>& q) {
    const Vec3 n = widen(thin_direction(q));
    const Vec3 e1 = q[1] - q[0], e2 = q[2] - q[0], e3 = q[3] - q[0];
    const double area[4] = {0, dot(n, cross(e2, e3)), dot(n, cross(e3, e1)), dot(n, cross(e1, e2))};
    const double area0 = -(area[1] + area[2] + area[3]);
    const bool positive[4] = {area0 > 0, area[1] > 0, area[2] > 0, area[3] > 0};
    const int count = positive[0] + positive[1] + positive[2] + positive[3];
    if (count == 2) {
        for (int j = 1; j < 4; ++j) {
            if (positive[j] == positive[0]) return static_cast<Collapse>(4 + j);  // edge 0j against the other
        }
    }
    for (int i = 0; i < 4; ++i) {
        if (positive[i] == (count == 1)) return static_cast<Collapse>(1 + i);
    }
    return Collapse::corner0;  // all areas zero: a line or a point, where no axis exists anyway
}

}

double collapse_time(const CollapsePath& path) {
    const Cubic c = volume_on_the_way(path, static_cast<double>(path.threshold) * path.six_rest_volumes);
    if (!(value_at(c, 0) > 0)) return 1;
    double turns[2];
    const int count = turning_points(c, turns);
    double low = 0;
    for (int i = 0; i <= count; ++i) {
        const double high = i < count ? turns[i] : 1;
        if (!(value_at(c, high) > 0)) return root_between(c, low, high);
        low = high;
    }
    return 1;
}

Collapse classify_collapse(const CollapsePath& path) {
    const double t = collapse_time(path);
    std::array<Vec3, 4> q;
    for (std::size_t i = 0; i < 4; ++i) q[i] = widen(path.from[i]) * (1 - t) + widen(path.to[i]) * t;
    return classify_flat(q);
}

}
