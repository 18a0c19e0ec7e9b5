// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel_for.h"
#include "core/random.h"

namespace crumple::sample {

namespace {

constexpr std::uint64_t candidate_stream = 0;
// A point on the surface lies on neither side of it, whatever clearance was asked for.
constexpr double least_clearance = 1e-3;
constexpr std::uint64_t blocks_a_draw = 1;  // of four random numbers

double cube(double x) { return x * x * x; }

// Draws places: a cell in proportion to its volume times the density wanted there, then any place in it. Within a cell
// h hardly changes.
class Source {
public:
    explicit Source(const Drawing& drawing)
        : drawing_(drawing), clearance_(std::max(drawing.clearance, least_clearance)) {
        double sum = 0;
        for (const Cell& cell : drawing.cells) {
            sum += cell.volume() * density_in(cell);
            up_to_.push_back(sum);
        }
    }

    // False when the draw hits a place that takes no point.
    [[nodiscard]] bool draw(std::uint64_t number, Candidate& candidate) const;

private:
    [[nodiscard]] double density_in(const Cell& cell) const {
        if (drawing_.density == Density::by_size) return cube(1 / cell.size);
        return cube(1 / drawing_.space.factor_of(cell.sized_by));
    }
    [[nodiscard]] const Cell& pick_cell(double unit) const {
        const auto found = std::upper_bound(up_to_.begin(), up_to_.end(), unit * up_to_.back());
        const auto number = static_cast<std::size_t>(found - up_to_.begin());
        return drawing_.cells[std::min(number, up_to_.size() - 1)];
    }
    [[nodiscard]] bool is_allowed(const Cell& cell, Vec3 p, double away) const;
    [[nodiscard]] double vertex_gap(const Cell& cell, const Candidate& candidate, double away) const;

    const Drawing& drawing_;
    double clearance_;
    std::vector<double> up_to_;  // sums of volume * density over the cells so far
};

// Far enough from the shell, and fillable. Many places are settled by what is known of the cell's centre, `away` from
// p: the distance to the shell changes no faster than the place, h no faster than 0.3 of that.
bool Source::is_allowed(const Cell& cell, Vec3 p, double away) const {
    const double least_gap = clearance_ * cell.least_size(away);
    if (cell.distance + away < least_gap) return false;
    const bool is_watertight = drawing_.space.is_watertight();
    if (is_watertight && !cell.is_fillable && away - cell.distance < least_gap) return false;
    const bool is_surely_far = cell.distance - away >= clearance_ * cell.largest_size(away);
    if (is_surely_far && is_watertight) return cell.is_fillable;
    const Space& space = drawing_.space;
    if (!is_surely_far && distance_at(space, cell, p) < clearance_ * size_at(space, cell, p)) return false;
    return drawing_.space.is_fillable(p);
}

double Source::vertex_gap(const Cell& cell, const Candidate& candidate, double away) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double farthest = drawing_.vertex_gap * candidate.size;
    if (drawing_.vertex_gap <= clearance_ || cell.distance - away >= farthest) return infinity;
    const double gap = drawing_.space.distance_to_vertex(candidate.position, farthest);
    return gap < farthest ? gap / candidate.size : infinity;
}

bool Source::draw(std::uint64_t number, Candidate& candidate) const {
    Rng random(drawing_.seed, candidate_stream);
    random.seek(number * blocks_a_draw);
    const Cell& cell = pick_cell(random.next_unit());
    Vec3 in_cell;
    for (int axis = 0; axis < 3; ++axis) in_cell[axis] = (2 * random.next_unit() - 1) * cell.half;

    candidate.position = round_to_float(cell.centre + in_cell);
    const double away = length(candidate.position - cell.centre) * 1.000001;
    if (!cell.is_clear && !is_allowed(cell, candidate.position, away)) return false;
    candidate.size = size_at(drawing_.space, cell, candidate.position);
    candidate.vertex_gap = vertex_gap(cell, candidate, away);
    return true;
}

}

Draws draw_candidates(const Drawing& drawing, std::uint64_t count, const Context& context) {
    Draws draws;
    if (drawing.cells.empty() || count == 0) return draws;
    const Source source(drawing);
    const std::uint64_t max_tries = 50 * count + 10'000;
    const std::uint64_t block = std::clamp<std::uint64_t>(count, 1024, 1 << 18);
    const auto is_hopeless = [&] { return draws.tries >= 20'000 && draws.candidates.size() * 500 < draws.tries; };
    while (draws.candidates.size() < count && draws.tries < max_tries && !is_hopeless()) {
        std::vector<Candidate> drawn(block);
        std::vector<std::uint8_t> accepted(block);
        parallel_for(context, block, 256, [&](std::size_t begin, std::size_t end) {
            context.stop_if_cancelled();
            for (std::size_t i = begin; i < end; ++i) accepted[i] = source.draw(draws.tries + i, drawn[i]);
        });
        for (std::size_t i = 0; i < block && draws.candidates.size() < count; ++i) {
            if (accepted[i]) draws.candidates.push_back(drawn[i]);
        }
        draws.tries += block;
    }
    return draws;
}

}
