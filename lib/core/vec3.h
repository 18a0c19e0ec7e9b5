// SPDX-License-Identifier: MIT
// A point or vector of three numbers. Positions are metres, right-handed, Y up.
#pragma once
#include <cmath>

namespace crumple {

template <class T>
struct Vec3T {
    T x{};
    T y{};
    T z{};

    constexpr T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr T operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

    // The default comparison makes -0.0 equal to 0.0, as import promises.
    friend constexpr bool operator==(const Vec3T&, const Vec3T&) = default;
    friend constexpr Vec3T operator+(Vec3T a, Vec3T b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3T operator-(Vec3T a, Vec3T b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3T operator-(Vec3T a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vec3T operator*(Vec3T a, T s) { return {a.x * s, a.y * s, a.z * s}; }
    friend constexpr Vec3T operator*(T s, Vec3T a) { return a * s; }
    friend constexpr Vec3T operator/(Vec3T a, T s) { return {a.x / s, a.y / s, a.z / s}; }
    constexpr Vec3T& operator+=(Vec3T b) { return *this = *this + b; }
    constexpr Vec3T& operator-=(Vec3T b) { return *this = *this - b; }
};

using Vec3 = Vec3T<double>;
using Vec3f = Vec3T<float>;

template <class T>
constexpr T dot(Vec3T<T> a, Vec3T<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
constexpr Vec3T<T> cross(Vec3T<T> a, Vec3T<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T length(Vec3T<T> a) {
    return std::sqrt(dot(a, a));
}

template <class T>
bool is_finite(Vec3T<T> a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

// Between what offline stages count in and what games hold; narrow takes the nearest.
template <class T>
constexpr Vec3 widen(Vec3T<T> a) {
    return {a.x, a.y, a.z};
}
template <class T>
constexpr Vec3f narrow(Vec3T<T> a) {
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

// Order by x, then y, then z: how ties are broken, so that input order never matters.
template <class T>
constexpr bool lexicographic_less(Vec3T<T> a, Vec3T<T> b) {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

// The nearest position a game can hold. Offline positions stay on such values (see lib/README.md, invariants).
// The volatiles keep g++ 12 from optimizing the rounding away: from -O2 on, its basic-block vectorizer takes a double
// made float and double again, three times side by side, for no change at all.
inline Vec3 round_to_float(Vec3 p) {
    const volatile float x = static_cast<float>(p.x);
    const volatile float y = static_cast<float>(p.y);
    const volatile float z = static_cast<float>(p.z);
    return {x, y, z};
}

// Finite, and a game can hold it as it is. -0 and 0 are one value, so comparing values is enough.
inline bool is_float(Vec3 p) { return is_finite(p) && round_to_float(p) == p; }

}
