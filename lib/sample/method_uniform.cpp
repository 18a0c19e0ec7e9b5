// SPDX-License-Identifier: GPL-3.0-or-later
// Independent uniform points: the baseline. Relaxing has to undo the clumps that chance makes.
#include <algorithm>
#include <numeric>

#include "sample/method.h"

namespace crumple::sample {

namespace {

// Rounded to float two draws can fall on one place. The earlier stays.
void drop_repeated(std::vector<Vec3>& points) {
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        return points[a] != points[b] ? lexicographic_less(points[a], points[b]) : a < b;
    });
    std::vector<std::uint8_t> repeated(points.size());
    for (std::size_t i = 1; i < order.size(); ++i) repeated[order[i]] = points[order[i]] == points[order[i - 1]];
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!repeated[i]) points[kept++] = points[i];
    }
    points.resize(kept);
}

}

Chosen choose_uniform(Drawing drawing, std::uint64_t count, double, const Context& context) {
    drawing.density = Density::even;
    // A few more than needed, for those that repeat.
    const Draws draws = draw_candidates(drawing, count + count / 64 + 4, context);
    Chosen chosen{{}, draws.tries, draws.candidates.size(), 0};
    for (const Candidate& candidate : draws.candidates) chosen.points.push_back(candidate.position);
    drop_repeated(chosen.points);
    if (chosen.points.size() > count) chosen.points.resize(count);
    return chosen;
}

}
