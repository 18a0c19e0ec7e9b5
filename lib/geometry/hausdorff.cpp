// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/hausdorff.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel_for.h"
#include "geometry/measures.h"

namespace crumple {

namespace {

// Centres of the small triangles pointing the same way when each side is cut into n.
void add_pattern(std::vector<SurfaceSample>& samples, Vec3 a, Vec3 b, Vec3 c, Index triangle, int n) {
    for (int i = 0; i < n; ++i) {
        for (int j = 0; i + j < n; ++j) {
            const double u = (i + 1.0 / 3) / n;
            const double v = (j + 1.0 / 3) / n;
            samples.push_back({a + (b - a) * u + (c - a) * v, triangle});
        }
    }
}

void add_corners(std::vector<SurfaceSample>& samples, std::span<const Vec3> positions,
                 std::span<const Triangle> triangles) {
    std::vector<std::uint8_t> seen(positions.size(), 0);
    for (Index t = 0; t < triangles.size(); ++t) {
        for (const Index v : triangles[t]) {
            if (!seen[v]) samples.push_back({positions[v], t});
            seen[v] = 1;
        }
    }
}

}

std::vector<SurfaceSample> sample_surface(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                                          std::size_t count) {
    std::vector<SurfaceSample> samples;
    add_corners(samples, positions, triangles);
    std::vector<double> areas;
    for (const auto& [a, b, c] : triangles)
        areas.push_back(length(area_vector(positions[a], positions[b], positions[c])));
    const double whole = std::accumulate(areas.begin(), areas.end(), 0.0);
    for (Index t = 0; t < triangles.size(); ++t) {
        const double share = whole > 0 ? areas[t] / whole * static_cast<double>(count) : 0;
        // n (n + 1) / 2 points; one triangle alone never takes more than twice the count.
        const int n = std::max(1, static_cast<int>(std::lround((std::sqrt(8 * share + 1) - 1) / 2)));
        add_pattern(samples, positions[triangles[t][0]], positions[triangles[t][1]], positions[triangles[t][2]], t, n);
    }
    return samples;
}

Farthest farthest_sample(std::span<const SurfaceSample> samples, const SurfaceDistance& surface,
                         const std::function<bool(const SurfaceSample&)>& counts, const Context& context) {
    if (surface.empty()) return {};
    std::vector<double> distances(samples.size());
    parallel_for(context, samples.size(), 512, [&](std::size_t begin, std::size_t end) {
        context.stop_if_cancelled();
        Index guess = none;
        for (std::size_t i = begin; i < end; ++i) {
            const SurfaceDistance::Closest closest = surface.closest(samples[i].position, guess);
            distances[i] = closest.distance;
            guess = closest.triangle;
        }
    });
    std::vector<Index> order(samples.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return distances[a] > distances[b]; });
    for (const Index i : order) {
        if (!counts || counts(samples[i])) return {samples[i], distances[i]};
    }
    return {};
}

}
