// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/outside_sets.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "delaunay/walk.h"

namespace crumple::delaunay {

void OutsideSets::add(Index site, Index facet) {
    if (facet >= first_.size()) first_.resize(std::max<std::size_t>(facet + 1, hull_.facets().size()), none);
    if (first_[facet] == none) stack_.push_back(facet);
    next_[site] = first_[facet];
    first_[facet] = site;
}

Index OutsideSets::take_set(Index facet) { return facet < first_.size() ? std::exchange(first_[facet], none) : none; }

void OutsideSets::insert_all(const Context& context) {
    constexpr Index sites_between_checks = 4096;
    Index inserted = 0;
    while (!stack_.empty()) {
        const Index facet = stack_.back();
        const Index site = first_[facet];
        if (site == none) {
            stack_.pop_back();
            continue;
        }
        if (inserted++ % sites_between_checks == 0) {
            context.stop_if_cancelled();
            context.tell_progress("delaunay", static_cast<double>(inserted) / hull_.sites().count());
        }
        hull_.insert(site, facet);
        hand_over(site);
    }
}

// All sets of the facets that went are taken before any is refilled: the star lives in the same places.
void OutsideSets::hand_over(Index inserted) {
    star_farthest_.assign(hull_.star().size(), 0.0f);
    heights_.resize(std::max(heights_.size(), hull_.star().size()));
    orphans_.clear();
    for (const Index code : hull_.replaced()) {
        for (Index site = take_set(code / 4); site != none; site = next_[site]) orphans_.push_back(site);
    }
    for (const Index site : orphans_) {
        if (site != inserted) place_on_star(site, inserted);
    }
}

void OutsideSets::place_on_star(Index site, Index inserted) {
    const auto star = hull_.star();
    const std::size_t best = highest_star_facet(site, inserted);
    const Index facet = star[best];
    if (!hull_.sees_certainly(site, facet)) {
        // Any facet that is seen will do. Of points on a sphere all tets of a star are doubtful, hull faces are not.
        return add(site, walk_to_seen_facet(hull_, site, facet));
    }
    if (facet >= first_.size() || first_[facet] == none || heights_[best] > star_farthest_[best]) {
        add(site, facet);
        star_farthest_[best] = heights_[best];
    } else {
        next_[site] = next_[first_[facet]];
        next_[first_[facet]] = site;
    }
}

// By height less its error bound, so that a facet that is certainly seen wins over a doubtful one.
std::size_t OutsideSets::highest_star_facet(Index site, Index inserted) {
    const Site& p = hull_.sites().at[site];
    const Site& origin = hull_.sites().at[inserted];
    const auto dx = static_cast<float>(p.x - origin.x);
    const auto dy = static_cast<float>(p.y - origin.y);
    const auto dz = static_cast<float>(p.z - origin.z);
    const float span = std::fabs(dx) + std::fabs(dy) + std::fabs(dz);
    const float square = dx * dx + dy * dy + dz * dz;
    const StarPlanes& planes = hull_.star_planes();
    const std::size_t count = hull_.star().size();
    for (std::size_t i = 0; i < count; ++i) {
        heights_[i] = planes.normal[0][i] * dx + planes.normal[1][i] * dy + planes.normal[2][i] * dz +
                      planes.curvature[i] * square -
                      (planes.normal_error[i] * span + planes.curvature_error[i] * square);
    }
    return static_cast<std::size_t>(std::max_element(heights_.begin(), heights_.begin() + count) - heights_.begin());
}

}
