// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/critical_step.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "quality/dense_elasticity.h"
#include "quality/element_stiffness.h"
#include "quality/node_vectors.h"
#include "quality/quality.h"
#include "quality/uneven_grid.h"

using namespace crumple;
using namespace crumple::quality;

namespace {

double step_of(const TetMesh& mesh) { return critical_step(assemble(mesh.positions, mesh.tets)); }

// 2 / sqrt of the largest eigenvalue of K x = lambda M x, all of them found.
double dense_step(const TetMesh& mesh) {
    const DenseSystem system = dense_system(mesh.positions, mesh.tets);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        system.stiffness, Eigen::MatrixXd(system.mass.asDiagonal()), Eigen::EigenvaluesOnly);
    return 2 / std::sqrt(solver.eigenvalues().maxCoeff());
}

// The same by power iteration, a few thousand rounds.
double power_step(const TetMesh& mesh) {
    const ElasticSystem system = assemble(mesh.positions, mesh.tets);
    std::vector<Vec3> x = noise(system.size(), 77);
    std::vector<Vec3> y(x.size());
    double eigenvalue = 0;
    for (int round = 0; round < 3000; ++round) {
        multiply(system, x, y);
        for (std::size_t i = 0; i < y.size(); ++i) y[i] = y[i] / system.mass[i];
        eigenvalue = std::sqrt(quality::dot(y, y) / quality::dot(x, x));
        const double size = std::sqrt(quality::dot(y, y));
        for (std::size_t i = 0; i < y.size(); ++i) x[i] = y[i] / size;
    }
    return 2 / std::sqrt(eigenvalue);
}

TEST(CriticalStep, OfNothingIsZero) { EXPECT_EQ(critical_step(assemble({}, {})), 0); }

TEST(CriticalStep, OfOneTetIsItsElementStep) {
    TetMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0.25, 0}, {0.5, 1, 0}, {0.25, 0.5, 0.75}};
    mesh.tets = {{0, 1, 2, 3}};
    const double element =
        measure_stiffness(mesh.positions[0], mesh.positions[1], mesh.positions[2], mesh.positions[3]).step;
    EXPECT_NEAR(step_of(mesh), element, 1e-9 * element);
}

TEST(CriticalStep, IsThatOfTheDenseEigenproblem) {
    for (const int cells : {1, 2, 3}) {
        const TetMesh mesh = uneven_grid(cells);
        const double truth = dense_step(mesh);
        EXPECT_NEAR(step_of(mesh), truth, 1e-6 * truth) << cells << " cells";
    }
}

// Where several eigenvalues are nearly or exactly the largest, as on a grid, Lanczos is slowest.
TEST(CriticalStep, FindsTheLargestOfManyAlike) {
    const TetMesh mesh = shapes::tet_grid(4);
    const double truth = dense_step(mesh);
    EXPECT_NEAR(step_of(mesh), truth, 1e-6 * truth);
}

// The eigenvector of a single sliver's is all but zero away from it, the start vector all but zero along it.
TEST(CriticalStep, FindsOneSliverAmongThousands) {
    TetMesh mesh = uneven_grid(8);
    const Tet tet = mesh.tets[1234];
    const Vec3 base = (mesh.positions[tet[0]] + mesh.positions[tet[1]] + mesh.positions[tet[2]]) / 3;
    mesh.positions[tet[3]] = base + (mesh.positions[tet[3]] - base) * 0.05;
    mesh.tets.erase(std::remove_if(mesh.tets.begin(), mesh.tets.end(),
                                   [&](const Tet& t) {
                                       return measure_tet(mesh.positions[t[0]], mesh.positions[t[1]],
                                                          mesh.positions[t[2]], mesh.positions[t[3]])
                                                  .volume <= 0;
                                   }),
                    mesh.tets.end());
    const double truth = power_step(mesh);
    EXPECT_NEAR(step_of(mesh), truth, 1e-5 * truth);
}

TEST(CriticalStep, AgreesWithPowerIterationOnThousandsOfTets) {
    const TetMesh mesh = uneven_grid(10);
    const double truth = power_step(mesh);
    // Power iteration closes in from below on the eigenvalue, so from above on the step.
    EXPECT_LE(step_of(mesh), truth * (1 + 1e-6));
    EXPECT_NEAR(step_of(mesh), truth, 1e-3 * truth);
}

TEST(CriticalStep, IsNoLessThanThatOfTheWorstElement) {
    const TetMesh mesh = uneven_grid(5, 0.2);
    EXPECT_GE(step_of(mesh), summarize(mesh).element_step_m * (1 - 1e-9));
}

TEST(CriticalStep, ScalesWithTheMesh) {
    TetMesh mesh = uneven_grid(3);
    const double step = step_of(mesh);
    for (Vec3& p : mesh.positions) p = p * 1024;
    EXPECT_NEAR(step_of(mesh), 1024 * step, 1e-9 * 1024 * step);
    for (Vec3& p : mesh.positions) p = p * 0x1p-40;
    EXPECT_NEAR(step_of(mesh), 0x1p-30 * step, 1e-9 * 0x1p-30 * step);
}

}
