// SPDX-License-Identifier: MIT
#include "solver/carrier_load.h"

#include <algorithm>
#include <cmath>

#include "solver/measure.h"

namespace crumple::solver {
namespace {

// Newton's: two or three are enough while the whole turns by less than a radian in the step.
constexpr int passes = 10;
constexpr double small_angle = 1e-6;  // rad a step: the square of it is round-off

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

    // Of the carrier, which weighs `mass`, or as much as the nodes.
    [[nodiscard]] Matrix6 of_mass(double mass) const {
        Matrix6 all = matrix_;
        for (double& entry : all) entry *= std::max(1.0, mass / mass_);
        return all;
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

// What is left to a carrier depends on how it will turn, since the nodes turn with it: seen from the world their share
// does too. All in the frame as it was before the step.
class Balance {
public:
    Balance(const Model& model, const State& state, Vec3 turn, const LoadInput& input)
        : input_(input),
          turn_(turn),
          body_(model.rest_mass),
          own_(body_.of_mass(input.carrier_mass)),
          after_(share_of(model, state)),
          given_(input.given) {
        add_to(given_, 1, input.before.at(turn));
    }

    // N s and N m s on a carrier whose motion changes by `answer`.
    [[nodiscard]] Six push(const Six& answer) const {
        const Vec3 turn = turn_ + angular_part(answer);
        const Six left = after_.at(input_.is_carrier_free ? body_.turning_on(turn, input_.dt) : turn_);
        const Vec3 lever = cross(input_.before.shift, linear_part(answer));
        const Vec3 force = linear_part(given_) - turned(linear_part(left), turn * input_.dt);
        const Vec3 torque = angular_part(given_) - turned(angular_part(left), turn * input_.dt) - lever;
        return {force.x, force.y, force.z, torque.x, torque.y, torque.z};
    }

    // The change of motion that takes the push it causes. Nodes far out that fly fast make the torque depend on the
    // turning more than the carrier's own inertia does, hence Newton.
    [[nodiscard]] Six answer() const {
        Six answer{};
        for (int pass = 0; pass < passes; ++pass) {
            const Six left = missing(answer);
            const Six more = times(inverse_of(slope(answer, left), 1e-12), left);
            const double change = length(angular_part(more));
            if (!std::isfinite(change)) break;
            add_to(answer, 1, more);
            if (!(change * input_.dt > small_angle)) break;
        }
        return answer;
    }

private:
    [[nodiscard]] Six missing(const Six& answer) const {
        Six left = push(answer);
        add_to(left, -1, times(own_, answer));
        return left;
    }
    // Minus how `missing`, which is `left` there, changes with the answer: by differences where it is not linear.
    [[nodiscard]] Matrix6 slope(const Six& answer, const Six& left) const {
        Matrix6 slope = own_;
        const double step = small_angle / input_.dt;
        for (std::size_t c = 0; c < 3; ++c) {
            Vec3 along;
            along[static_cast<int>(c)] = 1;
            const Vec3 lever = cross(input_.before.shift, along);
            Six beside = answer;
            beside[3 + c] += step;
            const Six then = missing(beside);
            for (std::size_t r = 0; r < 3; ++r) slope[6 * (3 + r) + c] += lever[static_cast<int>(r)];
            for (std::size_t r = 0; r < 6; ++r) slope[6 * r + 3 + c] = (left[r] - then[r]) / step;
        }
        return slope;
    }

    const LoadInput& input_;
    Vec3 turn_;
    RestBody body_;
    Matrix6 own_;
    NodeShare after_;
    Six given_;
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
    const Balance balance(model, state, frame.from_world(input.angular_velocity), input);
    const Six push = balance.push(input.is_carrier_free ? balance.answer() : Six{});
    return {frame.to_world(linear_part(push) / input.dt), frame.to_world(angular_part(push) / input.dt)};
}

}
