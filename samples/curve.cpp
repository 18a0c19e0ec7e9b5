// SPDX-License-Identifier: MIT
#include "samples/curve.h"

#include <algorithm>

namespace crumple::samples {
namespace {

// Taylor series, exact to the last bits for |x| up to an eighth of a turn.
Turn small_turn(double x) {
    double term = 1;
    Turn result{1, 0};
    for (int n = 1; n <= 20; ++n) {
        term *= x / n;
        const double signed_term = (n / 2) % 2 ? -term : term;
        (n % 2 ? result.sine : result.cosine) += signed_term;
    }
    return result;
}

double slope(const Key& a, const Key& b) { return (b.value - a.value) / (b.z - a.z); }

double tangent(std::span<const Key> keys, std::size_t k) {
    if (k == 0 || k + 1 == keys.size()) return 0;
    const double before = slope(keys[k - 1], keys[k]);
    const double after = slope(keys[k], keys[k + 1]);
    return before * after <= 0 ? 0 : 2 * before * after / (before + after);
}

}

Turn turn(double fraction) {
    constexpr double pi = 3.14159265358979323846;
    const int quarter = static_cast<int>(fraction * 4 + 0.5);
    const Turn rest = small_turn((fraction - quarter * 0.25) * 2 * pi);
    switch (quarter % 4) {
        case 0:
            return rest;
        case 1:
            return {-rest.sine, rest.cosine};
        case 2:
            return {-rest.cosine, -rest.sine};
        default:
            return {rest.sine, -rest.cosine};
    }
}

double interpolate(std::span<const Key> keys, double z) {
    if (z <= keys.front().z) return keys.front().value;
    if (z >= keys.back().z) return keys.back().value;
    std::size_t k = 0;
    while (keys[k + 1].z < z) ++k;
    const double width = keys[k + 1].z - keys[k].z;
    const double t = (z - keys[k].z) / width;
    const double s = 1 - t;
    return keys[k].value * (1 + 2 * t) * s * s + tangent(keys, k) * width * t * s * s +
           keys[k + 1].value * (1 + 2 * s) * t * t - tangent(keys, k + 1) * width * s * t * t;
}

Vec3 spline(std::span<const Vec3> controls, double u) {
    // Span k runs from the middle before control k to the middle after it; the outer two begin and end at the controls.
    const int last = static_cast<int>(controls.size()) - 1;
    const int k = std::clamp(static_cast<int>(u + 0.5), 1, last - 1);
    const double begin = k == 1 ? 0 : k - 0.5;
    const double end = k == last - 1 ? last : k + 0.5;
    const auto c = static_cast<std::size_t>(k);
    const Vec3 from = k == 1 ? controls[0] : (controls[c - 1] + controls[c]) * 0.5;
    const Vec3 to = k == last - 1 ? controls[c + 1] : (controls[c] + controls[c + 1]) * 0.5;
    const double t = (u - begin) / (end - begin);
    return from * ((1 - t) * (1 - t)) + controls[c] * (2 * t * (1 - t)) + to * (t * t);
}

}
