// SPDX-License-Identifier: MIT
#include "solver/solve.h"

#include <algorithm>
#include <cmath>

#include "solver/constraints.h"

namespace crumple::solver {
namespace {

// Below this the recursive residual of float arithmetic is noise: (6e-8)^2 and a little.
constexpr double noise_floor = 1e-13;

class Loops {
public:
    Loops(const Model& model, Workspace& workspace, const Jobs& jobs)
        : model_(model), workspace_(workspace), jobs_(jobs) {}

    // The sum of body(begin, end) over pieces of the nodes, added in order.
    template <class Body>
    double sum(Body&& body) const {
        const std::span<double> sums = workspace_.sums;
        each([&](std::size_t piece, std::size_t begin, std::size_t end) { sums[piece] = body(begin, end); });
        double total = 0;
        for (std::size_t i = 0; i * nodes_per_piece < model_.node_count; ++i) total += sums[i];
        return total;
    }
    template <class Body>
    void each(Body&& body) const {
        for_pieces(jobs_, model_.node_count, nodes_per_piece, body);
    }

private:
    const Model& model_;
    Workspace& workspace_;
    const Jobs& jobs_;
};

// Partials are sorted by node: those of one piece.
std::span<const Partial> partials_between(std::span<const Partial> partials, std::size_t begin, std::size_t end) {
    const auto before = [](const Partial& p, std::size_t node) { return p.node < node; };
    const auto first = std::lower_bound(partials.begin(), partials.end(), begin, before);
    const auto last = std::lower_bound(first, partials.end(), end, before);
    return {first, last};
}

void start_residual(const Model& model, Workspace& w, std::size_t partial_count) {
    std::copy(w.load.begin(), w.load.end(), w.residual.begin());
    std::fill(w.change.begin(), w.change.end(), 0.0f);
    for (std::size_t node = 0; node < model.node_count; ++node) {
        if (w.is_fixed[node]) std::fill_n(&w.residual[4 * node], 4, 0.0f);
    }
    for (const Partial& partial : w.partials.first(partial_count)) {
        keep_free_part(partial, &w.residual[4 * static_cast<std::size_t>(partial.node)]);
    }
}

// change and residual after the best step along the guess; never farther from the solution than before.
void take_guess(const Model& model, Workspace& w, std::span<const Partial> partials, const State& state,
                const FirstGuess& guess, RigidLocks& rigid, const Loops& loops, const Kernels& kernels) {
    const SolveJob job = solve_job(model, w);
    rigid.direction = guess.motion;
    for (std::size_t node = 0; node < model.node_count; ++node) {
        const Vec3f x = position(state, node);
        const Vec3 v = w.is_fixed[node] ? Vec3{} : rigid_velocity(guess.motion, {x.x, x.y, x.z});
        for (int i = 0; i < 3; ++i) w.direction[4 * node + static_cast<std::size_t>(i)] = static_cast<float>(v[i]);
    }
    for (const Partial& p : partials) keep_free_part(p, &w.direction[4 * static_cast<std::size_t>(p.node)]);
    spread_rigid(rigid, model, w);
    double along = rigid.is_active ? dot6(rigid.direction, rigid.residual) : 0;
    for (std::size_t i = 0; i < 4 * model.node_count; ++i) along += static_cast<double>(w.direction[i]) * w.residual[i];
    double stiffness = loops.sum([&](std::size_t b, std::size_t e) {
        kernels.multiply(job, b, e);
        for (const Partial& p : partials_between(partials, b, e)) {
            keep_free_part(p, job.product + 4 * static_cast<std::size_t>(p.node));
        }
        return kernels.product_dot(job, b, e);
    });
    stiffness += gather_rigid(rigid, model, w);
    const double a = along / stiffness;
    if (!(stiffness > 0) || !std::isfinite(a)) return;
    (void)loops.sum([&](std::size_t b, std::size_t e) { return kernels.descend(job, static_cast<float>(a), b, e); });
    descend_rigid(rigid, a);
}

}

SolveJob solve_job(const Model& model, Workspace& w) {
    return {model.bundle.row_start.data(),
            model.bundle.column.data(),
            w.is_fixed.data(),
            w.blocks.data(),
            w.inverse.data(),
            w.change.data(),
            w.residual.data(),
            w.precise.data(),
            w.direction.data(),
            w.product.data()};
}

Solved solve(const Model& model, Workspace& w, std::size_t partial_count, const Settings& settings, const State& state,
             const FirstGuess& guess, RigidLocks& rigid, const Kernels& kernels, const Jobs& jobs) {
    const SolveJob job = solve_job(model, w);
    const Loops loops(model, w, jobs);
    const std::span<const Partial> partials = w.partials.first(partial_count);
    start_residual(model, w, partial_count);
    start_rigid(rigid, model, w);
    if (guess.is_given) take_guess(model, w, partials, state, guess, rigid, loops, kernels);
    const double first =
        loops.sum([&](std::size_t b, std::size_t e) { return kernels.start(job, b, e); }) + precondition_rigid(rigid);
    turn_rigid(rigid, 0);
    const double enough = first * std::max(settings.tolerance * settings.tolerance, noise_floor);
    Solved result;
    result.has_overflowed = !std::isfinite(first);
    double rz = first;
    while (result.iterations < settings.max_iterations && rz > enough) {  // never entered when first is not finite
        spread_rigid(rigid, model, w);
        double pq = loops.sum([&](std::size_t b, std::size_t e) {
            kernels.multiply(job, b, e);
            for (const Partial& p : partials_between(partials, b, e)) {
                keep_free_part(p, job.product + 4 * static_cast<std::size_t>(p.node));
            }
            return kernels.product_dot(job, b, e);
        });
        pq += gather_rigid(rigid, model, w);
        const double a = rz / pq;
        if (!(pq > 0) || !std::isfinite(a)) {
            result.is_too_stiff = true;
            break;
        }
        descend_rigid(rigid, a);
        const double next = loops.sum([&](std::size_t b, std::size_t e) {
            return kernels.descend(job, static_cast<float>(a), b, e);
        }) + precondition_rigid(rigid);
        const auto beta = static_cast<float>(next / rz);
        loops.each([&](std::size_t, std::size_t b, std::size_t e) { kernels.turn(job, beta, b, e); });
        turn_rigid(rigid, next / rz);
        rz = next;
        ++result.iterations;
    }
    // A residual that grew tells the same: in exact arithmetic it ends below where it began.
    result.is_too_stiff = result.is_too_stiff || rz > first;
    result.residual = first > 0 ? static_cast<float>(std::sqrt(std::max(0.0, rz / first))) : 0;
    return result;
}

}
