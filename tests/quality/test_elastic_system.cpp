// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/elastic_system.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "quality/dense_elasticity.h"
#include "quality/uneven_grid.h"

using namespace crumple;
using namespace crumple::quality;

namespace {

TEST(ElasticSystem, OfNothingIsEmpty) {
    const ElasticSystem system = assemble({}, {});
    EXPECT_EQ(system.size(), 0u);
    EXPECT_EQ(system.row_start, std::vector<Index>{0});
}

TEST(ElasticSystem, LeavesOutNodesNoTetUses) {
    TetMesh mesh = shapes::tet_grid(1);
    mesh.positions.insert(mesh.positions.begin(), {9, 9, 9});
    for (Tet& tet : mesh.tets) {
        for (Index& v : tet) ++v;
    }
    const ElasticSystem system = assemble(mesh.positions, mesh.tets);
    EXPECT_EQ(system.size(), 8u);
    EXPECT_EQ(system.node.front(), 1u);
    EXPECT_NEAR(std::accumulate(system.mass.begin(), system.mass.end(), 0.0), 1, 1e-15);
}

TEST(ElasticSystem, IsTheTextbookOne) {
    const TetMesh mesh = uneven_grid(2);
    const ElasticSystem system = assemble(mesh.positions, mesh.tets);
    const DenseSystem dense = dense_system(mesh.positions, mesh.tets);
    const double scale = dense.stiffness.cwiseAbs().maxCoeff();
    Eigen::MatrixXd rebuilt = Eigen::MatrixXd::Zero(dense.stiffness.rows(), dense.stiffness.cols());
    for (Index row = 0; row < system.size(); ++row) {
        EXPECT_NEAR(system.mass[row], dense.mass(3 * row), 1e-15);
        for (Index at = system.row_start[row]; at < system.row_start[row + 1]; ++at) {
            for (int i = 0; i < 9; ++i)
                rebuilt(3 * row + i / 3, 3 * system.column[at] + i % 3) = system.stiffness[at][i];
        }
    }
    EXPECT_LT((rebuilt - dense.stiffness).cwiseAbs().maxCoeff(), 1e-13 * scale);
}

TEST(ElasticSystem, RigidMotionsMeetNoResistance) {
    const TetMesh mesh = uneven_grid(3);
    const ElasticSystem system = assemble(mesh.positions, mesh.tets);
    const auto force = [&](auto motion) {
        std::vector<Vec3> x;
        for (const Vec3 p : mesh.positions) x.push_back(motion(p));
        std::vector<Vec3> y(x.size());
        multiply(system, x, y);
        double largest = 0;
        for (const Vec3 f : y) largest = std::max(largest, length(f));
        return largest;
    };
    EXPECT_LT(force([](Vec3) { return Vec3{1, -2, 3}; }), 1e-13);
    EXPECT_LT(force([](Vec3 p) { return cross({0.3, 1, -0.7}, p); }), 1e-13);
    EXPECT_GT(force([](Vec3 p) { return p; }), 0.01) << "while swelling does";
}

}
