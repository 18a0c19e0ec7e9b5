// SPDX-License-Identifier: MIT
#include "solver/rigid_motion.h"

#include <algorithm>

namespace crumple::solver {
namespace {

Mat3d cross_matrix(Vec3 a) { return {{0, -a.z, a.y, a.z, 0, -a.x, -a.y, a.x, 0}}; }

void add_block(Matrix6& m, int row, int column, const Mat3d& block, double sign) {
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) m[static_cast<std::size_t>(6 * (row + r) + column + c)] += sign * block(r, c);
    }
}

}

Six times(const Matrix6& m, const Six& v) {
    Six result{};
    for (std::size_t r = 0; r < 6; ++r) {
        for (std::size_t c = 0; c < 6; ++c) result[r] += m[6 * r + c] * v[c];
    }
    return result;
}

void RowMotion::add(const Mat3d& b, Vec3 x) {
    blocks = blocks + b;
    // A row of b [x] is the row's cross product with x.
    for (int r = 0; r < 3; ++r) {
        const Vec3 row = cross(b.row(r), x);
        for (int c = 0; c < 3; ++c) turned(r, c) += row[c];
    }
}

void add_row(Matrix6& m, Vec3 x, const RowMotion& row, double s) {
    const Mat3d arm = cross_matrix(x);
    add_block(m, 0, 0, row.blocks, s);
    add_block(m, 0, 3, row.turned, -s);
    add_block(m, 3, 0, arm * row.blocks, s);
    add_block(m, 3, 3, arm * row.turned, -s);
}

Matrix6 PointMasses::matrix() const {
    Matrix6 m{};
    add_block(m, 0, 0, Mat3d::identity(), mass_);
    add_block(m, 0, 3, cross_matrix(first_), -1);
    add_block(m, 3, 0, cross_matrix(first_), 1);
    const Vec3 s = squares_;
    const Vec3 p = products_;
    add_block(m, 3, 3, {{s.y + s.z, -p.z, -p.y, -p.z, s.z + s.x, -p.x, -p.y, -p.x, s.x + s.y}}, 1);
    return m;
}

// Gauss without pivots.
Matrix6 inverse_of(Matrix6 a, double floor) {
    double size = 0;
    for (std::size_t i = 0; i < 6; ++i) size = std::max(size, a[7 * i]);
    Matrix6 inverse{};
    for (std::size_t i = 0; i < 6; ++i) {
        a[7 * i] += floor * size;
        inverse[7 * i] = 1;
    }
    for (std::size_t i = 0; i < 6; ++i) {
        if (!(a[7 * i] > 0)) return {};
        const double over = 1 / a[7 * i];
        for (std::size_t c = 0; c < 6; ++c) {
            a[6 * i + c] *= over;
            inverse[6 * i + c] *= over;
        }
        for (std::size_t r = 0; r < 6; ++r) {
            const double factor = a[6 * r + i];
            if (r == i) continue;
            for (std::size_t c = 0; c < 6; ++c) {
                a[6 * r + c] -= factor * a[6 * i + c];
                inverse[6 * r + c] -= factor * inverse[6 * i + c];
            }
        }
    }
    return inverse;
}

}
