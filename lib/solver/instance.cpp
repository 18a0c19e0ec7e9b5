// SPDX-License-Identifier: MIT
#include "solver/instance.h"

#include <algorithm>
#include <cmath>

#include "solver/carrier_load.h"
#include "solver/check_input.h"
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

InstanceReport refused() {
    InstanceReport report;
    report.step.warnings = step_bad_input;
    return report;
}

bool is_finite(const CarrierLoad& load) {
    return std::isfinite(length(load.force)) && std::isfinite(length(load.torque));
}

// Gives the hits to the nodes. What they gave in all, in the frame, N s and N m s about its origin.
Six take_hits(const Model& model, State& state, const Frame& frame, std::span<const Hit> hits) {
    Six given{};
    for (const Hit& hit : hits) {
        const Vec3f point = frame.point(hit.position);
        const Vec3f momentum = frame.vector(hit.momentum);
        strike(model, state, point, momentum);
        add_to(given, 1, push_at(widen(point), widen(momentum)));
    }
    return given;
}

// Without constraints. `wind` is its memory.
StepInput step_input_of(const InstanceInput& input, const Frame& frame, Wind& wind) {
    StepInput step;
    step.dt = input.dt;
    step.gravity = pull_on(input, frame);
    if (input.has_inertia) {
        step.frame_turn = frame.vector(input.carrier.angular_velocity);
        step.frame_turn_rate = frame.vector(input.carrier.angular_acceleration);
    }
    step.has_free_carrier = input.is_carrier_free;
    step.carrier_mass = input.carrier_mass;
    step.forces = input.forces;
    step.reactions = input.reactions;
    if (input.wind) {
        wind = *input.wind;
        wind.velocity = frame.velocity(input.carrier.position, widen(wind.velocity));
        step.wind = &wind;
    }
    return step;
}

// Before the step and its hits.
LoadInput load_input_of(const Model& model, const State& state, const InstanceInput& input) {
    LoadInput load;
    load.dt = static_cast<double>(input.dt);
    load.angular_velocity = input.carrier.angular_velocity;
    load.is_carrier_free = input.is_carrier_free;
    load.carrier_mass = input.carrier_mass;
    load.before = share_of(model, state);
    return load;
}

}

void wake(State& state) noexcept {
    state.header->is_asleep = 0;
    state.header->quiet_s = 0;
}

InstanceReport step_instance(const Model& model, State& state, Workspace& w, const InstanceInput& input,
                             const Settings& settings, const Jobs& jobs) noexcept {
    InstanceReport report;
    if (!is_usable(input)) return refused();
    const Frame frame(input.carrier);
    report.is_asleep = stays_asleep(model, state, w, input, frame);
    if (report.is_asleep) return report;
    Wind wind;
    StepInput step_input = step_input_of(input, frame, wind);
    if (!is_usable(model, state, step_input, settings)) return refused();
    if (is_asleep(state)) wake(state);

    LoadInput load = load_input_of(model, state, input);
    load.given = take_hits(model, state, frame, input.hits);
    step_input.constraints = input.room.first(fill_room(model, state, w, input, frame, report));
    report.step = step(model, state, w, step_input, settings, jobs);
    const Vec3 impulse = report.step.impulse;
    const Vec3 angular = report.step.angular_impulse;
    add_to(load.given, 1, {impulse.x, impulse.y, impulse.z, angular.x, angular.y, angular.z});
    report.load = load_of(model, state, frame, load);
    if (!is_finite(report.load)) {
        report.load = {};
        report.step.warnings |= step_not_finite;
    }
    watch_sleep(model, state, input, report.step, step_input.gravity);
    return report;
}

}
