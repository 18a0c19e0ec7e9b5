// SPDX-License-Identifier: GPL-3.0-or-later
// The textbook order: all sites start in the outside sets of the first simplex.
#include <algorithm>

#include "core/error.h"
#include "delaunay/order.h"
#include "delaunay/outside_sets.h"

namespace crumple::delaunay {

void insert_quickhull(LiftedHull& hull, const std::array<Index, 4>& first, const Context& context) {
    OutsideSets sets(hull);
    for (Index site = 0; site < hull.sites().count(); ++site) {
        if (std::find(first.begin(), first.end(), site) != first.end()) continue;
        const auto facets = hull.star();
        const auto seen = std::find_if(facets.begin(), facets.end(), [&](Index f) { return hull.sees(site, f); });
        CRUMPLE_CHECK(seen != facets.end(), "a site sees no facet of the first simplex");
        sets.add(site, *seen);
    }
    sets.insert_all(context);
}

}
