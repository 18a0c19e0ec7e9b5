// SPDX-License-Identifier: MIT
#include "solver/instance.h"

#include <algorithm>
#include <cmath>

#include "solver/measure.h"

namespace crumple::solver {
namespace {

Vec3f pull_on(const InstanceInput& input, const Frame& frame) {
    return frame.vector(input.gravity - (input.has_inertia ? input.carrier.acceleration : Vec3{}));
}

// Whether an obstacle that moves may reach the ball around the sleeping body in this step.
bool is_ball_reached(const StateHeader& header, const InstanceInput& input, const Frame& frame) {
    return std::any_of(input.obstacles.begin(), input.obstacles.end(), [&](const Obstacle& o) {
        const Vec3 centre = frame.point_to_world(header.sleep_centre);
        const Vec3f v = frame.velocity(centre, o.velocity + cross(o.angular_velocity, centre - o.position));
        const float speed = length(v);
        return speed > input.sleep.wake_speed &&
               nearest_surface(o, centre).distance < static_cast<double>(header.sleep_radius + speed * input.dt);
    });
}

// is_fixed and damped_mass are free until the step fills them.
ContactCounts contacts_in(const Model& model, const State& state, Workspace& w, const InstanceInput& input,
                          const Frame& frame, std::span<Constraint> room) {
    return find_contacts(model, state, frame, input.obstacles, pull_on(input, frame), input.dt,
                         w.is_fixed.first(model.node_count), w.damped_mass.first(model.node_count), room);
}

bool touches(const Model& model, const State& state, Workspace& w, const InstanceInput& input, const Frame& frame) {
    std::fill(w.is_fixed.begin(), w.is_fixed.end(), std::uint8_t{0});
    return contacts_in(model, state, w, input, frame, {}).found > 0;
}

// What moves past or away within the ball wakes nobody.
bool stays_asleep(const Model& model, const State& state, Workspace& w, const InstanceInput& input,
                  const Frame& frame) {
    const StateHeader& header = *state.header;
    return header.is_asleep != 0 && input.may_sleep && input.hits.empty() &&
           length(pull_on(input, frame) - header.sleep_pull) <= input.sleep.wake_pull &&
           !(is_ball_reached(header, input, frame) && touches(model, state, w, input, frame));
}

void fall_asleep(const Model& model, State& state, Vec3f pull) {
    StateHeader& header = *state.header;
    Vec3f low = position(state, 0);
    Vec3f high = low;
    for (std::size_t node = 0; node < model.node_count; ++node) {
        for (int i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], position(state, node)[i]);
            high[i] = std::max(high[i], position(state, node)[i]);
        }
    }
    header.sleep_centre = (low + high) * 0.5f;
    header.sleep_radius = length(high - low) * 0.5f;
    header.sleep_pull = pull;
    header.is_asleep = 1;
    header.energy -= kinetic_energy(model, state);
    std::fill(state.velocities.begin(), state.velocities.end(), 0.0f);
}

void watch_sleep(const Model& model, State& state, const InstanceInput& input, const StepReport& step, Vec3f pull) {
    float fastest = 0;
    for (std::size_t node = 0; node < model.node_count; ++node) {
        const Vec3f v = velocity(state, node);
        fastest = std::max(fastest, dot(v, v));
    }
    // Stiffness beyond float makes some nodes slow to answer; those at rest stay there.
    const bool is_quiet =
        fastest < input.sleep.speed * input.sleep.speed && (step.warnings & ~std::uint32_t{step_too_stiff}) == 0;
    state.header->quiet_s = is_quiet ? state.header->quiet_s + input.dt : 0;
    if (input.may_sleep && state.header->quiet_s >= input.sleep.after_s) fall_asleep(model, state, pull);
}

// The caller's constraints and the contacts, one after the other in `room`.
std::size_t fill_room(const Model& model, const State& state, Workspace& w, const InstanceInput& input,
                      const Frame& frame, InstanceReport& report) {
    std::fill(w.is_fixed.begin(), w.is_fixed.end(), std::uint8_t{0});
    const std::size_t given = std::min(input.room.size(), input.constraints.size());
    std::copy_n(input.constraints.begin(), given, input.room.begin());
    for (const Constraint& c : input.constraints) {
        if (c.node < model.node_count) w.is_fixed[c.node] = 1;
    }
    const ContactCounts counts = contacts_in(model, state, w, input, frame, input.room.subspan(given));
    report.contacts = counts.written;
    report.is_room_too_small = counts.written < counts.found || given < input.constraints.size();
    return given + counts.written;
}

// v turned by a rotation vector.
Vec3 turned(Vec3 v, Vec3 turn) {
    const double angle = length(turn);
    if (!(angle > 0)) return v;
    const Vec3 n = turn / angle;
    return v * std::cos(angle) + cross(n, v) * std::sin(angle) + n * (dot(n, v) * (1 - std::cos(angle)));
}

// The change of the rigid body's motion for a push, if its mass lies as the nodes' did at rest.
Six answer_to(const Model& model, const InstanceInput& input, const Six& push) {
    const double more = std::max(1.0, input.carrier_mass / model.rest_mass.mass());
    Six answer = times(inverse_of(model.rest_mass.matrix(), 1e-12), push);
    for (double& x : answer) x /= more;
    return answer;
}

// How it turns once it has turned on for a step: its angular momentum stays where it was in the world.
Vec3 turning_on(const Model& model, Vec3 turn, double dt) {
    const Six spin = times(model.rest_mass.matrix(), {0, 0, 0, turn.x, turn.y, turn.z});
    const Vec3 p = turned(linear_part(spin), turn * -dt);
    const Vec3 l = turned(angular_part(spin), turn * -dt);
    return angular_part(times(inverse_of(model.rest_mass.matrix(), 1e-12), {p.x, p.y, p.z, l.x, l.y, l.z}));
}

// What the nodes have of the whole's momentum beside the rigid body's, whose mass lies as theirs did at rest: in its
// frame they move, and with it they turn where they are now.
struct Share {
    Six moving;
    Matrix6 shifted;  // of the mass, from rest
    Vec3 shift;       // sum of m (x - X)
    [[nodiscard]] Six at(Vec3 turn) const {
        Six sum = times(shifted, {0, 0, 0, turn.x, turn.y, turn.z});
        add_to(sum, 1, moving);
        return sum;
    }
};

Share share_of(const Model& model, const State& state) {
    PointMasses now;
    for (std::size_t node = 0; node < model.node_count; ++node) {
        now.add(static_cast<double>(model.bundle.mass[node]), widen(position(state, node)));
    }
    const PointMasses& rest = model.rest_mass;
    Share share{momentum_of(model, state), now.matrix(), now.centre() * now.mass() - rest.centre() * rest.mass()};
    const Matrix6 before = rest.matrix();
    for (std::size_t i = 0; i < 36; ++i) share.shifted[i] -= before[i];
    return share;
}

Vec3 turn_of(const InstanceInput& input, const Frame& frame) {
    return widen(frame.vector(input.carrier.angular_velocity));
}

// Each pass leaves of the error the part of the mass that has shifted.
constexpr int passes = 8;

// With S the nodes' share, q their shift and J what was given, about the frame's origin:
//     force dt = J - change of S,   torque dt = J - change of S - q x change of the origin's velocity.
CarrierLoad load_of(const Model& model, const State& state, const Frame& frame, const InstanceInput& input,
                    const Share& before, const Six& given) {
    const double dt = static_cast<double>(input.dt);
    const Vec3 turn = turn_of(input, frame);
    const Share after = share_of(model, state);
    Six push = given;
    add_to(push, 1, before.at(turn));
    // What is left to a free carrier depends on how it will turn. Seen from the world the nodes' share turns too.
    Six answer{};
    Vec3 new_turn = turn;
    Vec3 force, torque;
    double last_change = 1e300;
    for (int pass = 0; pass < passes; ++pass) {
        const Six left = after.at(input.is_carrier_free ? turning_on(model, new_turn, dt) : turn);
        const Vec3 lever = cross(before.shift, linear_part(answer));
        force = linear_part(push) - turned(linear_part(left), new_turn * dt);
        torque = angular_part(push) - turned(angular_part(left), new_turn * dt) - lever;
        if (!input.is_carrier_free) break;
        const Six next = answer_to(model, input, {force.x, force.y, force.z, torque.x, torque.y, torque.z});
        const double change = length(angular_part(next) - angular_part(answer));
        // The lever comes with the second pass. A body that has left its carrier behind never settles.
        if (pass > 1 && !(change < last_change)) break;
        last_change = change;
        answer = next;
        new_turn = turn + angular_part(answer);
    }
    return {frame.to_world(force / dt), frame.to_world(torque / dt)};
}

}

void wake(State& state) noexcept {
    state.header->is_asleep = 0;
    state.header->quiet_s = 0;
}

InstanceReport step_instance(const Model& model, State& state, Workspace& w, const InstanceInput& input,
                             const Settings& settings, const Jobs& jobs) noexcept {
    InstanceReport report;
    const Frame frame(input.carrier);
    report.is_asleep = stays_asleep(model, state, w, input, frame);
    if (report.is_asleep) return report;
    if (is_asleep(state)) wake(state);

    const Share before = share_of(model, state);
    Six given{};
    for (const Hit& hit : input.hits) {
        const Vec3f point = frame.point(hit.position);
        const Vec3f momentum = frame.vector(hit.momentum);
        strike(model, state, point, momentum);
        add_to(given, 1, push_at(widen(point), widen(momentum)));
    }
    StepInput step_input;
    step_input.dt = input.dt;
    step_input.gravity = pull_on(input, frame);
    if (input.has_inertia) {
        step_input.frame_turn = frame.vector(input.carrier.angular_velocity);
        step_input.frame_turn_rate = frame.vector(input.carrier.angular_acceleration);
    }
    Wind wind;
    if (input.wind) {
        wind = *input.wind;
        wind.velocity = frame.velocity(input.carrier.position, widen(wind.velocity));
        step_input.wind = &wind;
    }
    step_input.has_free_carrier = input.is_carrier_free;
    step_input.carrier_mass = input.carrier_mass;
    step_input.forces = input.forces;
    step_input.constraints = input.room.first(fill_room(model, state, w, input, frame, report));
    report.step = step(model, state, w, step_input, settings, jobs);
    const Vec3 impulse = report.step.impulse;
    const Vec3 angular = report.step.angular_impulse;
    add_to(given, 1, {impulse.x, impulse.y, impulse.z, angular.x, angular.y, angular.z});
    report.load = load_of(model, state, frame, input, before, given);
    watch_sleep(model, state, input, report.step, step_input.gravity);
    return report;
}

}
