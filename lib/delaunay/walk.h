// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/index.h"
#include "delaunay/lifted_hull.h"

namespace crumple::delaunay {

// A facet the site sees, found by walking through the tets from start towards the site.
[[nodiscard]] Index walk_to_seen_facet(LiftedHull& hull, Index site, Index start);

}
