// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/player.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "core/parallel_for.h"
#include "solver/skin.h"

namespace crumple::study {

namespace {

solver::Settings settings_of(const Scene& scene) {
    solver::Settings settings;
    settings.max_iterations = scene.iterations;
    settings.plasticity = scene.plasticity;
    settings.treatment = scene.treatment;
    return settings;
}

solver::BundleView checked_view(const Bundle& bundle) {
    const solver::BundleView view = solver::view_of(bundle);
    if (const char* problem = first_problem(view)) {
        throw Error(ErrorKind::bad_input, std::string("the bundle cannot be stepped: ") + problem);
    }
    return view;
}

// The library's threads as the solver wants them.
solver::Jobs jobs_of(const Context& context) {
    if (context.jobs < 2) return {};
    return {[](void* user, std::size_t count, solver::Jobs::Task task, void* of_task) {
                parallel_for(*static_cast<const Context*>(user), count, 1, [&](std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i) task(of_task, i);
                });
            },
            const_cast<Context*>(&context)};
}

Vec3 turn_of(const Scene& scene) { return scene.angular_velocity_deg * (3.14159265358979 / 180); }

}

Player::Player(const Bundle& bundle, const Scene& scene, const Context& context)
    : bundle_(bundle),
      scene_(scene),
      context_(context),
      settings_(settings_of(scene)),
      view_(checked_view(bundle)),
      model_memory_(solver::model_bytes(view_)),
      model_(solver::build_model(view_, model_memory_.get())),
      state_memory_(solver::state_bytes(model_, scene.plasticity)),
      workspace_memory_(solver::workspace_bytes(model_)),
      state_(solver::make_state(model_, scene.plasticity, state_memory_.get())),
      workspace_(solver::make_workspace(model_, workspace_memory_.get())),
      carrier_(bundle, scene.velocity, turn_of(scene)),
      room_(2 * model_.node_count),
      sensor_memories_(bundle.sensors.size()) {
    has_locks_ = std::any_of(bundle.locked.begin(), bundle.locked.end(), [](auto locked) { return locked != 0; });
    rides_ = has_locks_ && scene.carrier == Carrier::dynamic;
    if (!rides_) start_moving();
    for (const SceneObstacle& o : scene.obstacles) obstacles_.push_back(place_obstacle(o, bundle, scene.velocity));
    place_handles();
}

// Without a rigid body to ride on the nodes themselves move.
void Player::start_moving() {
    const Vec3 middle = box_of(bundle_).middle();
    const Vec3 turn = turn_of(scene_);
    for (std::size_t n = 0; n < model_.node_count; ++n) {
        const Vec3 v = scene_.velocity + cross(turn, widen(bundle_.rest_positions[n]) - middle);
        if (!bundle_.locked[n]) set_velocity(state_, n, narrow(v));
    }
}

void Player::place_handles() {
    for (const SceneHandle& h : scene_.handles) {
        handles_.push_back(std::make_unique<PlacedHandle>(h, bundle_));
        if (!handles_.back()->nodes.empty()) continue;
        throw Error(ErrorKind::usage, "handles[" + std::to_string(handles_.size() - 1) +
                                          "]: no node lies in its box; it is in parts of the body's box, -1 to 1");
    }
}

// Constraints of the handles, at the front of room_; how many.
std::size_t Player::drive_handles(double time_s, float dt) {
    std::size_t driven = 0;
    for (const auto& handle : handles_) {
        driven += drive(model_, state_, handle->handle, static_cast<float>(time_s), dt,
                        std::span(room_).first(model_.node_count).subspan(driven));
    }
    return driven;
}

void Player::step(double time_s, float dt) {
    const std::size_t driven = drive_handles(time_s, dt);
    given_.assign(room_.begin(), room_.begin() + static_cast<std::ptrdiff_t>(driven));
    solver::InstanceInput input;
    input.dt = dt;
    if (rides_) input.carrier = carrier_.motion();
    input.is_carrier_free = rides_;
    input.gravity = scene_.gravity;
    input.obstacles = obstacles_;
    input.constraints = given_;
    input.room = room_;
    input.may_sleep = handles_.empty();
    report_ = step_instance(model_, state_, workspace_, input, settings_, jobs_of(context_));
    if (rides_) carrier_.step(report_.load, scene_.gravity, dt);
    for (solver::Obstacle& o : obstacles_) o.position += o.velocity * static_cast<double>(dt);
}

solver::SensorReading Player::read_sensor(std::size_t sensor, float since_s) {
    return solver::read_sensor(model_, state_, solver::view_of(bundle_.sensors[sensor]), sensor_memories_[sensor],
                               since_s, motion());
}

std::vector<Vec3f> Player::skinned(const BundleVisual& visual) {
    std::vector<Vec3f> vertices(visual.tet.size());
    skin(model_, state_, solver::view_of(bundle_, visual), {}, {vertices, {}, {}}, {0, vertices.size()}, settings_,
         jobs_of(context_));
    return vertices;
}

solver::CarrierMotion Player::motion() const { return rides_ ? carrier_.motion() : solver::CarrierMotion{}; }

}
