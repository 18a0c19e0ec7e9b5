// SPDX-License-Identifier: GPL-3.0-or-later
// Written by calculix_figures.py, which says of what; CalculiX 2.20. Displacements of the free end in metres.
#pragma once

namespace crumple::calculix {

struct Tip {
    double k;
    double along;
    double down;
};

// Large displacements (NLGEOM: Green strain, second Piola-Kirchhoff stress), nu = .3.
inline constexpr Tip grid_tips[] = {
    {0.2, -0.005884794, -0.271491}, {1, -0.1359004, -1.317962}, {2, -0.4776805, -2.448451}};
inline constexpr Tip bar_5k_tips[] = {
    {0.2, -0.01634694, -0.4652825}, {1, -0.3608411, -2.163596}, {2, -1.091297, -3.667252}};

// Linear, k = .01.
inline constexpr double bar_5k_linear_down = -0.02334168;
struct Locking {
    double poisson;
    double down;
};
inline constexpr Locking grid_linear[] = {{0.3, -0.01360406}, {0.49, -0.002919817}, {0.499, -0.0007092715}};

// Lowest of *FREQUENCY, consistent masses.
inline constexpr double grid_frequency_hz = 0.1027638;

}
