// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/outside_sets.h"

#include <algorithm>
#include <cmath>

#include "delaunay/walk.h"

namespace crumple::delaunay {

void OutsideSets::add(Index site, Index facet) {
    Facet& f = hull_.facets()[facet];
    if (f.outside == none) stack_.push_back(facet);
    next_[site] = f.outside;
    f.outside = site;
}

void OutsideSets::insert_all(const Context& context) {
    constexpr Index sites_between_checks = 4096;
    for (Index inserted = 0; !stack_.empty();) {
        const Index facet = stack_.back();
        const Index site = hull_.facets()[facet].outside;
        if (!hull_.is_alive(facet) || site == none) {
            stack_.pop_back();
            continue;
        }
        if (inserted++ % sites_between_checks == 0) context.stop_if_cancelled();
        hull_.insert(site, facet);
        hand_over(site);
    }
}

void OutsideSets::hand_over(Index inserted) {
    star_farthest_.assign(hull_.star().size(), 0.0f);
    heights_.resize(std::max(heights_.size(), hull_.star().size()));
    for (const Index head : hull_.orphans()) {
        for (Index site = head; site != none;) {
            const Index next = next_[site];
            if (site != inserted) place_on_star(site, inserted);
            site = next;
        }
    }
}

void OutsideSets::place_on_star(Index site, Index inserted) {
    const auto star = hull_.star();
    std::size_t best = highest_star_facet(site, inserted);
    if (!hull_.sees_certainly(site, star[best])) {
        // Any facet that is seen will do. Of points on a sphere all tets of a star are doubtful, hull faces are not.
        return add(site, walk_to_seen_facet(hull_, site, star[best]));
    }
    Facet& facet = hull_.facets()[star[best]];
    const float height = heights_[best];
    if (facet.outside == none || height > star_farthest_[best]) {
        add(site, star[best]);
        star_farthest_[best] = height;
    } else {
        next_[site] = next_[facet.outside];
        next_[facet.outside] = site;
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
