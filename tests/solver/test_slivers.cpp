// SPDX-License-Identifier: MIT
// S6: tets of tiny angles. Implicit steps stay bounded for any shape and any dt; the work goes up.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/body.h"
#include "solver/effort.h"

namespace crumple::solver::test {
namespace {

constexpr double degrees = 180 / 3.14159265358979;

double total_energy(const Body& body) {
    return kinetic_energy(body.model, body.state) + elastic_energy(body.model, body.state);
}

Vec3 exact_place(Vec3f p) { return {p.x, p.y, p.z}; }

// Of the two faces that meet in the edge of corners i and j.
double dihedral_deg(const std::array<Vec3, 4>& x, std::size_t i, std::size_t j) {
    const std::size_t k = i != 0 && j != 0 ? 0 : (i != 1 && j != 1 ? 1 : 2);
    const std::size_t l = 6 - i - j - k;
    const Vec3 along = (x[j] - x[i]) / length(x[j] - x[i]);
    const auto across = [&](std::size_t corner) {
        const Vec3 way = x[corner] - x[i];
        return way - along * dot(way, along);
    };
    return std::atan2(length(cross(across(k), across(l))), dot(across(k), across(l))) * degrees;
}

double least_dihedral_deg(const std::vector<Vec3f>& positions, const std::vector<Tet>& tets) {
    double least = 180;
    for (const Tet& tet : tets) {
        std::array<Vec3, 4> x;
        for (std::size_t i = 0; i < 4; ++i) x[i] = exact_place(positions[tet[i]]);
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = i + 1; j < 4; ++j) least = std::min(least, dihedral_deg(x, i, j));
        }
    }
    return least;
}

// A cube of 6^3 cells; every other node inside is let down on a face of one of its tets, until that tet or its
// neighbour has an angle this small.
constexpr float cell = 0.1f;

bool is_let_down(Vec3f p) {
    const auto is_odd = [](float v) { return std::lround(v / cell) % 2 == 1; };
    return is_odd(p.x) && is_odd(p.y) && is_odd(p.z);
}

std::vector<Vec3f> let_down(const Bundle& grid, float height) {
    std::vector<Vec3f> positions = grid.rest_positions;
    std::vector<bool> is_done(positions.size());
    for (const Tet& tet : grid.tets) {
        for (std::size_t i = 0; i < 4; ++i) {
            if (is_done[tet[i]] || !is_let_down(grid.rest_positions[tet[i]])) continue;
            is_done[tet[i]] = true;
            Vec3f face[3];
            for (std::size_t k = 0, n = 0; k < 4; ++k) {
                if (k != i) face[n++] = grid.rest_positions[tet[k]];
            }
            const Vec3f across = cross(face[1] - face[0], face[2] - face[0]);
            const Vec3f normal = across / length(across);
            const Vec3f centre = (face[0] + face[1] + face[2]) / 3;
            const float side = dot(grid.rest_positions[tet[i]] - centre, normal) > 0 ? 1.0f : -1.0f;
            positions[tet[i]] = centre + normal * (side * height);
        }
    }
    return positions;
}

Bundle with_slivers(double angle_deg, const Material& material) {
    const Bundle grid = grid_body({6, 6, 6}, {cell, cell, cell}, material);
    float low = 0, high = cell / 2;
    for (int i = 0; i < 30; ++i) {
        const float middle = (low + high) / 2;
        (least_dihedral_deg(let_down(grid, middle), grid.tets) < angle_deg ? low : high) = middle;
    }
    std::vector<Vec3f> positions = let_down(grid, high);
    EXPECT_NEAR(least_dihedral_deg(positions, grid.tets), angle_deg, 0.05 * angle_deg);
    return bundle_of(std::move(positions), grid.tets, material);
}

struct Course {
    std::uint32_t iterations = 0, warnings = 0;  // the most of a step, of any
    float residual = 0;                          // the largest
    double energy = 0;                           // the most, of that at the begin
    bool is_finite = false;
};

Course shake(const Bundle& bundle, std::uint32_t max_iterations, float dt) {
    Settings settings;
    settings.max_iterations = max_iterations;
    settings.tolerance = 1e-4;
    Body body(bundle, settings);
    Rng rng(6);
    body.set_velocities([&](Vec3f) { return random_vector(rng); });
    const double before = total_energy(body);
    Course course;
    for (int i = 0; i < test::effort(25, 600, 5); ++i) {
        const StepReport report = body.step(dt);
        course.iterations = std::max(course.iterations, report.iterations);
        course.residual = std::max(course.residual, report.residual);
        course.warnings |= report.warnings;
        course.energy = std::max(course.energy, total_energy(body) / before);
    }
    course.is_finite = body.is_finite();
    return course;
}

}

// S6. Implicit steps stay bounded for any shape; the work goes up.
TEST(S6Slivers, AFlatBodyOfTinyAnglesStaysBounded) {
    for (const float flat : {1e-1f, 1e-2f, 1e-3f, 1e-4f}) {
        Body body(grid_body({3, 3, 1}, {0.3f, 0.3f, 0.3f * flat}, elastic_material(1e6)));
        Rng rng(6);
        body.set_velocities([&](Vec3f) { return random_vector(rng); });
        const double before = total_energy(body);
        for (int i = 0; i < 100; ++i) body.step(1.0f / 60);
        EXPECT_TRUE(body.is_finite()) << flat;
        // From 1e-3 down, (c dt / h)^2 is 4e6 and more: float cannot hold masses beside such stiffness, the step says
        // so and raises them.
        const bool is_too_stiff = (body.step(1.0f / 60).warnings & step_too_stiff) != 0;
        EXPECT_EQ(is_too_stiff, flat < 5e-3f) << flat;
        EXPECT_LT(total_energy(body), (is_too_stiff ? 2 : 1.05) * before) << flat;
    }
}

// Of .1 and .01 degrees (c dt / h)^2 is 1e8 and 1e10: float cannot always hold masses beside such stiffness, and the
// step may say so. Of 1 degree, 1e6, it can.
TEST(S6Slivers, SolvesConvergeAndEnergyStaysBoundedWithAnglesDownToAHundredthOfADegree) {
    for (const double angle : {1.0, 0.1, 0.01}) {
        const Bundle bundle = with_slivers(angle, elastic_material(1e6));
        const auto allowed = static_cast<std::uint32_t>(angle < 1 ? static_cast<int>(step_too_stiff) : 0);
        for (const float rate : {30.0f, 240.0f}) {
            const Course solved = shake(bundle, 2000, 1 / rate);
            const Course cut = shake(bundle, 20, 1 / rate);
            for (const Course& course : {solved, cut}) {
                EXPECT_TRUE(course.is_finite) << angle << " " << rate;
                EXPECT_LE(course.energy, 1.01) << angle << " " << rate;
                EXPECT_EQ(course.warnings & ~allowed, 0u) << angle << " " << rate;
            }
            EXPECT_LT(solved.iterations, 2000u) << angle << " " << rate;
            if (solved.warnings == 0) {
                EXPECT_LT(solved.residual, 1.1e-4) << angle << " " << rate;
            }
            // What the iterations say of the condition: its <= sqrt(condition) / 2 ln(2 / residual).
            const double condition = std::pow(2 * solved.iterations / std::log(2 / 1e-4), 2);
            std::printf("S6: %g deg, %g Hz: %u iterations, condition above %.0f; after 20 the residual is %.3f\n",
                        angle, static_cast<double>(rate), solved.iterations, condition,
                        static_cast<double>(cut.residual));
        }
    }
}

}
