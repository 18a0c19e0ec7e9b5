// SPDX-License-Identifier: GPL-3.0-or-later
// The largest eigenvalue of M^-1/2 K M^-1/2, which has those of M^-1 K, by the method of Lanczos [Golub and Van Loan,
// Matrix Computations, section 10.1]. Vectors are not made orthogonal again: what that costs is copies of eigenvalues
// already found, which do not hurt the largest one [Paige 1980].
#include "quality/critical_step.h"

#include <algorithm>
#include <cmath>

#include "quality/node_vectors.h"

namespace crumple::quality {

namespace {

constexpr int most_iterations = 400;
constexpr int between_checks = 8;
constexpr double tolerance = 1e-7;  // relative growth of the eigenvalue between two checks that is none

// Symmetric tridiagonal.
struct Tridiagonal {
    std::vector<double> diagonal;
    std::vector<double> beside;  // beside[i] couples i and i + 1
};

// Whether every eigenvalue lies below x: then no pivot of x I - T is negative [Sturm].
bool is_bound(const Tridiagonal& t, double x) {
    double pivot = 1;
    for (std::size_t i = 0; i < t.diagonal.size(); ++i) {
        const double coupling = i == 0 ? 0 : t.beside[i - 1] * t.beside[i - 1] / pivot;
        pivot = x - t.diagonal[i] - coupling;
        if (!(pivot > 0)) return false;
    }
    return true;
}

// By bisection, between the largest diagonal element and Gershgorin's bound.
double largest_eigenvalue(const Tridiagonal& t) {
    double low = *std::max_element(t.diagonal.begin(), t.diagonal.end());
    double high = low;
    for (std::size_t i = 0; i < t.diagonal.size(); ++i) {
        const double left = i == 0 ? 0 : t.beside[i - 1];
        const double right = i + 1 == t.diagonal.size() ? 0 : t.beside[i];
        high = std::max(high, t.diagonal[i] + left + right);
    }
    while (high - low > 1e-13 * high) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) break;
        (is_bound(t, middle) ? high : low) = middle;
    }
    return high;
}

std::vector<Vec3> scaled(std::vector<Vec3> values, double factor) {
    for (Vec3& v : values) v = v * factor;
    return values;
}

}

double critical_step(const ElasticSystem& system) {
    if (system.size() == 0) return 0;
    std::vector<double> inverse_root_mass;
    for (const double mass : system.mass) inverse_root_mass.push_back(1 / std::sqrt(mass));
    const std::vector<Vec3> start = noise(system.size(), 1);
    std::vector<Vec3> q = scaled(start, 1 / std::sqrt(dot(start, start)));
    std::vector<Vec3> before(system.size());
    std::vector<Vec3> weighted(system.size());
    std::vector<Vec3> next(system.size());
    Tridiagonal t;
    double known = 0;
    for (int iteration = 1; iteration <= most_iterations; ++iteration) {
        for (std::size_t i = 0; i < q.size(); ++i) weighted[i] = q[i] * inverse_root_mass[i];
        multiply(system, weighted, next);
        for (std::size_t i = 0; i < q.size(); ++i) next[i] = next[i] * inverse_root_mass[i];
        const double alpha = dot(next, q);
        add(next, -alpha, q);
        if (!t.beside.empty()) add(next, -t.beside.back(), before);
        t.diagonal.push_back(alpha);
        const double beta = std::sqrt(dot(next, next));
        const bool is_exhausted = !(beta > 1e-14 * std::fabs(alpha));  // as many vectors as there are
        if (is_exhausted || iteration % between_checks == 0 || iteration == most_iterations) {
            const double eigenvalue = largest_eigenvalue(t);
            const bool has_settled = eigenvalue - known <= tolerance * eigenvalue;
            known = eigenvalue;
            if (is_exhausted || has_settled) break;
        }
        t.beside.push_back(beta);
        before = std::move(q);
        q = scaled(next, 1 / beta);
    }
    return known > 0 ? 2 / std::sqrt(known) : 0;
}

}
