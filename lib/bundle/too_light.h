// SPDX-License-Identifier: MIT
// When float loses a node's mass beside its stiffness. The solver's matrix sums both in one number,
//     A_ii = (1 + alpha dt) m I + (beta dt + dt^2) K'_ii,
// and is positive definite no more where the first drowns in the rounding of the second. So a node is made heavier,
// with a warning, where    light_share (1 + alpha dt) m < resolved_by_float (beta dt + dt^2) tr(K'_ii) / 3.
#pragma once

namespace crumple {

inline constexpr float resolved_by_float = 3e-7f;
inline constexpr float light_share = 0.125f;

}
