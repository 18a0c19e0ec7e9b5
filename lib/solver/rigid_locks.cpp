// SPDX-License-Identifier: MIT
#include "solver/rigid_locks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/constraints.h"

namespace crumple::solver {
namespace {

Mat3d wide_block(const Workspace& w, std::size_t number) {
    const Mat3 block = block_at(w.blocks, number);
    Mat3d a;
    std::copy(block.m.begin(), block.m.end(), a.m.begin());
    return a;
}

// The part of a carried node's row of A that belongs to nodes that are not carried, where there are any.
std::optional<RowMotion> free_part_of(const Model& model, const Workspace& w, Index node) {
    std::optional<RowMotion> row;
    for_row(model.slices, node, [&](Index other, std::size_t number) {
        if (is_carried(model, w, other)) return;
        if (!row) row.emplace();
        row->add(wide_block(w, number), widen(model.bundle.rest_positions[other]));
    });
    return row;
}

}

RigidLocks make_rigid_locks(const Model& model, const Workspace& w, double carrier_mass, Vec3f fall) {
    RigidLocks rigid;
    PointMasses carried;
    Matrix6 mine{};
    for (const Index i : model.locked_nodes) {
        if (!is_carried(model, w, i)) continue;
        rigid.is_active = true;
        const Vec3 x = widen(model.bundle.rest_positions[i]);
        // Rows of K give nothing for a rigid motion of all, so the locked part of a row is the mass minus the rest.
        carried.add(static_cast<double>(w.damped_mass[i]), x);
        if (const auto row = free_part_of(model, w, i)) add_row(mine, x, *row, -1);
    }
    if (!rigid.is_active) return rigid;
    const double more = std::isfinite(carrier_mass) ? std::max(0.0, carrier_mass / model.rest_mass.mass() - 1) : 0;
    rigid.own_mass = model.rest_mass.matrix();
    const Matrix6 own = carried.matrix();
    for (std::size_t i = 0; i < 36; ++i) {
        rigid.own_mass[i] *= more;
        mine[i] += own[i] + rigid.own_mass[i];
    }
    // The positions have moved since rest, which may cost the symmetry its last digits.
    for (std::size_t r = 0; r < 6; ++r) {
        for (std::size_t c = 0; c < r; ++c)
            mine[6 * r + c] = mine[6 * c + r] = 0.5 * (mine[6 * r + c] + mine[6 * c + r]);
    }
    rigid.inverse = inverse_of(mine, 1e-9);
    rigid.fall = times(rigid.own_mass, {fall.x, fall.y, fall.z, 0, 0, 0});
    rigid.residual = rigid.fall;
    return rigid;
}

Six take_carried(const Model& model, const Workspace& w, std::span<float> rows) {
    Six sum{};
    for (const Index node : model.locked_nodes) {
        if (!is_carried(model, w, node)) continue;
        float* row = &rows[4 * std::size_t{node}];
        add_to(sum, 1, push_at(widen(model.bundle.rest_positions[node]), Vec3{row[0], row[1], row[2]}));
        std::fill_n(row, 3, 0.0f);
    }
    return sum;
}

void start_rigid(RigidLocks& rigid, const Model& model, Workspace& w) {
    if (rigid.is_active) add_to(rigid.residual, 1, take_carried(model, w, w.residual));
}

double precondition_rigid(RigidLocks& rigid) {
    if (!rigid.is_active) return 0;
    rigid.precise = times(rigid.inverse, rigid.residual);
    return dot6(rigid.residual, rigid.precise);
}

void spread_rigid(const RigidLocks& rigid, const Model& model, Workspace& w) {
    if (!rigid.is_active) return;
    for (const Index node : model.locked_nodes) {
        if (!is_carried(model, w, node)) continue;
        const Vec3 v = rigid_velocity(rigid.direction, widen(model.bundle.rest_positions[node]));
        for (int i = 0; i < 3; ++i)
            w.direction[4 * std::size_t{node} + static_cast<std::size_t>(i)] = static_cast<float>(v[i]);
    }
}

double gather_rigid(RigidLocks& rigid, const Model& model, Workspace& w) {
    if (!rigid.is_active) return 0;
    const Six own = times(rigid.own_mass, rigid.direction);
    rigid.product = take_carried(model, w, w.product);
    add_to(rigid.product, 1, own);
    return dot6(rigid.direction, own);
}

void descend_rigid(RigidLocks& rigid, double a) {
    add_to(rigid.change, a, rigid.direction);
    add_to(rigid.residual, -a, rigid.product);
}

void turn_rigid(RigidLocks& rigid, double b) {
    for (std::size_t i = 0; i < 6; ++i) rigid.direction[i] = rigid.precise[i] + b * rigid.direction[i];
}

}
