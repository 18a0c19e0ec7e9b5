// SPDX-License-Identifier: GPL-3.0-or-later
// Biased randomized insertion order [Amenta, Choi, Rote 2003, "Incremental constructions con BRIO"]: rounds of growing
// random samples, each along the Hilbert curve, every site found by walking from the one before.
#include "delaunay/brio_rounds.h"
#include "delaunay/order.h"
#include "delaunay/walk.h"

namespace crumple::delaunay {

void insert_brio(LiftedHull& hull, const std::array<Index, 4>& first, const Context& context) {
    insert_by_walking(hull, brio_order(hull.sites().count(), first), context);
}

}
