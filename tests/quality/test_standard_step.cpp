// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/standard_step.h"

#include <gtest/gtest.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "quality/cost.h"
#include "quality/dense_elasticity.h"
#include "quality/node_vectors.h"
#include "quality/uneven_grid.h"

using namespace crumple;
using namespace crumple::quality;

namespace {

TEST(StandardStep, NothingToSolveTakesNoIteration) {
    const TetMesh mesh = shapes::tet_grid(1);
    const ElasticSystem system = assemble(mesh.positions, mesh.tets);
    EXPECT_EQ(count_iterations(system, 1, std::vector<Vec3>(system.size())), 0u);
    EXPECT_EQ(count_iterations(assemble({}, {}), 1, {}), 0u);
}

TEST(StandardStep, TakesAsManyIterationsAsEigens) {
    const TetMesh mesh = uneven_grid(4);
    const ElasticSystem system = assemble(mesh.positions, mesh.tets);
    const DenseSystem dense = dense_system(mesh.positions, mesh.tets);
    for (const double step : {0.05, 0.35, 3.5}) {
        const std::vector<Vec3> b = noise(system.size(), 5);
        const Eigen::VectorXd right = Eigen::Map<const Eigen::VectorXd>(&b[0].x, static_cast<long>(3 * b.size()));
        Eigen::SparseMatrix<double> matrix = (step * step * dense.stiffness).sparseView();
        matrix += Eigen::SparseMatrix<double>(dense.mass.asDiagonal().toDenseMatrix().sparseView());
        Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> peer(matrix);
        peer.setTolerance(1e-4);
        const Eigen::VectorXd x = peer.solve(right);
        ASSERT_EQ(peer.info(), Eigen::Success);
        // Rounding may shift the last iteration.
        EXPECT_NEAR(count_iterations(system, step, b), static_cast<double>(peer.iterations()), 1) << "step " << step;
    }
}

TEST(StandardStep, GivesUpWhereItDoesNotConverge) {
    TetMesh mesh = shapes::tet_grid(3);
    for (Vec3& p : mesh.positions) p.z *= 1e-7;
    const ElasticSystem system = assemble(mesh.positions, mesh.tets);
    EXPECT_EQ(count_iterations(system, 1e4, noise(system.size(), 1)), most_step_iterations);
}

TEST(Cost, IsNothingForAMeshThatCannotBeSimulated) {
    EXPECT_EQ(measure_cost({}, {}).pcg_stiff, 0u);
    TetMesh mesh = shapes::tet_grid(2);
    std::swap(mesh.tets[3][0], mesh.tets[3][1]);
    const Cost cost = measure_cost(mesh.positions, mesh.tets);
    EXPECT_EQ(cost.critical_step_m, 0);
    EXPECT_EQ(cost.pcg_soft, 0u);
}

TEST(Cost, OfARegularTetIsTheIdealStep) {
    TetMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
    mesh.tets = {{0, 1, 2, 3}};
    EXPECT_NEAR(measure_cost(mesh.positions, mesh.tets).dt_ratio, 1, 1e-9);
}

TEST(Cost, IsTheSameForAnyNumberOfThreads) {
    const TetMesh mesh = uneven_grid(6);
    Context many;
    many.jobs = 4;
    const Cost one = measure_cost(mesh.positions, mesh.tets);
    const Cost four = measure_cost(mesh.positions, mesh.tets, many);
    EXPECT_EQ(one.critical_step_m, four.critical_step_m);
    EXPECT_EQ(one.pcg_soft, four.pcg_soft);
    EXPECT_EQ(one.pcg_stiff, four.pcg_stiff);
}

TEST(Cost, DoesNotDependOnScale) {
    TetMesh mesh = uneven_grid(4);
    const Cost cost = measure_cost(mesh.positions, mesh.tets);
    for (Vec3& p : mesh.positions) p = p * 0x1p-20;
    const Cost small = measure_cost(mesh.positions, mesh.tets);
    EXPECT_NEAR(small.dt_ratio, cost.dt_ratio, 1e-9);
    EXPECT_EQ(small.pcg_soft, cost.pcg_soft);
    EXPECT_EQ(small.pcg_stiff, cost.pcg_stiff);
}

TEST(Cost, GrowsWithTheStepAndWithSlivers) {
    const TetMesh good = uneven_grid(5, 0.05);
    const TetMesh bad = uneven_grid(5, 0.2);
    const Cost good_cost = measure_cost(good.positions, good.tets);
    const Cost bad_cost = measure_cost(bad.positions, bad.tets);
    EXPECT_GT(good_cost.pcg_stiff, good_cost.pcg_soft);
    EXPECT_LT(bad_cost.dt_ratio, good_cost.dt_ratio);
    EXPECT_GT(bad_cost.pcg_soft, good_cost.pcg_soft);
}

}
