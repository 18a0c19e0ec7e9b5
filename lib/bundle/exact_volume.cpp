// SPDX-License-Identifier: MIT
#include "bundle/exact_volume.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace crumple {
namespace {

// A sum without rounding: its partial sums do not overlap [Shewchuk 1997, "Adaptive precision floating-point
// arithmetic", grow-expansion], so their total rounds only once.
class ExactSum {
public:
    void add(double x) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            double y = parts_[i];
            if (std::fabs(x) < std::fabs(y)) std::swap(x, y);
            const double high = x + y;
            const double low = y - (high - x);
            if (low != 0) parts_[kept++] = low;
            x = high;
        }
        parts_[kept++] = x;
        count_ = kept;
    }
    [[nodiscard]] double value() const {
        double sum = 0;
        for (std::size_t i = 0; i < count_; ++i) sum += parts_[i];
        return sum;
    }

private:
    std::array<double, 64> parts_{};  // 48 terms are added
    std::size_t count_ = 0;
};

// x y has at most 48 bits and is exact; times z is exact in two doubles.
void add_product(ExactSum& sum, double sign, float x, float y, float z) {
    const double xy = sign * static_cast<double>(x) * y;
    const double high = xy * z;
    sum.add(high);
    sum.add(std::fma(xy, static_cast<double>(z), -high));
}

void add_triple_product(ExactSum& sum, double sign, Vec3f p, Vec3f q, Vec3f r) {
    add_product(sum, sign, p.x, q.y, r.z);
    add_product(sum, sign, p.y, q.z, r.x);
    add_product(sum, sign, p.z, q.x, r.y);
    add_product(sum, -sign, p.x, q.z, r.y);
    add_product(sum, -sign, p.y, q.x, r.z);
    add_product(sum, -sign, p.z, q.y, r.x);
}

double exact_six_volumes(Vec3f a, Vec3f b, Vec3f c, Vec3f d) {
    ExactSum sum;
    add_triple_product(sum, +1, b, c, d);
    add_triple_product(sum, -1, a, c, d);
    add_triple_product(sum, +1, a, b, d);
    add_triple_product(sum, -1, a, b, c);
    return sum.value();
}

Vec3 absolute(Vec3 v) { return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}; }

// The terms of cross(a, b) with their signs dropped.
Vec3 cross_permanent(Vec3 a, Vec3 b) { return {a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x}; }

}

double six_volumes(Vec3f a, Vec3f b, Vec3f c, Vec3f d) {
    const Vec3 u = widen(b) - widen(a);
    const Vec3 v = widen(c) - widen(a);
    const Vec3 w = widen(d) - widen(a);
    const double determinant = dot(u, cross(v, w));
    const double permanent = dot(absolute(u), cross_permanent(absolute(v), absolute(w)));
    // Rounding is below 8e-16 permanent [Shewchuk 1997, orient3d]: above 1e-8 permanent the value is good to 1e-7.
    if (std::fabs(determinant) > 1e-8 * permanent) return determinant;
    return exact_six_volumes(a, b, c, d);
}

std::array<double, 9> inverse_rest_matrix(Vec3f a, Vec3f b, Vec3f c, Vec3f d) {
    const Vec3 u = widen(b) - widen(a);
    const Vec3 v = widen(c) - widen(a);
    const Vec3 w = widen(d) - widen(a);
    const double determinant = six_volumes(a, b, c, d);
    const Vec3 rows[3] = {cross(v, w) / determinant, cross(w, u) / determinant, cross(u, v) / determinant};
    std::array<double, 9> inverse{};
    for (int row = 0; row < 3; ++row) {
        for (int axis = 0; axis < 3; ++axis) inverse[static_cast<std::size_t>(3 * row + axis)] = rows[row][axis];
    }
    return inverse;
}

}
