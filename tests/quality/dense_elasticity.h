// SPDX-License-Identifier: GPL-3.0-or-later
// The same system a second time, from the textbook: strain matrices and Eigen.
#pragma once
#include <Eigen/Dense>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

struct DenseSystem {
    Eigen::MatrixXd stiffness;  // 3N x 3N
    Eigen::VectorXd mass;       // 3N
};

// K = sum V B^T D B with B the 6 x 12 strain matrix, E = 1, nu = 0.3, density 1. Every node must be used.
inline DenseSystem dense_system(std::span<const Vec3> positions, std::span<const Tet> tets) {
    constexpr double nu = 0.3;
    Eigen::Matrix<double, 6, 6> elastic = Eigen::Matrix<double, 6, 6>::Zero();
    const double factor = 1 / ((1 + nu) * (1 - 2 * nu));
    elastic.topLeftCorner<3, 3>().setConstant(factor * nu);
    for (int i = 0; i < 3; ++i) elastic(i, i) = factor * (1 - nu);
    for (int i = 3; i < 6; ++i) elastic(i, i) = factor * (1 - 2 * nu) / 2;

    const auto size = static_cast<Eigen::Index>(3 * positions.size());
    DenseSystem system{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
    for (const Tet& tet : tets) {
        Eigen::Matrix4d corners;  // 1 x y z
        for (int i = 0; i < 4; ++i) corners.row(i) << 1, positions[tet[i]].x, positions[tet[i]].y, positions[tet[i]].z;
        const Eigen::Matrix4d shape = corners.inverse();  // column i: coefficients of shape function i
        const double volume = std::fabs(corners.determinant()) / 6;
        Eigen::Matrix<double, 6, 12> strain = Eigen::Matrix<double, 6, 12>::Zero();
        for (int i = 0; i < 4; ++i) {
            const double x = shape(1, i), y = shape(2, i), z = shape(3, i);
            strain.col(3 * i) << x, 0, 0, y, 0, z;
            strain.col(3 * i + 1) << 0, y, 0, x, z, 0;
            strain.col(3 * i + 2) << 0, 0, z, 0, y, x;
        }
        const Eigen::Matrix<double, 12, 12> element = volume * strain.transpose() * elastic * strain;
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j)
                system.stiffness.block<3, 3>(3 * tet[i], 3 * tet[j]) += element.block<3, 3>(3 * i, 3 * j);
            system.mass.segment<3>(3 * tet[i]).array() += volume / 4;
        }
    }
    return system;
}

}
