// SPDX-License-Identifier: GPL-3.0-or-later
// A random eighth of the sites by walking, which gives every facet a small outside set; then quickhull.
#include "delaunay/brio_rounds.h"
#include "delaunay/order.h"
#include "delaunay/outside_sets.h"
#include "delaunay/walk.h"

namespace crumple::delaunay {

void insert_sampled(LiftedHull& hull, const std::array<Index, 4>& first, const Context& context) {
    const std::vector<Index> order = brio_order(hull.sites().count(), first);
    const auto sample = std::span(order).first(order.size() / 8);
    insert_by_walking(hull, sample, context);

    OutsideSets sets(hull);
    Index facet = hull.star().back();
    for (const Index site : std::span(order).subspan(sample.size())) {
        facet = walk_to_seen_facet(hull, site, facet);
        sets.add(site, facet);
    }
    sets.insert_all(context);
}

}
