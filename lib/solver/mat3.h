// SPDX-License-Identifier: MIT
// 3 x 3 matrices of one element, row-major, for the clear scalar paths. Kernels work on lanes instead.
#pragma once
#include <array>
#include <cmath>

#include "core/vec3.h"

namespace crumple::solver {

template <class T>
struct Mat3T {
    std::array<T, 9> m{};

    constexpr T& operator()(int row, int column) { return m[static_cast<std::size_t>(3 * row + column)]; }
    constexpr T operator()(int row, int column) const { return m[static_cast<std::size_t>(3 * row + column)]; }
    static constexpr Mat3T identity() { return {{1, 0, 0, 0, 1, 0, 0, 0, 1}}; }
    static constexpr Mat3T from_columns(Vec3T<T> a, Vec3T<T> b, Vec3T<T> c) {
        return {{a.x, b.x, c.x, a.y, b.y, c.y, a.z, b.z, c.z}};
    }
    [[nodiscard]] constexpr Vec3T<T> column(int c) const { return {(*this)(0, c), (*this)(1, c), (*this)(2, c)}; }
    [[nodiscard]] constexpr Vec3T<T> row(int r) const { return {(*this)(r, 0), (*this)(r, 1), (*this)(r, 2)}; }
    constexpr void set_column(int c, Vec3T<T> v) {
        for (int r = 0; r < 3; ++r) (*this)(r, c) = v[r];
    }
    friend constexpr bool operator==(const Mat3T&, const Mat3T&) = default;
    friend constexpr Mat3T operator+(Mat3T a, const Mat3T& b) {
        for (std::size_t i = 0; i < 9; ++i) a.m[i] += b.m[i];
        return a;
    }
    friend constexpr Mat3T operator-(Mat3T a, const Mat3T& b) {
        for (std::size_t i = 0; i < 9; ++i) a.m[i] -= b.m[i];
        return a;
    }
    friend constexpr Mat3T operator*(Mat3T a, T s) {
        for (T& value : a.m) value *= s;
        return a;
    }
    friend constexpr Mat3T operator*(const Mat3T& a, const Mat3T& b) {
        Mat3T c;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) c(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
        }
        return c;
    }
    friend constexpr Vec3T<T> operator*(const Mat3T& a, Vec3T<T> v) {
        return {dot(a.row(0), v), dot(a.row(1), v), dot(a.row(2), v)};
    }
};

using Mat3 = Mat3T<float>;
using Mat3d = Mat3T<double>;

[[nodiscard]] inline Vec3 widen(Vec3f a) { return {a.x, a.y, a.z}; }
[[nodiscard]] inline Vec3f narrow(Vec3 a) {
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

template <class T>
constexpr Mat3T<T> transpose(const Mat3T<T>& a) {
    return {{a.m[0], a.m[3], a.m[6], a.m[1], a.m[4], a.m[7], a.m[2], a.m[5], a.m[8]}};
}
template <class T>
constexpr T determinant(const Mat3T<T>& a) {
    return dot(a.column(0), cross(a.column(1), a.column(2)));
}
// det(A) A^-T: its columns are the cross products of A's other two.
template <class T>
constexpr Mat3T<T> cofactor(const Mat3T<T>& a) {
    return Mat3T<T>::from_columns(cross(a.column(1), a.column(2)), cross(a.column(2), a.column(0)),
                                  cross(a.column(0), a.column(1)));
}
template <class T>
constexpr Mat3T<T> outer(Vec3T<T> a, Vec3T<T> b) {
    return Mat3T<T>::from_columns(a * b.x, a * b.y, a * b.z);
}
template <class T>
constexpr T trace(const Mat3T<T>& a) {
    return a.m[0] + a.m[4] + a.m[8];
}
template <class T>
T norm(const Mat3T<T>& a) {
    T sum = 0;
    for (const T value : a.m) sum += value * value;
    return std::sqrt(sum);
}

// A unit quaternion w + xi + yj + zk, kept as x, y, z, w.
struct Quaternion {
    float x = 0;
    float y = 0;
    float z = 0;
    float w = 1;
    friend constexpr bool operator==(const Quaternion&, const Quaternion&) = default;
};

[[nodiscard]] Mat3 to_matrix(Quaternion q);
[[nodiscard]] Quaternion to_quaternion(const Mat3& rotation);

}
