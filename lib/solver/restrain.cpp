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

Vec3 mean_velocity(const Model& model, const State& state, const Workspace& w) {
    Vec3 momentum;
    double mass = 0;
    for (std::size_t node = 0; node < model.node_count; ++node) {
        momentum += moved(state, w, node) * static_cast<double>(model.bundle.mass[node]);
        mass += model.bundle.mass[node];
    }
    return momentum / mass;
}

struct Slope {
    double along_residual = 0;  // r . d
    double inertia = 0;         // d . M d
};

// Writes the free part d of the velocities into `direction`.
Slope write_direction(const Model& model, const State& state, Workspace& w, const ConstraintCounts& constraints,
                      const RigidLocks& rigid) {
    const bool is_free = constraints.fixed == 0 && constraints.partial == 0 && !rigid.is_active;
    const Vec3 mean = is_free ? mean_velocity(model, state, w) : Vec3{};
    for (std::size_t node = 0; node < model.node_count; ++node) {
        const Vec3 d = w.is_fixed[node] ? Vec3{} : moved(state, w, node) - mean;
        for (int i = 0; i < 3; ++i) w.direction[4 * node + static_cast<std::size_t>(i)] = static_cast<float>(d[i]);
    }
    for (const Partial& partial : w.partials.first(constraints.partial)) {
        keep_free_part(partial, &w.direction[4 * static_cast<std::size_t>(partial.node)]);
    }
    Slope slope;
    for (std::size_t node = 0; node < model.node_count; ++node) {
        for (std::size_t i = 4 * node; i < 4 * node + 3; ++i) {
            const double d = w.direction[i];
            slope.along_residual += d * w.residual[i];
            slope.inertia += d * d * model.bundle.mass[node];
        }
    }
    return slope;
}

void step_back(Workspace& w, std::size_t node_count, RigidLocks& rigid, double t) {
    for (double& change : rigid.change) change *= 1 - t;  // toward standing still
    for (std::size_t i = 0; i < 4 * node_count; ++i) w.change[i] -= static_cast<float>(t) * w.direction[i];
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
              const Solved& solved, RigidLocks& rigid, const Kernels& kernels, const Jobs& jobs) {
    const Slope slope = write_direction(model, state, w, constraints, rigid);
    // A is at least M, hence this bound on the shortening.
    if (!solved.is_too_stiff && !(-slope.along_residual > worthwhile * slope.inertia)) return;
    const double stiffness = solved.is_too_stiff ? 0 : product_with_matrix(model, w, kernels, jobs);
    // Minimum of the sum at v - t d. Where float lost the definiteness of A nothing but standing still is safe.
    const double t = stiffness > 0 ? std::clamp(-slope.along_residual / stiffness, 0.0, 1.0) : 1.0;
    step_back(w, model.node_count, rigid, t);
}

void shorten_change(const Model& model, const State& state, Workspace& w, const ConstraintCounts& constraints,
                    RigidLocks& rigid, double t) {
    (void)write_direction(model, state, w, constraints, rigid);
    step_back(w, model.node_count, rigid, t);
}

}
