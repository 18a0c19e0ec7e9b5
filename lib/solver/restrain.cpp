// SPDX-License-Identifier: MIT
#include "solver/restrain.h"

#include <algorithm>

namespace crumple::solver {
namespace {

// A line search that would change less than this part of the velocities is not worth its product with A.
constexpr double worthwhile = 0.02;

Vec3 moved(const State& state, const Workspace& w, std::size_t node) {
    const Vec3f v = velocity(state, node);
    return {static_cast<double>(v.x) + w.change[4 * node], static_cast<double>(v.y) + w.change[4 * node + 1],
            static_cast<double>(v.z) + w.change[4 * node + 2]};
}

void set_direction(Workspace& w, std::size_t node, Vec3 d) {
    for (int i = 0; i < 3; ++i) w.direction[4 * node + static_cast<std::size_t>(i)] = static_cast<float>(d[i]);
}

// How far the body is from standing still, or from its rigid response, along what is free to change.
struct Way {
    Six locks{};       // of the carrier
    double slope = 0;  // of the sum at its begin
    double inertia = 0;
};

// Writes the way to the target, 0 where the body cannot move as a whole, into `direction`.
Way write_way(const Model& model, const State& state, Workspace& w, const ConstraintCounts& constraints,
              const Whole& whole, const Six& target) {
    for (std::size_t node = 0; node < model.node_count; ++node) {
        const Vec3 to = rigid_velocity(target, widen(position(state, node)));
        set_direction(w, node, w.is_fixed[node] ? Vec3{} : to - moved(state, w, node));
    }
    Way way;
    for (const Partial& p : w.partials.first(constraints.partial)) {
        const Vec3 v = moved(state, w, p.node);
        const Vec3 to = response_velocity(target, p, widen(position(state, p.node)), v);
        set_direction(w, p.node, to - v);
        // Free parts of the gradient are in the residual; this is what a contact that holds adds.
        if (p.is_contact && p.taken_count > 0) {
            const Vec3 n = widen(p.taken);
            way.slope += dot(n, widen(unbalanced(model, w, p.node))) * dot(n, to - v);
        }
    }
    for (std::size_t node = 0; node < model.node_count; ++node) {
        for (std::size_t i = 4 * node; i < 4 * node + 3; ++i) {
            const double d = w.direction[i];
            way.slope -= d * w.residual[i];
            way.inertia += d * d * model.bundle.mass[node];
        }
    }
    if (!whole.locks.is_active) return way;
    way.locks = target;
    add_to(way.locks, -1, whole.locks.change);
    way.slope -= dot6(way.locks, whole.locks.residual);
    way.inertia += dot6(way.locks, times(whole.locks.own_mass, way.locks));
    return way;
}

void go(Workspace& w, std::size_t node_count, Whole& whole, const Way& way, double t) {
    add_to(whole.locks.change, t, way.locks);
    for (std::size_t i = 0; i < 4 * node_count; ++i) w.change[i] += static_cast<float>(t) * w.direction[i];
}

double product_with_matrix(const Model& model, Workspace& w, const Kernels& kernels, const Jobs& jobs) {
    const SolveJob job = solve_job(model, w);
    for_pieces(jobs, model.node_count, nodes_per_piece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
        kernels.multiply(job, begin, end);
        w.sums[piece] = kernels.product_dot(job, begin, end);
    });
    double total = 0;
    for (std::size_t i = 0; i * nodes_per_piece < model.node_count; ++i) total += w.sums[i];
    return total;
}

}

void restrain(const Model& model, const State& state, Workspace& w, const ConstraintCounts& constraints,
              const Solved& solved, Whole& whole, const Kernels& kernels, const Jobs& jobs) {
    const Way way = write_way(model, state, w, constraints, whole, whole.response.haven);
    // A is at least M, hence this bound on the shortening.
    if (!solved.is_too_stiff && !(-way.slope > worthwhile * way.inertia)) return;
    const double stiffness = solved.is_too_stiff ? 0
                                                 : product_with_matrix(model, w, kernels, jobs) +
                                                       dot6(way.locks, times(whole.locks.own_mass, way.locks));
    // Minimum of the sum. Where float lost the definiteness of A nothing but the end of the way is safe.
    const double t = stiffness > 0 ? std::clamp(-way.slope / stiffness, 0.0, 1.0) : 1.0;
    go(w, model.node_count, whole, way, t);
}

void shorten_change(const Model& model, const State& state, Workspace& w, const ConstraintCounts& constraints,
                    Whole& whole, double t) {
    const Way way = write_way(model, state, w, constraints, whole, whole.response.slide);
    go(w, model.node_count, whole, way, t);
}

}
