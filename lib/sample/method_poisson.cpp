// SPDX-License-Identifier: GPL-3.0-or-later
// Points no two of which are nearer than c * h, by throwing darts and shrinking c until as many as wanted stick
// [McCool and Fiume 1992, "Hierarchical Poisson disk sampling distributions"], h varying in space. Evenly spread from
// the start, so that relaxing has little left to do.
#include <algorithm>
#include <cmath>

#include "geometry/bvh.h"
#include "sample/method.h"

namespace crumple::sample {

namespace {

// A dozen candidates a point spread few points better than six do; for many points it makes no difference.
std::uint64_t candidate_count(std::uint64_t points) {
    return std::max<std::uint64_t>(6 * points, std::min<std::uint64_t>(12 * points, 48'000));
}

constexpr double shrink = 0.93;
constexpr double least_part_of_start = 0.02;  // of the first c: then even the densest candidates were thrown
constexpr double vertex_repulsion = 0.7;      // shell vertices keep points away a little less than points do

// Random darts of diameter r fill 38 % of the space [Torquato 2002, section 3.4]: 0.38 / (pi / 6 r^3) = 0.73 / r^3 of
// them a volume. A little above that radius is a good start: the first sweep takes most of the points. Rounded to
// float, which hides that cube roots differ in their last bit between machines.
double first_spacing(double free_size, std::uint64_t count) {
    return static_cast<float>(1.1 * std::cbrt(0.73 * std::max(free_size, 1.0) / static_cast<double>(count)));
}

std::vector<Box> boxes_of(const std::vector<Candidate>& candidates) {
    std::vector<Box> boxes;
    boxes.reserve(candidates.size());
    for (const Candidate& candidate : candidates) boxes.push_back({candidate.position, candidate.position});
    return boxes;
}

// Knows for every candidate the largest spacing at which it may still stick. A point that sticks lowers it around
// itself.
class Darts {
public:
    explicit Darts(const std::vector<Candidate>& candidates) : candidates_(candidates), tree_(boxes_of(candidates)) {
        limits_.reserve(candidates.size());
        for (const Candidate& candidate : candidates) {
            limits_.push_back(candidate.vertex_gap / vertex_repulsion);
        }
    }

    [[nodiscard]] bool may_stick(Index number, double spacing) const { return limits_[number] >= spacing; }

    void stick(Index number, double spacing) {
        const Candidate& dart = candidates_[number];
        const double radius = spacing * dart.size;
        const Vec3 reach{radius, radius, radius};
        tree_.touching({dart.position - reach, dart.position + reach}, [&](Index other) {
            const double apart = length(candidates_[other].position - dart.position);
            limits_[other] = std::min(limits_[other], apart / std::min(candidates_[other].size, dart.size));
            return false;
        });
    }

private:
    const std::vector<Candidate>& candidates_;
    Bvh tree_;
    std::vector<double> limits_;
};

}

Chosen choose_poisson(Drawing drawing, std::uint64_t count, double free_size, const Context& context) {
    if (count == 0) return {};
    const double start = first_spacing(free_size, count);
    drawing.density = Density::by_size;
    drawing.vertex_gap = vertex_repulsion * start;
    const Draws draws = draw_candidates(drawing, candidate_count(count), context);
    Chosen chosen{{}, draws.tries, draws.candidates.size(), 0};
    if (draws.candidates.empty()) return chosen;
    Darts darts(draws.candidates);
    std::vector<Index> waiting(draws.candidates.size());
    for (std::size_t i = 0; i < waiting.size(); ++i) waiting[i] = static_cast<Index>(i);
    for (double spacing = start; spacing > least_part_of_start * start; spacing *= shrink) {
        context.stop_if_cancelled();
        chosen.spacing = spacing;
        std::erase_if(waiting, [&](Index number) {
            if (chosen.points.size() == count || !darts.may_stick(number, spacing)) return false;
            darts.stick(number, spacing);
            chosen.points.push_back(draws.candidates[number].position);
            return true;
        });
        if (chosen.points.size() == count) break;
    }
    return chosen;
}

}
