// SPDX-License-Identifier: MIT
#include "solver/measure.h"

#include <algorithm>
#include <cmath>

namespace crumple::solver {
namespace {

// What is due to flow at the begin of the next step is gone already.
double strain_energy(const TetPacket& packet, const TetState& state, std::size_t lane, const Mat3& f, const Mat3& r,
                     double flow) {
    const Mat3 s = transpose(r) * f;
    const int rows[6] = {0, 1, 2, 0, 0, 1};
    const int columns[6] = {0, 1, 2, 1, 2, 2};
    double squared = 0;
    double trace_e = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        const double unit = i < 3 ? 1 : 0;
        const double e = 0.5 * (static_cast<double>(s(rows[i], columns[i])) + s(columns[i], rows[i])) - unit -
                         state.plastic[i][lane];
        squared += (i < 3 ? 1 : 2) * e * e;
        if (i < 3) trace_e += e;
    }
    const double deviator = std::max(0.0, squared - trace_e * trace_e / 3);
    const double size = std::sqrt(deviator);
    const double yield = static_cast<double>(packet.yield_strain[lane]) + state.hardening[lane];
    const double left = size > yield ? size - flow * (size - yield) : size;
    squared += left * left - deviator;
    return packet.stiffness[lane] * (squared + 0.5 * packet.ratio[lane] * trace_e * trace_e);
}

// The part of the strain beyond yield that the next step takes; multiplicative flow is left to it.
double flow_of(const Model& model, const State& state, std::size_t t) {
    if (!state.shapes.empty()) return 0;
    const ModelMaterial& m = model.materials[model.packets[t / packet_size].material[t % packet_size]];
    return flowing_part(m.creep_per_s, state.header->last_dt);
}

constexpr float degenerate = 0.1f;  // of det F: such tets do not flow

}

Mat3 deformation_gradient(const Model& model, const State& state, std::size_t tet) {
    const std::size_t p = tet / packet_size;
    const std::size_t lane = tet % packet_size;
    const auto& rows = state.shapes.empty() ? model.packets[p].gradient : state.shapes[p].gradient;
    Mat3 inverse_rest;
    for (std::size_t i = 0; i < 9; ++i) inverse_rest.m[i] = rows[i][lane];
    const Tet& t = model.bundle.tets[tet];
    const Vec3f x0 = position(state, t[0]);
    return Mat3::from_columns(position(state, t[1]) - x0, position(state, t[2]) - x0, position(state, t[3]) - x0) *
           inverse_rest;
}

Mat3 rotation(const State& state, std::size_t tet) {
    const auto& q = state.tets[tet / packet_size].rotation;
    const std::size_t lane = tet % packet_size;
    return to_matrix({q[0][lane], q[1][lane], q[2][lane], q[3][lane]});
}

float plastic_strain(const Model& model, const State& state, std::size_t tet) {
    const std::size_t p = tet / packet_size;
    const std::size_t lane = tet % packet_size;
    if (!state.shapes.empty()) {
        // F_p = (Dm^-1 F_p^-1)^-1 Dm^-1
        Mat3 shape, rest;
        for (std::size_t i = 0; i < 9; ++i) {
            shape.m[i] = state.shapes[p].gradient[i][lane];
            rest.m[i] = model.packets[p].gradient[i][lane];
        }
        return norm(transpose(cofactor(shape)) * (1 / determinant(shape)) * rest - Mat3::identity());
    }
    float squared = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        const float value = state.tets[p].plastic[i][lane];
        squared += (i < 3 ? 1 : 2) * value * value;
    }
    return std::sqrt(squared);
}

double kinetic_energy(const Model& model, const State& state) {
    double energy = 0;
    for (std::size_t node = 0; node < model.node_count; ++node) {
        const Vec3 v = widen(velocity(state, node));
        energy += 0.5 * model.bundle.mass[node] * dot(v, v);
    }
    return energy;
}

double elastic_energy(const Model& model, const State& state, EnergyRotation which) {
    double energy = 0;
    for (std::size_t t = 0; t < model.tet_count; ++t) {
        const Mat3 f = deformation_gradient(model, state, t);
        const Mat3 last = rotation(state, t);
        energy += strain_energy(model.packets[t / packet_size], state.tets[t / packet_size], t % packet_size, f,
                                which == EnergyRotation::nearest ? rotation_svd_smallest(f, last) : last,
                                determinant(f) > degenerate ? flow_of(model, state, t) : 0);
    }
    return energy;
}

Six momentum_of(const Model& model, const State& state) {
    Six sum{};
    for (std::size_t node = 0; node < model.node_count; ++node) {
        const Vec3 v = widen(velocity(state, node)) * static_cast<double>(model.bundle.mass[node]);
        add_to(sum, 1, push_at(widen(position(state, node)), v));
    }
    return sum;
}

Vec3 linear_momentum(const Model& model, const State& state) { return linear_part(momentum_of(model, state)); }

Vec3 angular_momentum(const Model& model, const State& state) { return angular_part(momentum_of(model, state)); }

}
