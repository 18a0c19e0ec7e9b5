// SPDX-License-Identifier: MIT
#include "solver/rotation.h"

namespace crumple::solver {
namespace {

struct Row {
    RotationMethod method;
    RotationFunction function;
};

constexpr Row methods[] = {{RotationMethod::apd, rotation_apd},
                           {RotationMethod::qr, rotation_qr},
                           {RotationMethod::polar, rotation_polar},
                           {RotationMethod::svd_smallest, rotation_svd_smallest},
                           {RotationMethod::svd_last, rotation_svd_last}};

}

RotationFunction rotation_function(RotationMethod method) {
    for (const Row& row : methods) {
        if (row.method == method) return row.function;
    }
    return rotation_apd;
}

Mat3 to_matrix(Quaternion q) {
    const float x = q.x, y = q.y, z = q.z, w = q.w;
    return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
             2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),  //
             2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
}

// Divides by the largest of the four components, so nothing cancels [Shepperd 1978].
Quaternion to_quaternion(const Mat3& r) {
    const float t[4] = {1 + r(0, 0) - r(1, 1) - r(2, 2), 1 - r(0, 0) + r(1, 1) - r(2, 2),
                        1 - r(0, 0) - r(1, 1) + r(2, 2), 1 + r(0, 0) + r(1, 1) + r(2, 2)};
    int largest = 0;
    for (int i = 1; i < 4; ++i) {
        if (t[i] > t[largest]) largest = i;
    }
    Quaternion q;
    switch (largest) {
        case 0:
            q = {t[0], r(0, 1) + r(1, 0), r(0, 2) + r(2, 0), r(2, 1) - r(1, 2)};
            break;
        case 1:
            q = {r(0, 1) + r(1, 0), t[1], r(1, 2) + r(2, 1), r(0, 2) - r(2, 0)};
            break;
        case 2:
            q = {r(0, 2) + r(2, 0), r(1, 2) + r(2, 1), t[2], r(1, 0) - r(0, 1)};
            break;
        default:
            q = {r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1), t[3]};
            break;
    }
    const float scale = 1 / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
}

}
