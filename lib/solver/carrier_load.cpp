// SPDX-License-Identifier: MIT
#include "solver/carrier_load.h"

#include <algorithm>
#include <cmath>

#include "solver/measure.h"

namespace crumple::solver {
namespace {

// Each pass leaves of the error about the part of a radian that the whole turns in the step.
constexpr int passes = 8;

// v turned by a rotation vector.
Vec3 turned(Vec3 v, Vec3 turn) {
    const double angle = length(turn);
    if (!(angle > 0)) return v;
    const Vec3 n = turn / angle;
    return v * std::cos(angle) + cross(n, v) * std::sin(angle) + n * (dot(n, v) * (1 - std::cos(angle)));
}

// The rigid body that the nodes were at rest.
class RestBody {
public:
    explicit RestBody(const PointMasses& masses)
        : mass_(masses.mass()), matrix_(masses.matrix()), inverse_(inverse_of(matrix_, 1e-12)) {}

    // Of the whole as it is now, where the carrier weighs `mass` at least.
    [[nodiscard]] Matrix6 whole(double mass, const NodeShare& share) const {
        Matrix6 sum = share.shifted;
        for (std::size_t i = 0; i < 36; ++i) sum[i] += std::max(1.0, mass / mass_) * matrix_[i];
        return sum;
    }
    // What of a push a change of its motion does not take.
    [[nodiscard]] Six left_of(Six push, const Six& change, double mass) const {
        add_to(push, -std::max(1.0, mass / mass_), times(matrix_, change));
        return push;
    }

    // How it turns once it has turned on for a step: its angular momentum stays where it was in the world.
    [[nodiscard]] Vec3 turning_on(Vec3 turn, double dt) const {
        const Six spin = times(matrix_, {0, 0, 0, turn.x, turn.y, turn.z});
        const Vec3 p = turned(linear_part(spin), turn * -dt);
        const Vec3 l = turned(angular_part(spin), turn * -dt);
        return angular_part(times(inverse_, {p.x, p.y, p.z, l.x, l.y, l.z}));
    }

private:
    double mass_;
    Matrix6 matrix_;
    Matrix6 inverse_;
};

}

Six NodeShare::at(Vec3 turn) const {
    Six sum = times(shifted, {0, 0, 0, turn.x, turn.y, turn.z});
    add_to(sum, 1, moving);
    return sum;
}

NodeShare share_of(const Model& model, const State& state) {
    PointMasses now;
    for (std::size_t node = 0; node < model.node_count; ++node) {
        now.add(static_cast<double>(model.bundle.mass[node]), widen(position(state, node)));
    }
    const PointMasses& rest = model.rest_mass;
    NodeShare share{momentum_of(model, state), now.matrix(), now.centre() * now.mass() - rest.centre() * rest.mass()};
    const Matrix6 before = rest.matrix();
    for (std::size_t i = 0; i < 36; ++i) share.shifted[i] -= before[i];
    return share;
}

CarrierLoad load_of(const Model& model, const State& state, const Frame& frame, const LoadInput& input) {
    const double dt = input.dt;
    const Vec3 turn = frame.from_world(input.angular_velocity);
    const NodeShare after = share_of(model, state);
    const RestBody body(model.rest_mass);
    const Matrix6 inverse = inverse_of(body.whole(input.carrier_mass, after), 1e-12);
    Six push = input.given;
    add_to(push, 1, input.before.at(turn));
    // What is left to a free carrier depends on how it will turn. Seen from the world the nodes' share turns too.
    Six answer{};
    Vec3 new_turn = turn;
    Vec3 force, torque;
    double last_change = 1e300;
    for (int pass = 0; pass < passes; ++pass) {
        const Six left = after.at(input.is_carrier_free ? body.turning_on(new_turn, dt) : turn);
        const Vec3 lever = cross(input.before.shift, linear_part(answer));
        force = linear_part(push) - turned(linear_part(left), new_turn * dt);
        torque = angular_part(push) - turned(angular_part(left), new_turn * dt) - lever;
        if (!input.is_carrier_free) break;
        const Six missing =
            body.left_of({force.x, force.y, force.z, torque.x, torque.y, torque.z}, answer, input.carrier_mass);
        const Six more = times(inverse, missing);
        const double change = length(angular_part(more));
        // What turns by more than a radian in the step never settles.
        if (pass > 1 && !(change < last_change)) break;
        last_change = change;
        add_to(answer, 1, more);
        new_turn = turn + angular_part(answer);
    }
    return {frame.to_world(force / dt), frame.to_world(torque / dt)};
}

}
