// SPDX-License-Identifier: MIT
// What pushes the nodes besides the tets: gravity, the caller's forces, the inertia of a turning frame, wind.
#pragma once
#include "solver/rigid_motion.h"
#include "solver/step.h"

namespace crumple::solver {

// Newtons on a node that do work on it, without wind. A frame that turns at w, faster by w' a second, adds
// -m (w' x r + w x (w x r)); gravity already holds what its acceleration adds.
[[nodiscard]] inline Vec3f working_force(const Model& model, const State& state, const StepInput& input,
                                         std::size_t node) {
    const float mass = model.bundle.mass[node];
    Vec3f push = input.gravity * mass;
    if (!input.forces.empty()) push += input.forces[node];
    const Vec3f turn = input.frame_turn;
    if (turn == Vec3f{} && input.frame_turn_rate == Vec3f{}) return push;
    const Vec3f x = position(state, node);
    return push - (cross(input.frame_turn_rate, x) + cross(turn, cross(turn, x))) * mass;
}

// And -2 m w x v: of the mean of v before and after it, so that it turns v and makes it no faster, however far the
// frame turns in the step.
[[nodiscard]] inline Vec3f outside_force(const Model& model, const State& state, const StepInput& input,
                                         std::size_t node) {
    const Vec3f push = working_force(model, state, input, node);
    const Vec3f turn = input.frame_turn;
    if (turn == Vec3f{}) return push;
    const Vec3f drift = cross(turn, velocity(state, node));
    const float part = 2 / (1 + input.dt * input.dt * dot(turn, turn));
    return push - (drift - cross(turn, drift) * input.dt) * (part * model.bundle.mass[node]);
}

// Whether it is anything but 0 anywhere.
[[nodiscard]] inline bool is_pushed(const StepInput& input) {
    return !input.forces.empty() || !(input.gravity == Vec3f{}) || !(input.frame_turn == Vec3f{}) ||
           !(input.frame_turn_rate == Vec3f{});
}

// What all of that, and wind, does to the momentum of the nodes in this step, N s and N m s about the origin.
struct WindPush;
[[nodiscard]] Six outside_push(const Model& model, const State& state, const StepInput& input, const WindPush& wind);

struct WindPush {
    double work = 0;  // J during this step, at most
    Six push{};       // N s and N m s about the origin
};

// Adds dt times the wind's force on the boundary to Workspace::outside:
//
//     f = rho/2 C A |w.n| (w.n) n   of every boundary face that meets the wind, w the air's velocity seen from the
//     face,
//
// a third to each corner. The force is explicit, so it is held to what would stop the face in this step.
WindPush add_wind(const Model& model, const State& state, Workspace& workspace, const Wind& wind, float dt);

}
