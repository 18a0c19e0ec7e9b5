// SPDX-License-Identifier: GPL-3.0-or-later
// An insertion order brings every site but the first four into a started hull. The hull that results is the same for
// each; order.cpp holds the one table that names them.
#pragma once
#include <array>

#include "core/context.h"
#include "core/index.h"
#include "delaunay/delaunay.h"
#include "delaunay/lifted_hull.h"

namespace crumple::delaunay {

using InsertSites = void (*)(LiftedHull& hull, const std::array<Index, 4>& first, const Context& context);

void insert_quickhull(LiftedHull& hull, const std::array<Index, 4>& first, const Context& context);
void insert_sampled(LiftedHull& hull, const std::array<Index, 4>& first, const Context& context);
void insert_brio(LiftedHull& hull, const std::array<Index, 4>& first, const Context& context);

// What Order::automatic means for so many sites.
[[nodiscard]] Order choose_order(Order wanted, Index site_count);

[[nodiscard]] InsertSites insertion_of(Order order);

}
