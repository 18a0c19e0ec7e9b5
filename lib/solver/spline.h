// SPDX-License-Identifier: MIT
// Keyframes to motion: cubic curves through points at given times, and handles, sets of nodes that follow them.
#pragma once
#include "core/fields.h"
#include "solver/step.h"

namespace crumple::solver {

enum class SplineKind : std::uint8_t {
    catmull_rom,    // local: a key moves four spans. Slope of the parabola through a key and its neighbours
    natural_cubic,  // smoothest: second derivatives continuous, 0 at both ends
};
inline constexpr EnumName<SplineKind> spline_kind_names[] = {{SplineKind::catmull_rom, "catmull_rom"},
                                                             {SplineKind::natural_cubic, "natural_cubic"}};
constexpr std::span<const EnumName<SplineKind>> enum_names(SplineKind) { return spline_kind_names; }

// K keys, times ascending. Both kinds are the same Hermite cubics with other slopes. Before the first and after the
// last key the curve stands still.
struct Spline {
    std::span<const float> times;   // K, seconds
    std::span<const Vec3f> values;  // K
    std::span<const Vec3f> slopes;  // K
};

// Fills the slopes (K). `scratch` (K) is used by natural_cubic.
void find_slopes(SplineKind kind, std::span<const float> times, std::span<const Vec3f> values, std::span<Vec3f> slopes,
                 std::span<float> scratch);

[[nodiscard]] Vec3f value_at(const Spline& spline, float time);

// Nodes moved as one rigid thing: x = pivot + R(turn) (rest - pivot) + shift, turn a rotation vector in radians.
struct Handle {
    std::span<const Index> nodes;
    Vec3f pivot;
    Spline shift;  // metres; empty: none
    Spline turn;   // empty: none
};

// Constraints that bring the handle's nodes, locked or not, to where it is at time + dt. Writes one a node as far as
// there is room and returns how many.
std::size_t drive(const Model& model, const State& state, const Handle& handle, float time, float dt,
                  std::span<Constraint> room);

}
