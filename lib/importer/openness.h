// SPDX-License-Identifier: GPL-3.0-or-later
// How far inside and outside of an open shell can be told apart, measured before anything is built on it.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "core/finding.h"
#include "mesh/shell.h"

namespace crumple::importer {

struct Openness {
    std::uint64_t holes = 0;  // boundary loops
    double largest_hole = 0;  // its box, in diagonals of the shell's
    Place place;              // of the largest hole
    double leak_share = 0;    // volume share of winding numbers 0.3 to 0.7 among those above 0.3, about
};

// All zero for a closed shell. The leak share is estimated from 20 000 places within 0.01 of winding number, so a share
// of 2 % is known to about 0.3 %.
[[nodiscard]] Openness measure_openness(const Shell& shell, const Context& context = {});

// Accepts small holes and large ones that hardly leak, with findings SHELL_HOLES and SHELL_LEAKS. Throws
// Error(bad_input) where a large hole leaves inside and outside a guess, and names what closes it: unless
// `is_caged`, for a lattice around the shell does not ask.
[[nodiscard]] std::vector<Finding> judge_openness(const Openness& openness, double diagonal, bool is_caged);

}
