// SPDX-License-Identifier: MIT
#include "solver/rigid_locks.h"

#include <algorithm>
#include <cmath>

#include "solver/constraints.h"

namespace crumple::solver {
namespace {

using Matrix6 = std::array<double, 36>;
using Mat3d = Mat3T<double>;

Vec3 widen(Vec3f a) { return {a.x, a.y, a.z}; }

Mat3d cross_matrix(Vec3 a) { return {{0, -a.z, a.y, a.z, 0, -a.x, -a.y, a.x, 0}}; }

void add_block(Matrix6& m, int row, int column, const Mat3d& block, double sign) {
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) m[static_cast<std::size_t>(6 * (row + r) + column + c)] += sign * block(r, c);
    }
}

// += s T_i^T B T_j with T = [I, -[x]]
void add_pair(Matrix6& m, const Mat3d& b, Vec3 xi, Vec3 xj, double s) {
    const Mat3d turned = b * cross_matrix(xj);
    add_block(m, 0, 0, b, s);
    add_block(m, 0, 3, turned, -s);
    add_block(m, 3, 0, cross_matrix(xi) * b, s);
    add_block(m, 3, 3, cross_matrix(xi) * turned, -s);
}

Mat3d block_of(const Workspace& w, Index k) {
    Mat3d a;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) a(r, c) = w.blocks[9 * std::size_t{k} + static_cast<std::size_t>(3 * c + r)];
    }
    return a;
}

// Gauss without pivots: the matrix is symmetric and positive definite. All zeros where it is not.
Matrix6 inverse_of(Matrix6 a) {
    Matrix6 inverse{};
    for (std::size_t i = 0; i < 6; ++i) inverse[7 * i] = 1;
    for (std::size_t i = 0; i < 6; ++i) {
        if (!(a[7 * i] > 0)) return {};
        const double over = 1 / a[7 * i];
        for (std::size_t c = 0; c < 6; ++c) {
            a[6 * i + c] *= over;
            inverse[6 * i + c] *= over;
        }
        for (std::size_t r = 0; r < 6; ++r) {
            const double factor = a[6 * r + i];
            if (r == i) continue;
            for (std::size_t c = 0; c < 6; ++c) {
                a[6 * r + c] -= factor * a[6 * i + c];
                inverse[6 * r + c] -= factor * inverse[6 * i + c];
            }
        }
    }
    return inverse;
}

Six times(const Matrix6& m, const Six& v) {
    Six result{};
    for (std::size_t r = 0; r < 6; ++r) {
        for (std::size_t c = 0; c < 6; ++c) result[r] += m[6 * r + c] * v[c];
    }
    return result;
}

bool is_carried(const Model& model, const Workspace& w, std::size_t node) {
    return model.bundle.locked[node] && w.constraint[node] == 0;
}

// T^T of the carried rows of `rows`, which are then 0.
Six take_rows(const Model& model, Workspace& w, std::span<float> rows) {
    Six sum{};
    for (std::size_t node = 0; node < model.node_count; ++node) {
        if (!is_carried(model, w, node)) continue;
        float* row = &rows[4 * node];
        const Vec3 f{row[0], row[1], row[2]};
        const Vec3 turning = cross(widen(model.bundle.rest_positions[node]), f);
        for (int i = 0; i < 3; ++i) {
            sum[static_cast<std::size_t>(i)] += f[i];
            sum[static_cast<std::size_t>(i) + 3] += turning[i];
            row[i] = 0;
        }
    }
    return sum;
}

}

RigidLocks make_rigid_locks(const Model& model, const Workspace& w, double carrier_mass, Vec3f fall) {
    RigidLocks rigid;
    Matrix6 whole{}, mine{};
    double mass = 0;
    for (Index i = 0; i < model.node_count; ++i) {
        const Vec3 x = widen(model.bundle.rest_positions[i]);
        const Mat3d m = Mat3d::identity() * static_cast<double>(model.bundle.mass[i]);
        add_pair(whole, m, x, x, 1);
        mass += model.bundle.mass[i];
        if (!is_carried(model, w, i)) continue;
        rigid.is_active = true;
        // Rows of K give nothing for a rigid motion of all, so the locked part of a row is the mass minus the rest.
        add_pair(mine, Mat3d::identity() * static_cast<double>(w.damped_mass[i]), x, x, 1);
        for (Index k = model.bundle.row_start[i]; k < model.bundle.row_start[i + 1]; ++k) {
            const Index j = model.bundle.column[k];
            if (is_carried(model, w, j)) continue;
            add_pair(mine, block_of(w, k), x, widen(model.bundle.rest_positions[j]), -1);
        }
    }
    if (!rigid.is_active) return rigid;
    const double more = std::isfinite(carrier_mass) ? std::max(0.0, carrier_mass / mass - 1) : 0;
    for (std::size_t i = 0; i < 36; ++i) rigid.own_mass[i] = more * whole[i];
    for (std::size_t i = 0; i < 36; ++i) mine[i] += rigid.own_mass[i];
    // A single locked node or a line of them turns freely about itself.
    double size = 0;
    for (std::size_t i = 0; i < 6; ++i) size = std::max(size, mine[7 * i]);
    for (std::size_t i = 0; i < 6; ++i) mine[7 * i] += 1e-9 * size;
    // The positions have moved since rest, which may cost the symmetry its last digits.
    for (std::size_t r = 0; r < 6; ++r) {
        for (std::size_t c = 0; c < r; ++c)
            mine[6 * r + c] = mine[6 * c + r] = 0.5 * (mine[6 * r + c] + mine[6 * c + r]);
    }
    rigid.inverse = inverse_of(mine);
    rigid.residual = times(rigid.own_mass, {fall.x, fall.y, fall.z, 0, 0, 0});
    return rigid;
}

bool fit_jump(const Model& model, const State& state, const Workspace& w, const StepInput& input, Six& jump) {
    Matrix6 normal{};
    Six right{};
    double asked = 0;
    double size = 0;
    for (std::size_t i = 0; i < input.constraints.size(); ++i) {
        const Constraint& c = input.constraints[i];
        if (c.node >= model.node_count || w.constraint[c.node] != i + 1 || model.bundle.locked[c.node]) continue;
        const Vec3f v = velocity(state, c.node);
        const Vec3 change = widen(constrained_velocity(w, input, c.node, v) - v);
        const double amount = length(change);
        const Vec3 x = widen(position(state, c.node));
        // A plane asks along its normal only; what it asks is along it.
        const Vec3 n = c.kind == ConstraintKind::plane ? widen(c.normal) / length(widen(c.normal)) : Vec3{};
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 along = n;
            if (c.kind != ConstraintKind::plane)
                along = Vec3{axis == 0 ? 1.0 : 0, axis == 1 ? 1.0 : 0, axis == 2 ? 1.0 : 0};
            const Vec3 turning = cross(x, along);
            const Six row{along.x, along.y, along.z, turning.x, turning.y, turning.z};
            for (std::size_t r = 0; r < 6; ++r) {
                right[r] += row[r] * dot(along, change);
                for (std::size_t k = 0; k < 6; ++k) normal[6 * r + k] += row[r] * row[k];
            }
            if (c.kind == ConstraintKind::plane) break;
        }
        asked += amount;
        size = std::max(size, dot(x, x));
    }
    if (!(asked > 0)) return false;
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) most = std::max(most, normal[7 * i]);
    // Little is known of motions no constraint asks for: they are kept small.
    for (std::size_t i = 0; i < 6; ++i) normal[7 * i] += 1e-3 * most * (i < 3 ? 1 : size);
    jump = times(inverse_of(normal), right);
    return true;
}

void start_rigid(RigidLocks& rigid, const Model& model, Workspace& w) {
    if (!rigid.is_active) return;
    const Six load = take_rows(model, w, w.residual);
    for (std::size_t i = 0; i < 6; ++i) rigid.residual[i] += load[i];
}

double precondition_rigid(RigidLocks& rigid) {
    if (!rigid.is_active) return 0;
    rigid.precise = times(rigid.inverse, rigid.residual);
    return dot6(rigid.residual, rigid.precise);
}

void spread_rigid(const RigidLocks& rigid, const Model& model, Workspace& w) {
    if (!rigid.is_active) return;
    for (std::size_t node = 0; node < model.node_count; ++node) {
        if (!is_carried(model, w, node)) continue;
        const Vec3 v = rigid_velocity(rigid.direction, widen(model.bundle.rest_positions[node]));
        for (int i = 0; i < 3; ++i) w.direction[4 * node + static_cast<std::size_t>(i)] = static_cast<float>(v[i]);
    }
}

double gather_rigid(RigidLocks& rigid, const Model& model, Workspace& w) {
    if (!rigid.is_active) return 0;
    const Six own = times(rigid.own_mass, rigid.direction);
    rigid.product = take_rows(model, w, w.product);
    for (std::size_t i = 0; i < 6; ++i) rigid.product[i] += own[i];
    return dot6(rigid.direction, own);
}

void descend_rigid(RigidLocks& rigid, double a) {
    for (std::size_t i = 0; i < 6; ++i) {
        rigid.change[i] += a * rigid.direction[i];
        rigid.residual[i] -= a * rigid.product[i];
    }
}

void turn_rigid(RigidLocks& rigid, double b) {
    for (std::size_t i = 0; i < 6; ++i) rigid.direction[i] = rigid.precise[i] + b * rigid.direction[i];
}

}
