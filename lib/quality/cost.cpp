// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/cost.h"

#include <algorithm>
#include <array>

#include "core/parallel_for.h"
#include "geometry/measures.h"
#include "quality/critical_step.h"
#include "quality/element_stiffness.h"
#include "quality/node_vectors.h"
#include "quality/standard_step.h"

namespace crumple::quality {

namespace {

constexpr double soft_reach = 0.2;  // box diagonals that sound travels in a step
constexpr double stiff_reach = 2.0;

// From here on plateaus are short beside the whole, and three solves take longer than the cook.
constexpr std::uint32_t enough_iterations = 1000;

std::uint32_t middle_count(const ElasticSystem& system, double step, const Context& context) {
    std::array<std::uint32_t, 3> counts{};
    counts[0] = count_iterations(system, step, noise(system.size(), 1));
    if (counts[0] >= enough_iterations) return counts[0];
    parallel_for(context, 2, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            context.stop_if_cancelled();
            counts[i + 1] = count_iterations(system, step, noise(system.size(), i + 2));
        }
    });
    std::sort(counts.begin(), counts.end());
    return counts[1];
}

// The size of what is there: nodes that no tet uses do not count.
double diagonal_of(const ElasticSystem& system, std::span<const Vec3> positions) {
    Box box;
    for (const Index v : system.node) box.add(positions[v]);
    return box.diagonal();
}

// 0 when a tet has none, or is turned inside out.
double volume_of(std::span<const Vec3> positions, std::span<const Tet> tets) {
    double sum = 0;
    for (const auto& [a, b, c, d] : tets) {
        const double volume = signed_volume(positions[a], positions[b], positions[c], positions[d]);
        if (!(volume > 0)) return 0;
        sum += volume;
    }
    return sum;
}

}

Cost measure_cost(std::span<const Vec3> positions, std::span<const Tet> tets, const Context& context) {
    Cost cost;
    const double volume = volume_of(positions, tets);
    if (!(volume > 0)) return cost;
    const ElasticSystem system = assemble(positions, tets);
    const double diagonal = diagonal_of(system, positions);
    cost.critical_step_m = critical_step(system);
    cost.dt_ratio = cost.critical_step_m / regular_step(volume / static_cast<double>(tets.size()));
    cost.pcg_soft = middle_count(system, soft_reach * diagonal, context);
    // A longer step is no easier: where the short one does not converge, trying would only cost time.
    const bool is_hopeless = cost.pcg_soft >= most_step_iterations;
    cost.pcg_stiff = is_hopeless ? most_step_iterations : middle_count(system, stiff_reach * diagonal, context);
    return cost;
}

}
