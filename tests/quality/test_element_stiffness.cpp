// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/element_stiffness.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/index.h"
#include "core/random.h"

using namespace crumple;
using namespace crumple::quality;

namespace {

using Corners = std::array<Vec3, 4>;
using Vector12 = std::array<double, 12>;
using Matrix12 = std::array<Vector12, 12>;

// K = V [lambda g_i g_j^T + mu g_j g_i^T + mu (g_i . g_j) I], block by block, from the definition.
Matrix12 stiffness_matrix(const Corners& c) {
    const double six_volumes = dot(c[1] - c[0], cross(c[2] - c[0], c[3] - c[0]));
    std::array<Vec3, 4> gradients;
    gradients[1] = cross(c[2] - c[0], c[3] - c[0]) / six_volumes;
    gradients[2] = cross(c[3] - c[0], c[1] - c[0]) / six_volumes;
    gradients[3] = cross(c[1] - c[0], c[2] - c[0]) / six_volumes;
    gradients[0] = -(gradients[1] + gradients[2] + gradients[3]);
    const double mu = 1 / 2.6;
    const double lambda = 0.3 / (1.3 * 0.4);
    Matrix12 k{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            for (int a = 0; a < 3; ++a) {
                for (int b = 0; b < 3; ++b) {
                    double value = lambda * gradients[i][a] * gradients[j][b] + mu * gradients[j][a] * gradients[i][b];
                    if (a == b) value += mu * dot(gradients[i], gradients[j]);
                    k[3 * i + static_cast<std::size_t>(a)][3 * j + static_cast<std::size_t>(b)] =
                        value * six_volumes / 6;
                }
            }
        }
    }
    return k;
}

Vector12 times(const Matrix12& k, const Vector12& x) {
    Vector12 y{};
    for (std::size_t i = 0; i < 12; ++i) {
        for (std::size_t j = 0; j < 12; ++j) y[i] += k[i][j] * x[j];
    }
    return y;
}

double largest_eigenvalue(const Matrix12& k) {
    Vector12 x;
    Rng rng(1);
    for (double& value : x) value = rng.next_unit();
    double eigenvalue = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vector12 y = times(k, x);
        double norm = 0;
        for (const double value : y) norm += value * value;
        eigenvalue = std::sqrt(norm);
        for (std::size_t j = 0; j < 12; ++j) x[j] = y[j] / eigenvalue;
    }
    return eigenvalue;
}

Corners random_tet(Rng& rng) {
    Corners c;
    for (Vec3& p : c) p = {rng.next_unit(), rng.next_unit(), rng.next_unit()};
    if (dot(c[1] - c[0], cross(c[2] - c[0], c[3] - c[0])) < 0) std::swap(c[0], c[1]);
    return c;
}

ElementStiffness measure(const Corners& c) { return measure_stiffness(c[0], c[1], c[2], c[3]); }

TEST(ElementStiffness, FlatAndInvertedTetsHaveNone) {
    EXPECT_EQ(measure_stiffness({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}).step, 0);
    EXPECT_EQ(measure_stiffness({1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}).largest, 0);
}

TEST(ElementStiffness, AgreesWithPowerIterationOnTheWholeMatrix) {
    Rng rng(21);
    for (int i = 0; i < 50; ++i) {
        const Corners c = random_tet(rng);
        const double expected = largest_eigenvalue(stiffness_matrix(c));
        // Power iteration may not have separated close eigenvalues fully.
        EXPECT_NEAR(measure(c).largest / expected, 1, 1e-6) << i;
    }
}

TEST(ElementStiffness, StepIsTwoOverTheHighestFrequency) {
    Rng rng(22);
    const Corners c = random_tet(rng);
    const double volume = dot(c[1] - c[0], cross(c[2] - c[0], c[3] - c[0])) / 6;
    const ElementStiffness stiffness = measure(c);
    EXPECT_NEAR(stiffness.step, 2 / std::sqrt(stiffness.largest / (volume / 4)), 1e-12);
}

TEST(ElementStiffness, StepGrowsWithTheTet) {
    EXPECT_NEAR(regular_step(8) / regular_step(1), 2, 1e-12);
    EXPECT_NEAR(regular_step(1e-18) / regular_step(1), 1e-6, 1e-18);
}

TEST(ElementStiffness, FlatteningATetShortensItsStep) {
    double last = 1e300;
    for (const double height : {1.0, 0.5, 0.1, 1e-3, 1e-6}) {
        const double step = measure_stiffness({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, height}).step;
        EXPECT_LT(step, last);
        EXPECT_GT(step, 0);
        last = step;
    }
}

}
