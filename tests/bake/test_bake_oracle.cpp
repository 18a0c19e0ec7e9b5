// SPDX-License-Identifier: GPL-3.0-or-later
// The matrix pattern and the rest state against Eigen, computed another way.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <cmath>

#include "bake/grid_input.h"

using namespace crumple;
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

namespace {

Eigen::Vector3d eigen(Vec3f p) { return {p.x, p.y, p.z}; }

Eigen::Matrix3d rest_edges(const Bundle& b, std::size_t t) {
    Eigen::Matrix3d dm;
    for (int k = 0; k < 3; ++k)
        dm.col(k) =
            eigen(b.rest_positions[b.tets[t][static_cast<std::size_t>(k) + 1]]) - eigen(b.rest_positions[b.tets[t][0]]);
    return dm;
}

// Weights grad_a . grad_b of the Laplacian: a scalar for each pair of corners that depends on all data of a tet.
double element_value(const Bundle& b, std::size_t t, std::size_t corner_a, std::size_t corner_b) {
    const Eigen::Matrix3d inverse = rest_edges(b, t).inverse();
    const auto gradient = [&](std::size_t corner) -> Eigen::RowVector3d {
        if (corner == 0) return -inverse.colwise().sum();
        return inverse.row(static_cast<int>(corner) - 1);
    };
    return b.volume[t] * gradient(corner_a).dot(gradient(corner_b));
}

SparseMatrix assemble_with_eigen(const Bundle& b) {
    std::vector<Eigen::Triplet<double>> triplets;
    for (std::size_t t = 0; t < b.solver_tet_count; ++t) {
        for (std::size_t a = 0; a < 4; ++a) {
            for (std::size_t c = 0; c < 4; ++c) {
                triplets.emplace_back(static_cast<int>(b.tets[t][a]), static_cast<int>(b.tets[t][c]),
                                      element_value(b, t, a, c));
            }
        }
    }
    // A row no solver tet touches still has its diagonal.
    for (std::size_t node = 0; node < b.rest_positions.size(); ++node) triplets.emplace_back(node, node, 0.0);
    SparseMatrix matrix(static_cast<int>(b.rest_positions.size()), static_cast<int>(b.rest_positions.size()));
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

Bundle sample() { return test::bake_input(test::grid_input(4, 0.3)).bundle; }

}

TEST(BakeOracle, RowsAndColumnsAreThoseOfASparseMatrix) {
    const Bundle b = sample();
    const SparseMatrix matrix = assemble_with_eigen(b);
    ASSERT_EQ(static_cast<std::size_t>(matrix.nonZeros()), b.column.size());
    for (std::size_t row = 0; row < b.row_start.size(); ++row)
        EXPECT_EQ(static_cast<Index>(matrix.outerIndexPtr()[row]), b.row_start[row]);
    for (std::size_t k = 0; k < b.column.size(); ++k)
        EXPECT_EQ(static_cast<Index>(matrix.innerIndexPtr()[k]), b.column[k]);
}

TEST(BakeOracle, ScatteringThroughElementSlotsAssemblesTheSameMatrix) {
    const Bundle b = sample();
    const SparseMatrix matrix = assemble_with_eigen(b);
    std::vector<double> blocks(b.column.size(), 0.0);
    for (std::size_t t = 0; t < b.solver_tet_count; ++t) {
        for (std::size_t k = 0; k < 16; ++k) blocks[b.element_slots[t][k]] += element_value(b, t, k / 4, k % 4);
    }
    for (std::size_t k = 0; k < blocks.size(); ++k) EXPECT_NEAR(blocks[k], matrix.valuePtr()[k], 1e-12);
}

// solver.md 4.3: each edge gathers from its tets, each row's diagonal is minus the sum of the rest of its row.
TEST(BakeOracle, GatheringByEdgeAssemblesTheSameMatrix) {
    const Bundle b = sample();
    const SparseMatrix matrix = assemble_with_eigen(b);
    std::vector<double> blocks(b.column.size(), 0.0);
    for (std::size_t e = 0; e < b.edges.size(); ++e) {
        double sum = 0;
        for (Index k = b.edge_start[e]; k < b.edge_start[e + 1]; ++k) {
            sum += element_value(b, b.edge_tet[k], b.edge_corners[k][0], b.edge_corners[k][1]);
        }
        blocks[b.edge_slots[e][0]] = sum;
        blocks[b.edge_slots[e][1]] = sum;
    }
    for (std::size_t row = 0; row < b.diagonal.size(); ++row) {
        double sum = 0;
        for (Index k = b.row_start[row]; k < b.row_start[row + 1]; ++k) sum += k == b.diagonal[row] ? 0 : blocks[k];
        blocks[b.diagonal[row]] = -sum;
    }
    for (std::size_t k = 0; k < blocks.size(); ++k) EXPECT_NEAR(blocks[k], matrix.valuePtr()[k], 1e-11);
}

TEST(BakeOracle, InverseRestIsThatOfTheDoubleMatrixTo1em5Cond) {
    const Bundle b = sample();
    for (std::size_t t = 0; t < b.tets.size(); ++t) {
        const Eigen::Matrix3d dm = rest_edges(b, t);
        const Eigen::Vector3d singular = dm.jacobiSvd().singularValues();
        const Eigen::Matrix<float, 3, 3, Eigen::RowMajor> stored(b.inverse_rest[t].data());
        const Eigen::Matrix3d rest = stored.cast<double>() * dm - Eigen::Matrix3d::Identity();
        EXPECT_LT(rest.norm(), 1e-5 * singular(0) / singular(2)) << "tet " << t;
        EXPECT_NEAR(b.volume[t], dm.determinant() / 6, 1e-6 * b.volume[t]);
    }
}

TEST(BakeOracle, MassesAreAQuarterOfEachTetsInDouble) {
    const Bundle b = sample();
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(static_cast<int>(b.mass.size()));
    for (std::size_t t = 0; t < b.tets.size(); ++t) {
        for (const Index node : b.tets[t])
            mass(node) += b.materials[b.material[t]].density_kg_m3 * rest_edges(b, t).determinant() / 24;
    }
    for (std::size_t node = 0; node < b.mass.size(); ++node)
        EXPECT_NEAR(b.mass[node], mass(static_cast<int>(node)), 1e-6 * b.mass[node]);
}
