// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/candidates.h"

#include <algorithm>
#include <cmath>

#include "core/parallel_for.h"
#include "core/random.h"

namespace crumple::sample {

namespace {

constexpr std::uint64_t candidate_stream = 0;
constexpr std::uint64_t blocks_a_draw = 2;  // of four random numbers

double cube(double x) { return x * x * x; }

// The wanted density where h is `size`, and its bound within a cell.
class Target {
public:
    explicit Target(const Drawing& drawing) : drawing_(drawing), is_painted_(&drawing.field != &drawing.plain) {}

    [[nodiscard]] double at(Vec3 p, double size) const {
        if (drawing_.density == Density::by_size) return cube(1 / size);
        return is_painted_ ? cube(drawing_.plain.at(p) / size) : 1;
    }
    [[nodiscard]] double bound(const Cell& cell) const {
        // Cells are at most half of h in radius, so their least size is at least 0.85 h.
        if (drawing_.density == Density::by_size) return cube(1 / cell.least_size());
        if (!is_painted_) return 1;
        return cube((drawing_.plain.at(cell.centre) + size_growth * cell.radius()) / cell.least_size());
    }

private:
    const Drawing& drawing_;
    bool is_painted_;
};

class Source {
public:
    explicit Source(const Drawing& drawing) : drawing_(drawing), target_(drawing) {
        double sum = 0;
        for (const Cell& cell : drawing.cells) {
            bounds_.push_back(target_.bound(cell));
            sum += bounds_.back() * cell.volume();
            up_to_.push_back(sum);
        }
    }

    // False when the draw hits a place that takes no point.
    [[nodiscard]] bool draw(std::uint64_t number, Candidate& candidate) const;

private:
    [[nodiscard]] std::size_t pick_cell(double unit) const {
        const auto found = std::upper_bound(up_to_.begin(), up_to_.end(), unit * up_to_.back());
        return std::min<std::size_t>(static_cast<std::size_t>(found - up_to_.begin()), up_to_.size() - 1);
    }
    [[nodiscard]] bool is_allowed(const Cell& cell, const Candidate& candidate) const;
    [[nodiscard]] double vertex_gap(const Cell& cell, const Candidate& candidate) const;

    const Drawing& drawing_;
    Target target_;
    std::vector<double> bounds_;  // of the density in each cell
    std::vector<double> up_to_;   // sums of bound * volume over the cells so far
};

// Rounding may carry a point over the cell's border: far from the origin even a long way.
bool is_within(const Cell& cell, Vec3 p) {
    const Vec3 off = p - cell.centre;
    return std::fmax(std::fabs(off.x), std::fmax(std::fabs(off.y), std::fabs(off.z))) <= cell.half;
}

bool Source::is_allowed(const Cell& cell, const Candidate& candidate) const {
    const bool is_known = is_within(cell, candidate.position);
    if (is_known && cell.is_clear) return true;
    const double wanted = drawing_.clearance * candidate.size;
    // A point on the surface belongs to no side, whatever the clearance.
    const double distance = drawing_.space.distance_to_surface(candidate.position, 2 * candidate.size);
    if (distance < wanted || distance <= 0) return false;
    return (is_known && cell.is_one_material) || drawing_.space.is_fillable(candidate.position);
}

double Source::vertex_gap(const Cell& cell, const Candidate& candidate) const {
    const double farthest = max_vertex_gap * candidate.size;
    const double at_least = cell.distance - length(candidate.position - cell.centre);
    if (at_least >= farthest) return max_vertex_gap;
    return drawing_.space.distance_to_vertex(candidate.position, farthest) / candidate.size;
}

bool Source::draw(std::uint64_t number, Candidate& candidate) const {
    Rng random(drawing_.seed, candidate_stream);
    random.seek(number * blocks_a_draw);
    const std::size_t chosen = pick_cell(random.next_unit());
    const Cell& cell = drawing_.cells[chosen];
    Vec3 in_cell;
    for (int axis = 0; axis < 3; ++axis) in_cell[axis] = (2 * random.next_unit() - 1) * cell.half;
    const double lot = random.next_unit();

    candidate.position = round_to_float(cell.centre + in_cell);
    candidate.size = drawing_.field.at(candidate.position);
    if (lot * bounds_[chosen] > target_.at(candidate.position, candidate.size)) return false;
    if (!is_allowed(cell, candidate)) return false;
    candidate.vertex_gap = vertex_gap(cell, candidate);
    return true;
}

}

Draws draw_candidates(const Drawing& drawing, std::uint64_t count, const Context& context) {
    Draws draws;
    if (drawing.cells.empty() || count == 0) return draws;
    const Source source(drawing);
    const std::uint64_t max_tries = 50 * count + 10'000;
    const std::uint64_t block = std::clamp<std::uint64_t>(count, 1024, 1 << 18);
    while (draws.candidates.size() < count && draws.tries < max_tries) {
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
