// SPDX-License-Identifier: MIT
#include "bundle/longest_steps.h"

#include <cmath>
#include <limits>

#include "bundle/too_light.h"

namespace crumple {
namespace {

// What the simulated tets around a node add up to.
struct NodeSum {
    double stiffness = 0;         // tr K'_ii
    double damped_stiffness = 0;  // of beta K'_ii
    double mass = 0;              // density times volume, for the mean of alpha
    double damped_mass = 0;
};

// lambda + 4 mu
double trace_modulus(const Material& m, double scale) {
    const double mu = m.young_pa * scale / (2 * (1 + m.poisson));
    return mu * (2 * m.poisson / (1 - 2 * m.poisson) + 4);
}

// |g_i|^2 of the four corners: rows of the inverse rest matrix, and what makes the sum of all four zero.
std::array<double, 4> squared_gradients(const std::array<float, 9>& inverse) {
    std::array<double, 4> squared{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double first = 0;
        for (std::size_t row = 0; row < 3; ++row) {
            const double g = inverse[3 * row + axis];
            squared[row + 1] += g * g;
            first -= g;
        }
        squared[0] += first * first;
    }
    return squared;
}

std::vector<NodeSum> sum_up(const Bundle& b) {
    std::vector<NodeSum> sums(b.rest_positions.size());
    for (std::size_t t = 0; t < b.solver_tet_count; ++t) {
        const Material& material = b.materials[b.material[t]];
        const double volume = b.volume[t];
        const double modulus = volume * trace_modulus(material, static_cast<double>(b.stiffness_scale[t]));
        const auto squared = squared_gradients(b.inverse_rest[t]);
        for (std::size_t corner = 0; corner < 4; ++corner) {
            NodeSum& sum = sums[b.tets[t][corner]];
            sum.stiffness += modulus * squared[corner];
            sum.damped_stiffness += material.beta_s * modulus * squared[corner];
            sum.mass += material.density_kg_m3 * volume;
            sum.damped_mass += material.alpha_per_s * material.density_kg_m3 * volume;
        }
    }
    return sums;
}

// The positive root of  a dt^2 + b dt = mass.
double longest_step(const NodeSum& sum, double mass) {
    if (!(sum.stiffness > 0)) return std::numeric_limits<double>::infinity();
    const double lost = static_cast<double>(resolved_by_float) / (3 * static_cast<double>(light_share));
    const double a = lost * sum.stiffness;
    const double b = lost * sum.damped_stiffness - mass * sum.damped_mass / sum.mass;
    const double root = std::sqrt(b * b + 4 * a * mass);
    return b > 0 ? 2 * mass / (root + b) : (root - b) / (2 * a);
}

}

std::vector<double> longest_steps(const Bundle& bundle) {
    const std::vector<NodeSum> sums = sum_up(bundle);
    std::vector<double> steps;
    steps.reserve(sums.size());
    for (std::size_t node = 0; node < sums.size(); ++node) {
        steps.push_back(longest_step(sums[node], static_cast<double>(bundle.mass[node])));
    }
    return steps;
}

}
