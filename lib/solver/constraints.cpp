// SPDX-License-Identifier: MIT
#include "solver/constraints.h"

#include <algorithm>
#include <cmath>

namespace crumple::solver {
namespace {

// The taken directions of a constraint, orthonormal; taken_count 0 when they have no length or are parallel.
Partial directions_of(const Constraint& c) {
    Partial partial{c.node, 0, {}, {}, c.kind == ConstraintKind::contact, 0};
    const float normal_length = length(c.normal);
    if (!(normal_length > 0) || !std::isfinite(normal_length)) return partial;
    partial.taken = c.normal / normal_length;
    if (c.kind != ConstraintKind::rail) {
        partial.taken_count = 1;
        partial.least = dot(partial.taken, c.velocity);
        return partial;
    }
    const Vec3f second = c.second - partial.taken * dot(partial.taken, c.second);
    const float second_length = length(second);
    if (!(second_length > 1e-4f * length(c.second)) || !std::isfinite(second_length)) return partial;
    partial.also_taken = second / second_length;
    partial.taken_count = 2;
    return partial;
}

bool is_finite(Vec3f v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_usable(const Constraint& c, std::size_t node_count) {
    if (c.node >= node_count || !is_finite(c.velocity)) return false;
    return c.kind == ConstraintKind::fixed || directions_of(c).taken_count > 0;
}

Mat3 diagonal_block(const Model& model, const Workspace& w, Index node) {
    const std::size_t lane = model.slices.lane[node];
    return block_at(w.blocks, slice_rows * model.slices.start[lane / slice_rows] + lane % slice_rows);
}

// (S A S + (I - S))^-1 - (I - S): the inverse of A on the free directions, 0 on the taken ones. The taken directions
// get the size of A rather than 1, so that the sum is well scaled.
Mat3 free_inverse(const Partial& p, const Mat3& a) {
    Mat3 taken = outer(p.taken, p.taken) * (p.taken_count > 0 ? 1.0f : 0.0f);
    if (p.taken_count == 2) taken = taken + outer(p.also_taken, p.also_taken);
    const Mat3 free = Mat3::identity() - taken;
    const float size = trace(a) / 3;
    const Mat3 filled = free * a * free + taken * size;
    const float det = determinant(filled);
    if (!(det > 0)) return {};
    return transpose(cofactor(filled)) * (1 / det) - taken * (1 / size);
}

void write_inverse(const Mat3& a, float* inverse) {
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) inverse[16 * c + r] = a(r, c);
    }
}

}

Vec3f taken_part(const Partial& p, Vec3f v) {
    if (p.taken_count == 0) return {};
    Vec3f part = p.taken * dot(p.taken, v);
    if (p.taken_count == 2) part += p.also_taken * dot(p.also_taken, v);
    return part;
}

Vec3f unbalanced(const Model& model, const Workspace& w, Index node) {
    Vec3f sum = -Vec3f{w.load[4 * node], w.load[4 * node + 1], w.load[4 * node + 2]};
    for_row(model.slices, node, [&](Index column, std::size_t number) {
        const float* dv = &w.change[4 * static_cast<std::size_t>(column)];
        sum += block_at(w.blocks, number) * Vec3f{dv[0], dv[1], dv[2]};
    });
    return sum;
}

ConstraintCounts gather_constraints(const Model& model, Workspace& w, const StepInput& input) {
    ConstraintCounts counts;
    if (input.has_free_carrier) {
        std::fill(w.is_fixed.begin(), w.is_fixed.end(), std::uint8_t{0});
    } else {
        std::copy(model.bundle.locked.begin(), model.bundle.locked.end(), w.is_fixed.begin());
    }
    std::fill(w.constraint.begin(), w.constraint.end(), 0u);
    for (std::size_t i = 0; i < input.constraints.size(); ++i) {
        const Constraint& c = input.constraints[i];
        if (!is_usable(c, model.node_count)) {
            counts.has_bad = true;
            continue;
        }
        w.constraint[c.node] = static_cast<Index>(i + 1);
        w.is_fixed[c.node] = c.kind == ConstraintKind::fixed;
    }
    for (Index node = 0; node < model.node_count; ++node) {
        counts.fixed += w.is_fixed[node];
        counts.partial += w.constraint[node] != 0 && !w.is_fixed[node];
    }
    return counts;
}

Vec3f constrained_velocity(const Workspace& w, const StepInput& input, Index node, Vec3f v) {
    const Index row = w.constraint[node];
    if (row == 0) return w.is_fixed[node] ? Vec3f{} : v;  // a locked node's v is 0
    const Constraint& c = input.constraints[row - 1];
    if (c.kind == ConstraintKind::fixed) return c.velocity;
    const Vec3f change = taken_part(directions_of(c), c.velocity - v);
    return c.kind == ConstraintKind::contact && dot(change, c.normal) < 0 ? v : v + change;
}

void list_partials(const Model& model, Workspace& w, const StepInput& input) {
    std::size_t count = 0;
    for (Index node = 0; node < model.node_count; ++node) {
        if (w.constraint[node] == 0 || w.is_fixed[node]) continue;
        w.partials[count++] = directions_of(input.constraints[w.constraint[node] - 1]);
    }
}

void keep_free_part(const Partial& partial, float* row) {
    const Vec3f v{row[0], row[1], row[2]};
    const Vec3f kept = v - taken_part(partial, v);
    for (int i = 0; i < 3; ++i) row[i] = kept[i];
}

void constrain_inverse(const Model& model, Workspace& w, std::size_t partial_count) {
    for (std::size_t node = 0; node < model.node_count; ++node) {
        // Locked nodes that are not fixed move with their carrier, which has a preconditioner of its own.
        const bool is_carried = model.bundle.locked[node] && w.constraint[node] == 0;
        if (w.is_fixed[node] || is_carried) write_inverse({}, &w.inverse[inverse_at(node)]);
    }
    for (const Partial& partial : w.partials.first(partial_count)) constrain_inverse(model, w, partial);
}

void constrain_inverse(const Model& model, Workspace& w, const Partial& partial) {
    const Mat3 a = diagonal_block(model, w, partial.node);
    write_inverse(free_inverse(partial, a), &w.inverse[inverse_at(partial.node)]);
}

Vec3f constraint_impulse(const Model& model, const Workspace& w, const Constraint& c) {
    const Vec3f impulse = unbalanced(model, w, c.node);
    if (c.kind == ConstraintKind::fixed) return impulse;
    const Vec3f taken = taken_part(directions_of(c), impulse);
    return c.kind == ConstraintKind::contact && dot(taken, c.normal) < 0 ? Vec3f{} : taken;
}

double constraint_work(const Model& model, const Workspace& w, std::size_t partial_count, const StepInput& input) {
    double work = 0;
    const auto add = [&](const Constraint& c, Vec3f impulse) { work += static_cast<double>(dot(impulse, c.velocity)); };
    for (std::size_t i = 0; i < input.constraints.size(); ++i) {
        const Constraint& c = input.constraints[i];
        if (c.node >= model.node_count || w.constraint[c.node] != i + 1 || c.kind != ConstraintKind::fixed) continue;
        if (!(c.velocity == Vec3f{})) add(c, unbalanced(model, w, c.node));
    }
    for (const Partial& partial : w.partials.first(partial_count)) {
        const Constraint& c = input.constraints[w.constraint[partial.node] - 1];
        // What the solve left undone at a contact that has let go is no push.
        if (partial.taken_count > 0 && !(c.velocity == Vec3f{})) add(c, constraint_impulse(model, w, c));
    }
    return work;
}

void write_reactions(const Model& model, const Workspace& w, std::size_t partial_count, const StepInput& input) {
    for (Index node = 0; node < model.node_count; ++node) {
        input.reactions[node] = w.is_fixed[node] ? unbalanced(model, w, node) / input.dt : Vec3f{};
    }
    for (const Partial& partial : w.partials.first(partial_count)) {
        input.reactions[partial.node] = taken_part(partial, unbalanced(model, w, partial.node)) / input.dt;
    }
}

}
