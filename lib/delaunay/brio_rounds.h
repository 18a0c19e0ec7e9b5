// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/context.h"
#include "core/index.h"
#include "delaunay/lifted_hull.h"

namespace crumple::delaunay {

// The sites but the first four, in rounds: each round is a random sample eight times the one before, in Hilbert order.
[[nodiscard]] std::vector<Index> brio_order(Index site_count, const std::array<Index, 4>& first);

void insert_by_walking(LiftedHull& hull, std::span<const Index> order, const Context& context);

}
