// SPDX-License-Identifier: GPL-3.0-or-later
// What moves as it should: volume under large turns, vibration.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "reference/calculix_figures.h"
#include "reference/reference.h"
#include "solver/body.h"

namespace crumple::reference {
namespace {

using solver::test::elastic_material;
using solver::test::grid_body;

// Of a regular tet with corners on a cube.
Bundle regular_tet() {
    Material m = elastic_material(1e5);
    m.alpha_per_s = 8;
    return solver::test::bundle_of({{0, 0, 0}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}}, {{0, 2, 1, 3}}, m);
}

// Turned rigidly by an angle about an axis through its middle, released, at rest again: volume over rest volume.
double volume_after_a_turn(double angle, bool is_linear) {
    const Bundle bundle = regular_tet();
    Body body = body_at_rest(bundle);
    const Vec3 middle{0.5, 0.5, 0.5};
    const Vec3 n = Vec3{1, 2, 2} / 3.0;
    for (Vec3& p : body.positions) {
        const Vec3 r = p - middle;
        p = middle + r * std::cos(angle) + cross(n, r) * std::sin(angle) + n * (dot(n, r) * (1 - std::cos(angle)));
    }
    StepInput input;
    input.is_linear = is_linear;
    for (int i = 0; i < 2000; ++i) step(body, input);
    const Tet& t = bundle.tets[0];
    const auto edge = [&](std::size_t i) { return body.positions[t[i]] - body.positions[t[0]]; };
    return dot(edge(1), cross(edge(2), edge(3))) / 6 / static_cast<double>(bundle.volume[0]);
}

// The lowest mode of the free nodes, K u = w^2 M u.
struct Mode {
    double frequency_hz = 0;
    std::vector<Vec3> shape;  // N, the largest way 1
};

Mode lowest_mode(const Bundle& bundle) {
    std::vector<Eigen::Index> place(bundle.rest_positions.size(), -1);
    Eigen::Index free_count = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (!bundle.locked[i]) place[i] = free_count++;
    }
    const std::vector<Matrix3> upright(bundle.solver_tet_count, Matrix3{1, 0, 0, 0, 1, 0, 0, 0, 1});
    const std::vector<double> scale(bundle.solver_tet_count, 1.0);
    const std::vector<double> blocks = stiffness_by_slots(bundle, upright, scale);
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(3 * free_count, 3 * free_count);
    Eigen::VectorXd root_mass(3 * free_count);
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (place[i] < 0) continue;
        root_mass.segment<3>(3 * place[i]).setConstant(std::sqrt(static_cast<double>(bundle.mass[i])));
        for (Index b = bundle.row_start[i]; b < bundle.row_start[i + 1]; ++b) {
            const Eigen::Index j = place[bundle.column[b]];
            if (j >= 0)
                k.block<3, 3>(3 * place[i], 3 * j) = Eigen::Map<const Eigen::Matrix3d>(&blocks[9 * std::size_t{b}]);
        }
    }
    const Eigen::VectorXd over = root_mass.cwiseInverse();
    const Eigen::MatrixXd scaled = over.asDiagonal() * k * over.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
    const Eigen::VectorXd u = over.cwiseProduct(solver.eigenvectors().col(0));
    Mode mode{std::sqrt(solver.eigenvalues()[0]) / (2 * 3.14159265358979), std::vector<Vec3>(place.size())};
    double most = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (place[i] < 0) continue;
        const auto row = u.segment<3>(3 * place[i]);
        mode.shape[i] = {row[0], row[1], row[2]};
        most = std::max(most, length(mode.shape[i]));
    }
    for (Vec3& way : mode.shape) way = way / most;
    return mode;
}

// Seconds between the first and the third time the mode passes its rest, and the height of the swing one period after
// the start over that at the start.
struct Swing {
    double period_s = 0;
    double kept = 0;
};

Swing swing_of(const Bundle& bundle, const Mode& mode, double dt) {
    solver::Settings settings;
    settings.max_iterations = 2000;
    settings.tolerance = 1e-7;
    solver::test::Body body(bundle, settings);
    constexpr double start = 0.02;
    std::vector<Vec3f> positions = bundle.rest_positions;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vec3 way = mode.shape[i] * start;
        positions[i] += narrow(way);
    }
    move_nodes(body.model, body.state, positions, bundle.rest_positions);
    // How much of the mode there is now.
    const auto amount = [&] {
        double sum = 0, size = 0;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Vec3f way = body.x(i) - body.rest(i);
            const double mass = bundle.mass[i];
            sum += mass * dot(mode.shape[i], Vec3{way.x, way.y, way.z});
            size += mass * dot(mode.shape[i], mode.shape[i]);
        }
        return sum / size / start;
    };
    double before = 1, first = 0, highest = 0;
    Swing swing;
    for (int i = 1, crossings = 0; i < 2000 && crossings < 3; ++i) {
        body.step(static_cast<float>(dt));
        const double now = amount();
        if (crossings == 2) highest = std::max(highest, now);
        if (before * now < 0) {
            const double time = (i - now / (now - before)) * dt;
            ++crossings;
            if (crossings == 1) first = time;
            swing.period_s = time - first;
        }
        before = now;
    }
    swing.kept = highest;
    return swing;
}

}

// A3: linear elasticity sees a turn by phi as a stretch and grows by 1 + sin^2 phi (45 degrees: 1.5); ours does not.
TEST(A3VolumeGrowth, LinearGrowsByItsFormulaAndCorotationalDoesNot) {
    for (const double degrees : {15.0, 30.0, 45.0, 60.0}) {
        const double phi = degrees * 3.14159265358979 / 180;
        const double expected = 1 + std::sin(phi) * std::sin(phi);
        EXPECT_NEAR(volume_after_a_turn(phi, true), expected, 0.01 * expected) << degrees;
        EXPECT_NEAR(volume_after_a_turn(phi, false), 1, 1e-3) << degrees;
    }
}

// A3: linear elasticity sees no strain in F = I + W, W antisymmetric, which is a turn by theta and a growth by
// 1 / cos^2(theta); ours comes back.
TEST(A3VolumeGrowth, LinearRestsInAStateThatHasGrownAndCorotationalDoesNot) {
    const Bundle bundle = regular_tet();
    for (const double degrees : {15.0, 30.0, 45.0, 60.0}) {
        const double theta = degrees * 3.14159265358979 / 180;
        for (const bool is_linear : {true, false}) {
            Body body = body_at_rest(bundle);
            const Vec3 w = Vec3{1, 2, 2} * (std::tan(theta) / 3);
            for (Vec3& p : body.positions) p += cross(w, p);
            StepInput input;
            input.is_linear = is_linear;
            for (int i = 0; i < 2000; ++i) step(body, input);
            const Matrix3 f = deformation_gradient(body, 0);
            const double volume = f[0] * (f[4] * f[8] - f[5] * f[7]) - f[1] * (f[3] * f[8] - f[5] * f[6]) +
                                  f[2] * (f[3] * f[7] - f[4] * f[6]);
            const double grown = 1 / (std::cos(theta) * std::cos(theta));
            EXPECT_NEAR(volume, is_linear ? grown : 1, is_linear ? 0.01 * grown : 1e-3) << degrees;
            if (!is_linear) continue;
            const Matrix3 r = nearest_rotation(f);
            EXPECT_NEAR((r[0] + r[4] + r[8] - 1) / 2, std::cos(theta), 1e-3) << degrees;
        }
    }
}

// A7: an undamped cantilever swings at the lowest frequency of its own mesh; implicit Euler takes w dt / 2 of critical
// damping off it.
TEST(A7Vibration, SwingsAtTheLowestFrequencyOfItsMesh) {
    const Bundle bundle =
        grid_body({16, 2, 2}, {0.5f, 0.5f, 0.5f}, elastic_material(1e6), [](Vec3f p) { return p.x == 0; });
    const Mode mode = lowest_mode(bundle);
    const double frequency = mode.frequency_hz;
    // Linear tets two across are too stiff for the beam's .0798 Hz, by no more than a half.
    EXPECT_GT(frequency, 0.0798);
    EXPECT_LT(frequency, 1.5 * 0.0798);
    // CalculiX spreads the mass, we put it into the nodes.
    EXPECT_NEAR(frequency, calculix::grid_frequency_hz, 0.02 * frequency);
    const double dt = 1 / frequency / 250;
    const Swing swing = swing_of(bundle, mode, dt);
    EXPECT_NEAR(swing.period_s, 1 / frequency, 0.02 / frequency);
    const double damping = 3.14159265358979 * frequency * dt;
    EXPECT_NEAR(swing.kept, std::exp(-2 * 3.14159265358979 * damping), 0.05);
}

}
