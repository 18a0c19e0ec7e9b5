// SPDX-License-Identifier: MIT
#include "solver/check_input.h"

#include <algorithm>
#include <cmath>

namespace crumple::solver {
namespace {

// Comparisons are false for what is no number.
bool is_number(double x) { return std::abs(x) <= largest_number; }
bool is_number_from_0(double x) { return x >= 0 && x <= largest_number; }
bool are_numbers(Vec3 v) { return is_number(v.x) && is_number(v.y) && is_number(v.z); }

bool is_direction(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && !(v == Vec3{}); }

bool is_rotation(Quaternion q) {
    const double x = q.x, y = q.y, z = q.z, w = q.w;
    const double size = x * x + y * y + z * z + w * w;
    return size > 0 && std::isfinite(size);
}

bool are_accelerations(const CarrierMotion& c) {
    return are_numbers(c.acceleration) && are_numbers(c.angular_acceleration);
}

bool has_shape(const Obstacle& o) {
    if (o.shape == ObstacleShape::plane) return is_direction(o.axis);
    if (o.shape == ObstacleShape::capsule) return are_numbers(o.axis);
    return o.shape == ObstacleShape::box && is_number_from_0(o.axis.x) && is_number_from_0(o.axis.y) &&
           is_number_from_0(o.axis.z) && is_rotation(o.orientation);
}

bool is_obstacle(const Obstacle& o) {
    return has_shape(o) && is_number_from_0(o.radius) && are_numbers(o.position) && are_numbers(o.velocity) &&
           are_numbers(o.angular_velocity) && o.restitution >= 0 && o.restitution <= 1;
}

bool is_air(const Wind& wind) {
    return are_numbers(widen(wind.velocity)) && is_number_from_0(static_cast<double>(wind.density_kg_m3)) &&
           is_number_from_0(static_cast<double>(wind.drag));
}

// Infinite ones make sense: never, always.
bool are_limits(const SleepSettings& s) {
    return !std::isnan(s.speed) && !std::isnan(s.after_s) && !std::isnan(s.wake_speed) && !std::isnan(s.wake_pull);
}

}

bool is_usable(Vec3f v) noexcept { return are_numbers(widen(v)); }

bool is_usable(const CarrierMotion& c) noexcept {
    return is_rotation(c.orientation) && are_numbers(c.position) && are_numbers(c.velocity) &&
           are_numbers(c.angular_velocity);
}

bool is_usable(const InstanceInput& input) noexcept {
    return is_usable(input.carrier) && (!input.has_inertia || are_accelerations(input.carrier)) &&
           are_numbers(input.gravity) && are_limits(input.sleep) &&
           std::all_of(input.obstacles.begin(), input.obstacles.end(), is_obstacle) &&
           std::all_of(input.hits.begin(), input.hits.end(),
                       [](const Hit& hit) { return are_numbers(hit.position) && are_numbers(hit.momentum); });
}

bool is_usable(const Model& model, const State& state, const StepInput& input, const Settings& settings) noexcept {
    const auto is_full_or_empty = [&](std::size_t size) { return size == 0 || size == model.node_count; };
    return input.dt > 0 && is_number(static_cast<double>(input.dt)) && is_usable(input.gravity) &&
           is_usable(input.frame_turn) && is_usable(input.frame_turn_rate) &&
           (!input.has_free_carrier || is_number_from_0(input.carrier_mass)) &&
           (input.wind == nullptr || is_air(*input.wind)) && is_full_or_empty(input.forces.size()) &&
           is_full_or_empty(input.reactions.size()) &&
           state.shapes.empty() == (settings.plasticity != Plasticity::multiplicative) &&
           std::all_of(input.forces.begin(), input.forces.end(), [](Vec3f f) { return is_usable(f); });
}

}
