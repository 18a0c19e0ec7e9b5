// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/standard_step.h"

#include <cmath>

#include "quality/node_vectors.h"

namespace crumple::quality {

namespace {

constexpr double tolerance = 1e-4;

struct Operator {
    const ElasticSystem& system;
    double step_2;
    std::vector<Vec3> inverse_diagonal;

    Operator(const ElasticSystem& of, double step) : system(of), step_2(step * step) {
        for (std::size_t row = 0; row < system.size(); ++row) {
            Index at = system.row_start[row];
            while (system.column[at] != row) ++at;
            const Block& k = system.stiffness[at];
            const double mass = system.mass[row];
            inverse_diagonal.push_back(
                {1 / (mass + step_2 * k[0]), 1 / (mass + step_2 * k[4]), 1 / (mass + step_2 * k[8])});
        }
    }

    void apply(std::span<const Vec3> x, std::span<Vec3> y) const {
        multiply(system, x, y);
        for (std::size_t i = 0; i < x.size(); ++i) y[i] = x[i] * system.mass[i] + y[i] * step_2;
    }

    void precondition(std::span<const Vec3> r, std::span<Vec3> z) const {
        for (std::size_t i = 0; i < r.size(); ++i) {
            const Vec3& d = inverse_diagonal[i];
            z[i] = {r[i].x * d.x, r[i].y * d.y, r[i].z * d.z};
        }
    }
};

}

std::uint32_t count_iterations(const ElasticSystem& system, double step, std::span<const Vec3> b) {
    const Operator matrix(system, step);
    std::vector<Vec3> r(b.begin(), b.end());
    std::vector<Vec3> z(r.size());
    matrix.precondition(r, z);
    std::vector<Vec3> p = z;
    std::vector<Vec3> q(r.size());
    double rz = dot(r, z);
    const double enough = tolerance * std::sqrt(dot(r, r));
    for (std::uint32_t iteration = 0; iteration < most_step_iterations; ++iteration) {
        if (!(std::sqrt(dot(r, r)) > enough)) return iteration;
        matrix.apply(p, q);
        const double alpha = rz / dot(p, q);
        add(r, -alpha, q);
        matrix.precondition(r, z);
        const double rz_next = dot(r, z);
        const double beta = rz_next / rz;
        rz = rz_next;
        for (std::size_t i = 0; i < p.size(); ++i) p[i] = z[i] + beta * p[i];
    }
    return most_step_iterations;
}

}
