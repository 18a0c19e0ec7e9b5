// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/brio_rounds.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "delaunay/walk.h"

namespace crumple::delaunay {
namespace {

constexpr int bits_per_round = 3;
constexpr int most_rounds = 10;

// Finalizer of splitmix64 [Steele, Lea, Flood 2014]: as good as random for the numbers of sites along the curve.
std::uint64_t scramble(std::uint64_t v) {
    v += 0x9e3779b97f4a7c15u;
    v = (v ^ v >> 30) * 0xbf58476d1ce4e5b9u;
    v = (v ^ v >> 27) * 0x94d049bb133111ebu;
    return v ^ v >> 31;
}

// 0 for 7 of 8 sites, 1 for 7 of 8 of the rest, and so on.
int round_from_last(Index site) {
    return std::min(std::countr_zero(scramble(site) | std::uint64_t{1} << 62) / bits_per_round, most_rounds - 1);
}

}

std::vector<Index> brio_order(Index site_count, const std::array<Index, 4>& first) {
    std::array<std::vector<Index>, most_rounds> rounds;
    rounds[0].reserve(site_count);
    for (Index site = 0; site < site_count; ++site) {
        if (std::find(first.begin(), first.end(), site) == first.end()) rounds[round_from_last(site)].push_back(site);
    }
    std::vector<Index> order;
    order.reserve(site_count);
    for (int round = most_rounds - 1; round >= 0; --round) {
        // Every other round runs backwards, so that each starts near where the last one ended.
        if (round % 2 == 0) {
            order.insert(order.end(), rounds[round].begin(), rounds[round].end());
        } else {
            order.insert(order.end(), rounds[round].rbegin(), rounds[round].rend());
        }
    }
    return order;
}

void insert_by_walking(LiftedHull& hull, std::span<const Index> order, const Context& context) {
    constexpr Index sites_between_checks = 4096;
    Index facet = hull.star().back();
    for (Index i = 0; i < order.size(); ++i) {
        if (i % sites_between_checks == 0) {
            context.stop_if_cancelled();
            context.tell_progress("delaunay", static_cast<double>(i) / hull.sites().count());
        }
        hull.insert(order[i], walk_to_seen_facet(hull, order[i], facet));
        facet = hull.star().back();
    }
}

}
