// SPDX-License-Identifier: MIT
// How a tet collapsed: which corner went through its opposite face, or which edge passed its opposite edge. Found once,
// on the way into the degenerate range det F <= threshold, and kept until det F leaves it, so that the rotation is
// coherent in time [Civit-Flores, Susin 2014, "Robust treatment of degenerate elements in interactive corotational FEM
// simulations"].
#pragma once
#include <array>
#include <cstdint>

#include "core/vec3.h"

namespace crumple::solver {

// Corners that move along the axis of collapse; the others stay. Stored in TetState::collapse.
enum class Collapse : std::uint8_t { none, corner0, corner1, corner2, corner3, edge01, edge02, edge03 };

// The moving corners' weights over the gradients of corners 1, 2, 3: the moving set's gradient is
// sum_k sign[k] g_(k+1) with sign[k] = collapse_signs[k][collapse], and the axis along which it grows the volume is
// sum_k sign[k] C_k with C the cofactors of Ds. Corner 0 is minus the other three, since all gradients sum to zero.
inline constexpr std::size_t collapse_count = 8;
inline constexpr float collapse_signs[3][collapse_count] = {
    {0, -1, 1, 0, 0, 0, -1, -1}, {0, -1, 0, 1, 0, -1, 0, -1}, {0, -1, 0, 0, 1, -1, -1, 0}};

// Positions of the corners on the way from -> to; det F = six times the volume over six_rest_volumes.
struct CollapsePath {
    std::array<Vec3f, 4> from;
    std::array<Vec3f, 4> to;
    float six_rest_volumes;
    float threshold;
};

// Part of the way, in (0, 1], at which det F first falls to the threshold; 1 where rounding hides it.
[[nodiscard]] double collapse_time(const CollapsePath& path);

[[nodiscard]] Collapse classify_collapse(const CollapsePath& path);

}
