// SPDX-License-Identifier: MIT
#include "solver/touching.h"

#include <algorithm>
#include <cmath>

#include "solver/constraints.h"

namespace crumple::solver {
namespace {

// m/s beyond which a node is past its contact, as a part of what it is prescribed or moves with.
constexpr float hair = 1e-5f;

Vec3f row(std::span<const float> rows, std::size_t node) {
    return {rows[4 * node], rows[4 * node + 1], rows[4 * node + 2]};
}
void set_row(std::span<float> rows, std::size_t node, Vec3f v) {
    for (int i = 0; i < 3; ++i) rows[4 * node + static_cast<std::size_t>(i)] = v[i];
}

// How much faster than allowed the node nears its obstacle; below 0: slower.
float excess(const State& state, const Workspace& w, const Partial& p) {
    return p.least - dot(p.taken, velocity(state, p.node) + row(w.change, p.node));
}

float noise(const State& state, const Workspace& w, const Partial& p) {
    return hair * (std::abs(p.least) + length(velocity(state, p.node)) + length(row(w.change, p.node)));
}

// change += d at a node; the residual follows, rows of carried nodes as part of the locks.
void shift(const Model& model, Workspace& w, RigidLocks& locks, Index node, Vec3f d) {
    set_row(w.change, node, row(w.change, node) + d);
    for_row(model.slices, node, [&](Index j, std::size_t number) {
        // The block of (j, node) is the transpose.
        const Vec3f taken = transpose(block_at(w.blocks, number)) * d;
        if (locks.is_active && is_carried(model, w, j)) {
            add_to(locks.residual, -1, push_at(widen(model.bundle.rest_positions[j]), widen(taken)));
        } else if (!w.is_fixed[j]) {
            set_row(w.residual, j, row(w.residual, j) - taken);
        }
    });
}

}

void hold_touching(const Model& model, const State& state, Workspace& w, std::span<Partial> partials) {
    for (Partial& p : partials) {
        if (p.is_contact && excess(state, w, p) < -noise(state, w, p)) {
            p.taken_count = 0;
            constrain_inverse(model, w, p);
        }
        keep_free_part(p, &w.residual[4 * std::size_t{p.node}]);
    }
}

bool recheck_contacts(const Model& model, const State& state, Workspace& w, std::span<Partial> partials,
                      RigidLocks& locks, RigidModes* modes, Recheck what) {
    bool has_changed = false;
    for (Partial& p : partials) {
        if (!p.is_contact) continue;
        const float past = excess(state, w, p);
        if (p.taken_count == 0 && past > noise(state, w, p)) {
            shift(model, w, locks, p.node, p.taken * past);
            p.taken_count = 1;
        } else if (what == Recheck::all && p.taken_count == 1 && dot(unbalanced(model, w, p.node), p.taken) < 0) {
            p.taken_count = 0;
            set_row(w.residual, p.node, -unbalanced(model, w, p.node));
        } else {
            continue;
        }
        constrain_inverse(model, w, p);
        if (modes) modes->follow(model, state, w, p);
        has_changed = true;
    }
    if (!has_changed) return false;
    for (const Partial& p : partials) keep_free_part(p, &w.residual[4 * std::size_t{p.node}]);
    return true;
}

}
