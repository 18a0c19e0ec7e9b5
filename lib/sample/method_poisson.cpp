// SPDX-License-Identifier: GPL-3.0-or-later
// Points no two of which are nearer than c * h, by throwing darts and shrinking c until as many as wanted stick
// [McCool and Fiume 1992, "Hierarchical Poisson disk sampling distributions"], h varying in space. Evenly spread from
// the start, so that relaxing has little left to do.
#include <algorithm>
#include <cmath>

#include "sample/ball_grid.h"
#include "sample/method.h"

namespace crumple::sample {

namespace {

constexpr std::uint64_t candidates_a_point = 12;
constexpr double shrink = 0.93;
constexpr double least_part_of_start = 0.02;  // of the first c: then even the densest candidates were thrown
constexpr double vertex_repulsion = 0.7;      // shell vertices keep points away a little less than points do

// Random darts of diameter r fill 38 % of the space [Torquato 2002, section 3.4]: 0.38 / (pi / 6 r^3) = 0.73 / r^3 of
// them a volume. A little above that radius is a good start: the first sweep takes most of the points. Rounded to
// float, which hides that cube roots differ in their last bit between machines.
double first_spacing(double free_size, std::uint64_t count) {
    return static_cast<float>(1.1 * std::cbrt(0.73 * std::max(free_size, 1.0) / static_cast<double>(count)));
}

class Darts {
public:
    Darts(const std::vector<Candidate>& candidates, Vec3 origin) : candidates_(candidates), balls_(origin) {}

    // True when the candidate is far enough from all that stick; then it sticks too.
    bool throw_dart(Index number, double spacing) {
        const Candidate& dart = candidates_[number];
        if (dart.vertex_gap < std::min(vertex_repulsion * spacing, max_vertex_gap)) return false;
        const bool is_blocked = balls_.any_at(dart.position, [&](Index other) {
            const Vec3 between = candidates_[other].position - dart.position;
            const double apart = spacing * std::min(candidates_[other].size, dart.size);
            return dot(between, between) < apart * apart;
        });
        if (is_blocked) return false;
        balls_.insert(number, dart.position, spacing * dart.size);
        return true;
    }

private:
    const std::vector<Candidate>& candidates_;
    BallGrid balls_;
};

}

Chosen choose_poisson(Drawing drawing, std::uint64_t count, double free_size, const Context& context) {
    drawing.density = Density::by_size;
    const Draws draws = draw_candidates(drawing, count * candidates_a_point, context);
    Chosen chosen{{}, draws.tries, draws.candidates.size(), 0};
    if (draws.candidates.empty()) return chosen;
    Darts darts(draws.candidates, drawing.space.box().low);
    std::vector<Index> waiting(draws.candidates.size());
    for (std::size_t i = 0; i < waiting.size(); ++i) waiting[i] = static_cast<Index>(i);
    const double start = first_spacing(free_size, count);
    for (double spacing = start; spacing > least_part_of_start * start; spacing *= shrink) {
        context.stop_if_cancelled();
        chosen.spacing = spacing;
        std::erase_if(waiting, [&](Index number) {
            if (chosen.points.size() == count || !darts.throw_dart(number, spacing)) return false;
            chosen.points.push_back(draws.candidates[number].position);
            return true;
        });
        if (chosen.points.size() == count) break;
    }
    return chosen;
}

}
