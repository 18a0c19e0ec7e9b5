// SPDX-License-Identifier: GPL-3.0-or-later
// The bar that solvers are measured with: 8 x 1 x 1 m, clamped at x = 0, E = 1e6, nu = .3, rho = 1000, alpha = .15,
// beta = .004, under gravity.
#pragma once
#include <string>

#include "bundle/bundle.h"
#include "solver/step.h"

namespace crumple::bench {

enum class BarSize {
    small,  // TetGen's -pq1.3a0.0042: 5,326 tets
    large,  // -pq1.3a0.00035: 50,240 tets
};

struct Bar {
    Bundle bundle;
    std::string name;  // "bar_5k"; "grid_5k" where TetGen is not there and a grid of about as many tets stands in
    bool is_tetgen = false;
};

[[nodiscard]] Bar make_bar(BarSize size);

[[nodiscard]] Material bar_material();

inline constexpr float bar_dt = 1.0f / 60;
inline constexpr float bar_gravity = -9.88f;
[[nodiscard]] solver::StepInput bar_input();

}
