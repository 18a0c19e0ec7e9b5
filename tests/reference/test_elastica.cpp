// SPDX-License-Identifier: GPL-3.0-or-later
// A5: the runtime solver's cantilever, 20 x 1 with k = P L^2 / (E I) to 10, against the elastica, the mesh extrapolated
// away. As wide as the elastica is, not at all: one cell across and nu = 0, so nothing depends on that direction.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "solver/body.h"
#include "solver/effort.h"

namespace crumple {
namespace {

constexpr float bar_length = 20;

// Of the length: how far the end comes back and down.
struct Tip {
    double along = 0, down = 0;
};

struct Elastica {
    double k;
    Tip tip;
};

// Runge-Kutta shooting, five digits; as Mattiasson 1981, "Numerical results from large deflection beam and frame
// problems analysed by means of elliptic integrals".
constexpr Elastica elastica[] = {{0.2, {0.00265, 0.06636}}, {1, {0.05643, 0.30172}}, {2, {0.16064, 0.49346}},
                                 {3, {0.25442, 0.60325}},   {4, {0.32894, 0.66996}}, {5, {0.38763, 0.71379}},
                                 {6, {0.43459, 0.74457}},   {8, {0.50483, 0.78498}}, {10, {0.55500, 0.81061}}};

class Cantilever {
public:
    explicit Cantilever(int cells) : body_(bundle(cells), settings()) {}

    // Where it rests under k, from where it was.
    Tip settle(double k) {
        std::vector<Vec3f> forces(body_.node_count());
        const auto count = static_cast<double>(
            std::count_if(body_.bundle.rest_positions.begin(), body_.bundle.rest_positions.end(), is_tip));
        for (std::size_t i = 0; i < forces.size(); ++i) {
            if (is_tip(body_.rest(i)))
                forces[i].y = static_cast<float>(-k * 1e6 / 12 / (bar_length * bar_length) / count);
        }
        solver::StepInput input;
        input.dt = 2;
        input.forces = forces;
        Tip before = tip();
        for (int step = 0, quiet = 0; step < 400 && quiet < 5; ++step) {
            body_.step(input);
            const Tip now = tip();
            const bool is_quiet = std::hypot(now.along - before.along, now.down - before.down) < 1e-6;
            quiet = is_quiet ? quiet + 1 : 0;
            before = now;
        }
        return before;
    }

private:
    static bool is_tip(Vec3f rest) { return rest.x == bar_length; }

    static Bundle bundle(int cells) {
        Material material = solver::test::elastic_material(1e6, 0);
        // Critical for the first mode at rest, which takes 78 s.
        material.alpha_per_s = 0.15;
        const float cell = 1 / static_cast<float>(cells);
        const int along = static_cast<int>(bar_length) * cells;
        return solver::test::grid_body({along, cells, 1}, {bar_length / static_cast<float>(along), cell, 1}, material,
                                       [](Vec3f p) { return p.x == 0; });
    }

    static solver::Settings settings() {
        solver::Settings settings;
        settings.max_iterations = 5000;
        settings.tolerance = 1e-4;
        return settings;
    }

    [[nodiscard]] Tip tip() const {
        Tip sum;
        double count = 0;
        for (std::size_t i = 0; i < body_.node_count(); ++i) {
            if (!is_tip(body_.rest(i))) continue;
            sum.along += static_cast<double>(bar_length - body_.x(i).x);
            sum.down -= static_cast<double>(body_.x(i).y);
            ++count;
        }
        return {sum.along / count / bar_length, (sum.down / count + 0.5) / bar_length};
    }

    solver::test::Body body_;
};

// A mesh is too stiff by its error, c h^2, so it is 1 / down that is straight in h^2; along goes with down^2.
Tip without_mesh_error(Tip coarse, Tip fine) {
    const auto extrapolate = [](double a, double b) { return (4 * b - a) / 3; };
    const double root = extrapolate(1 / std::sqrt(coarse.along), 1 / std::sqrt(fine.along));
    return {1 / (root * root), 1 / extrapolate(1 / coarse.down, 1 / fine.down)};
}

}

TEST(A5CantileverLarge, TheExtrapolatedMeshIsTheElastica) {
#ifndef NDEBUG
    GTEST_SKIP() << "minutes with sanitizers";
#endif
    const int cells = solver::test::effort(3, 4, 2);
    Cantilever coarse(cells), fine(2 * cells);
    double worst = 0;
    for (const Elastica& truth : elastica) {
        if (truth.k != 0.2 && truth.k != 10 && solver::test::effort(true, false, true)) continue;
        const Tip tip = without_mesh_error(coarse.settle(truth.k), fine.settle(truth.k));
        EXPECT_NEAR(tip.along / truth.tip.along, 1, 0.01) << truth.k;
        EXPECT_NEAR(tip.down / truth.tip.down, 1, 0.01) << truth.k;
        worst = std::max({worst, std::fabs(tip.along / truth.tip.along - 1), std::fabs(tip.down / truth.tip.down - 1)});
    }
    std::printf("A5: elastica within %.4f\n", worst);
}

}
