// SPDX-License-Identifier: GPL-3.0-or-later
// Puts random points inside the shell. Their number sets the size of the system a game has to solve.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/point_set.h"
#include "mesh/shell.h"

namespace crumple::sample {

inline constexpr int version = 1;

struct Params {};
struct Report {};

struct Result {
    PointSet points;  // shell vertices first, then interior points rounded to float
    Report report;
};

[[nodiscard]] Result sample_interior(const Shell& shell, const Params& params = {}, const Context& context = {});

}
