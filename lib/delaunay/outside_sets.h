// SPDX-License-Identifier: GPL-3.0-or-later
// Quickhull's bookkeeping [Barber, Dobkin, Huhdanpaa 1996]: every facet holds the sites that wait for it to be
// replaced, each site with one facet it sees, the one it sees from farthest first.
#pragma once
#include <vector>

#include "core/context.h"
#include "core/index.h"
#include "delaunay/lifted_hull.h"

namespace crumple::delaunay {

class OutsideSets {
public:
    explicit OutsideSets(LiftedHull& hull) : hull_(hull), next_(hull.sites().count(), none) {
        first_.reserve(hull.facets().size());
    }

    // REQUIRES: site sees facet.
    void add(Index site, Index facet);

    // Inserts waiting sites, the farthest of a facet first, depth first, until none waits.
    void insert_all(const Context& context);

private:
    [[nodiscard]] std::size_t highest_star_facet(Index site, Index inserted);
    [[nodiscard]] Index take_set(Index facet);
    void hand_over(Index inserted);
    void place_on_star(Index site, Index inserted);

    LiftedHull& hull_;
    std::vector<Index> first_;          // by facet: the site of its set to be inserted next; may be shorter
    std::vector<Index> next_;           // S: the next site of the same set
    std::vector<Index> stack_;          // facets with a set, the newest last; may name one twice
    std::vector<float> star_farthest_;  // of the star at hand: height of the first site of each set
    std::vector<float> heights_;
    std::vector<Index> orphans_;  // sites of the facets that went
};

}
