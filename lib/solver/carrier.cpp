// SPDX-License-Identifier: MIT
#include "solver/carrier.h"

namespace crumple::solver {
namespace {

Mat3d matrix_of(Quaternion q) {
    const double x = q.x, y = q.y, z = q.z, w = q.w;
    const double s = 2 / (x * x + y * y + z * z + w * w);
    return {{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),  //
             s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),  //
             s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)}};
}

}

Frame::Frame(const CarrierMotion& motion)
    : motion_(motion), turn_(matrix_of(motion.orientation)), turn_back_(transpose(turn_)) {}

}
