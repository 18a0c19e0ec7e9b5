// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/exact_predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "geometry/clones.h"
#include "geometry/double_double.h"
#include "geometry/exact_integer.h"

namespace crumple::exact {
namespace {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

// N points relative to an origin as integers of a common power of two.
template <int N>
using LocalIntegers = std::array<std::array<std::int64_t, 3>, N>;

// With |value| <= 2^41 a 3x3 determinant has at most 6 products of 2^123: below 2^126, inside int128.
constexpr int local_bits = 41;

bool is_exact_difference(double a, double b, double difference) {
    // Knuth's two-sum error term; zero exactly when the rounded difference is the true one. Infinite values give NaN.
    const double b_part = a - difference;
    const double a_part = difference + b_part;
    return (a - a_part) + (b_part - b) == 0;
}

// The differences p - origin when they are exact and short enough, which floats of one neighbourhood always are.
template <int N>
std::optional<LocalIntegers<N>> local_integers(const std::array<Vec3, N>& points, Vec3 origin) {
    std::array<std::array<double, 3>, N> differences;
    double largest = 0;
    for (int i = 0; i < N; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const double difference = points[i][axis] - origin[axis];
            if (!is_exact_difference(points[i][axis], origin[axis], difference)) return std::nullopt;
            differences[i][axis] = difference;
            largest = std::fmax(largest, std::fabs(difference));
        }
    }
    LocalIntegers<N> result{};
    if (largest == 0) return result;
    const int exponent = std::ilogb(largest);
    if (exponent < -900 || exponent > 900) return std::nullopt;
    const double scale = std::ldexp(1.0, local_bits - 1 - exponent);
    for (int i = 0; i < N; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const double scaled = differences[i][axis] * scale;
            result[i][axis] = static_cast<std::int64_t>(scaled);
            // The second test catches a scaled value that underflowed to zero.
            if (static_cast<double>(result[i][axis]) != scaled || (scaled == 0) != (differences[i][axis] == 0)) {
                return std::nullopt;
            }
        }
    }
    return result;
}

// The same differences as wide integers: works for any finite doubles.
template <int N>
std::array<std::array<ExactInteger, 3>, N> wide_integers(const std::array<Vec3, N>& points, Vec3 origin) {
    int lowest = 1024;
    const auto note_exponent = [&lowest](Vec3 p) {
        for (int axis = 0; axis < 3; ++axis) {
            // Below 2^-1074 there are no bits, so a denormal's own exponent minus 52 would overshoot.
            if (p[axis] != 0) lowest = std::min(lowest, std::max(std::ilogb(p[axis]) - 52, -1074));
        }
    };
    note_exponent(origin);
    for (const Vec3& p : points) note_exponent(p);
    const auto to_integer = [lowest](double value) {
        if (value == 0) return ExactInteger{};
        const int exponent = std::max(std::ilogb(value) - 52, -1074);
        const auto mantissa = static_cast<std::int64_t>(std::scalbn(value, -exponent));
        return ExactInteger::from_scaled(mantissa, exponent - lowest);
    };
    std::array<std::array<ExactInteger, 3>, N> result;
    for (int axis = 0; axis < 3; ++axis) {
        const ExactInteger base = to_integer(origin[axis]);
        for (int i = 0; i < N; ++i) result[i][axis] = to_integer(points[i][axis]) - base;
    }
    return result;
}

template <class Product, class Row>
Product determinant3(const Row& a, const Row& b, const Row& c) {
    const Product bc = Product(b[1]) * c[2] - Product(b[2]) * c[1];
    const Product ca = Product(c[1]) * a[2] - Product(c[2]) * a[1];
    const Product ab = Product(a[1]) * b[2] - Product(a[2]) * b[1];
    return bc * a[0] + ca * b[0] + ab * c[0];
}

template <class Product, class Row>
Product squared_length(const Row& a) {
    return Product(a[0]) * a[0] + Product(a[1]) * a[1] + Product(a[2]) * a[2];
}

// The 4x4 determinant of the rows (p, |p|^2) expanded along its last column, with the sign of in_sphere. Minors share
// their 2x2 determinants in x and y.
template <class Product, class Rows>
Product in_sphere_determinant(const Rows& p) {
    const auto xy = [&p](int i, int j) { return Product(p[i][0]) * p[j][1] - Product(p[i][1]) * p[j][0]; };
    const Product ab = xy(0, 1), bc = xy(1, 2), cd = xy(2, 3), da = xy(3, 0), ac = xy(0, 2), bd = xy(1, 3);
    const Product bcd = cd * p[1][2] - bd * p[2][2] + bc * p[3][2];
    const Product acd = cd * p[0][2] + da * p[2][2] + ac * p[3][2];
    const Product abd = bd * p[0][2] + da * p[1][2] + ab * p[3][2];
    const Product abc = bc * p[0][2] - ac * p[1][2] + ab * p[2][2];
    return (squared_length<Product>(p[0]) * bcd - squared_length<Product>(p[1]) * acd) +
           (squared_length<Product>(p[2]) * abd - squared_length<Product>(p[3]) * abc);
}

// A signed sum of products of two int128, in 256 bits, two's complement.
class Sum256 {
public:
    void add_product(Int128 a, Int128 b) {
        const bool negative = (a < 0) != (b < 0);
        const Uint128 x = a < 0 ? -static_cast<Uint128>(a) : static_cast<Uint128>(a);
        const Uint128 y = b < 0 ? -static_cast<Uint128>(b) : static_cast<Uint128>(b);
        const Uint128 x0 = static_cast<std::uint64_t>(x), x1 = x >> 64;
        const Uint128 y0 = static_cast<std::uint64_t>(y), y1 = y >> 64;
        const Uint128 low = x0 * y0;
        const Uint128 middle_0 = x0 * y1 + (low >> 64);
        const Uint128 middle_1 = x1 * y0 + static_cast<std::uint64_t>(middle_0);
        Uint128 product_low = (middle_1 << 64) | static_cast<std::uint64_t>(low);
        Uint128 product_high = x1 * y1 + (middle_0 >> 64) + (middle_1 >> 64);
        if (negative) {
            product_low = -product_low;
            product_high = ~product_high + (product_low == 0 ? 1 : 0);
        }
        low_ += product_low;
        high_ += product_high + (low_ < product_low ? 1 : 0);
    }
    [[nodiscard]] int sign() const {
        if (static_cast<Int128>(high_) < 0) return -1;
        return (high_ | low_) != 0 ? 1 : 0;
    }

private:
    Uint128 low_ = 0;
    Uint128 high_ = 0;
};

int sign_of(Int128 value) { return (value > 0) - (value < 0); }

// The double-double rung. Every monomial passes through at most 17 operations (see predicates.cpp) of relative error
// 2^-102, so 2^-97 of the sum of magnitudes is a safe bound; underflow as in predicates.cpp.
constexpr double double_double_bound = 0x1p-97;
constexpr double largest_difference = 0x1p150;
constexpr double underflow_bound = 0x1p-600;

template <int N>
using DoubleDoubles = std::array<std::array<DoubleDouble, 3>, N>;

template <int N>
DoubleDoubles<N> double_double_differences(const std::array<Vec3, N>& points, Vec3 origin) {
    DoubleDoubles<N> result;
    for (int i = 0; i < N; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            result[i][axis] = DoubleDouble::difference(points[i][axis], origin[axis]);
        }
    }
    return result;
}

int certain_sign(DoubleDouble value, double magnitude, double largest) {
    const double bound = double_double_bound * magnitude + underflow_bound;
    if (!(largest <= largest_difference)) return 0;
    return (value.high > bound) - (value.high < -bound);
}

// The largest component, and 6 * |a|_m |b|_m |c|_m >= the sum of a determinant's magnitudes.
double largest_component(const std::array<DoubleDouble, 3>& a) {
    return std::max(std::max(std::fabs(a[0].high), std::fabs(a[1].high)), std::fabs(a[2].high));
}

CRUMPLE_CLONES("fma", "default")
int double_double_orient3d(const std::array<Vec3, 3>& points, Vec3 origin) {
    const auto p = double_double_differences<3>(points, origin);
    const double a = largest_component(p[0]);
    const double b = largest_component(p[1]);
    const double c = largest_component(p[2]);
    return certain_sign(determinant3<DoubleDouble>(p[0], p[1], p[2]), 8 * a * b * c, std::max(std::max(a, b), c));
}

CRUMPLE_CLONES("fma", "default")
int double_double_in_sphere(const std::array<Vec3, 4>& points, Vec3 origin) {
    const auto p = double_double_differences<4>(points, origin);
    const double a = largest_component(p[0]);
    const double b = largest_component(p[1]);
    const double c = largest_component(p[2]);
    const double d = largest_component(p[3]);
    const double largest = std::max(std::max(a, b), std::max(c, d));
    // Four products of |p|^2 <= 3 m^2 with a determinant <= 6 m m m.
    return certain_sign(in_sphere_determinant<DoubleDouble>(p), 20 * a * b * c * d * (a + b + c + d), largest);
}

// True when all differences vanish along one axis: points of an axis-aligned plane, the commonest zero.
template <int N>
bool are_in_axis_plane(const std::array<Vec3, N>& points, Vec3 origin) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::all_of(points.begin(), points.end(), [&](Vec3 p) { return p[axis] == origin[axis]; })) return true;
    }
    return false;
}

}

int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const std::array<Vec3, 3> points{b, c, d};
    if (are_in_axis_plane<3>(points, a)) return 0;
    if (const auto p = local_integers<3>(points, a)) return sign_of(determinant3<Int128>((*p)[0], (*p)[1], (*p)[2]));
    if (const int sign = double_double_orient3d(points, a)) return sign;
    const auto p = wide_integers<3>(points, a);
    return determinant3<ExactInteger>(p[0], p[1], p[2]).sign();
}

int in_sphere(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 e) {
    const std::array<Vec3, 4> points{a, b, c, d};
    if (const auto local = local_integers<4>(points, e)) {
        const auto& p = *local;
        // Each product is below 2^84 x 2^126, their sum below 2^212.
        Sum256 sum;
        sum.add_product(squared_length<Int128>(p[0]), determinant3<Int128>(p[1], p[2], p[3]));
        sum.add_product(squared_length<Int128>(p[1]), determinant3<Int128>(p[0], p[3], p[2]));
        sum.add_product(squared_length<Int128>(p[2]), determinant3<Int128>(p[0], p[1], p[3]));
        sum.add_product(squared_length<Int128>(p[3]), determinant3<Int128>(p[0], p[2], p[1]));
        return sum.sign();
    }
    if (const int sign = double_double_in_sphere(points, e)) return sign;
    return in_sphere_determinant<ExactInteger>(wide_integers<4>(points, e)).sign();
}

bool are_collinear(Vec3 a, Vec3 b, Vec3 c) {
    const auto p = wide_integers<2>({b, c}, a);
    for (int axis = 0; axis < 3; ++axis) {
        const int next = (axis + 1) % 3;
        if ((p[0][axis] * p[1][next] - p[0][next] * p[1][axis]).sign() != 0) return false;
    }
    return true;
}

}
