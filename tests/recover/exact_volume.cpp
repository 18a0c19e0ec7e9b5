// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_volume.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <sstream>

namespace crumple::recover {

namespace {

using Integer = boost::multiprecision::cpp_int;

// The coordinate in units of the smallest float.
Integer whole(double coordinate) {
    int exponent = 0;
    const double fraction = std::frexp(coordinate, &exponent);
    Integer units = static_cast<long long>(std::ldexp(fraction, 24));
    const int shift = exponent - 24 + 149;
    if (shift >= 0) units <<= shift;
    return shift >= 0 ? units : Integer(units / (1 << -shift));
}

}

std::string exact_six_volumes(const TetMesh& mesh) {
    std::vector<std::array<Integer, 3>> positions;
    for (const Vec3& p : mesh.positions) positions.push_back({whole(p.x), whole(p.y), whole(p.z)});
    Integer sum = 0;
    for (const auto& [a, b, c, d] : mesh.tets) {
        std::array<Integer, 3> p, q, r;
        for (int axis = 0; axis < 3; ++axis) {
            p[axis] = positions[b][axis] - positions[a][axis];
            q[axis] = positions[c][axis] - positions[a][axis];
            r[axis] = positions[d][axis] - positions[a][axis];
        }
        sum += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
               p[2] * (q[0] * r[1] - q[1] * r[0]);
    }
    std::ostringstream text;
    text << std::hex << sum;
    return text.str();
}

}
