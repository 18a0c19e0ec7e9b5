// SPDX-License-Identifier: MIT
// Splits the rotation off a deformation gradient. One element at a time and clear; the kernels hold the wide version of
// the default. Every method but `polar` and `qr` on a mirrored F returns a rotation (determinant +1) for any F.
#pragma once
#include <span>

#include "core/fields.h"
#include "solver/mat3.h"

namespace crumple::solver {

enum class RotationMethod { apd, qr, polar, svd_smallest, svd_last };
inline constexpr EnumName<RotationMethod> rotation_method_names[] = {{RotationMethod::apd, "apd"},
                                                                     {RotationMethod::qr, "qr"},
                                                                     {RotationMethod::polar, "polar"},
                                                                     {RotationMethod::svd_smallest, "svd_smallest"},
                                                                     {RotationMethod::svd_last, "svd_last"}};
constexpr std::span<const EnumName<RotationMethod>> enum_names(RotationMethod) { return rotation_method_names; }

// `last` is the rotation of the step before. Where F says nothing about the rotation (it maps to a line or a point, or
// is not finite) the answer is `last`.
using RotationFunction = Mat3 (*)(const Mat3& f, const Mat3& last);

[[nodiscard]] RotationFunction rotation_function(RotationMethod method);

// F = U diag(s) V^T with U and V rotations and s[0] >= s[1] >= |s[2]|: s[2] carries the sign of det F.
struct Svd {
    Mat3 u;
    Vec3f s;
    Mat3 v;
};
[[nodiscard]] Svd singular_values(const Mat3& f);

Mat3 rotation_apd(const Mat3& f, const Mat3& last);
Mat3 rotation_qr(const Mat3& f, const Mat3& last);
Mat3 rotation_polar(const Mat3& f, const Mat3& last);
Mat3 rotation_svd_smallest(const Mat3& f, const Mat3& last);
Mat3 rotation_svd_last(const Mat3& f, const Mat3& last);

}
