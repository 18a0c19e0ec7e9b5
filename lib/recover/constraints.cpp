// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/constraints.h"

#include <algorithm>

namespace crumple::recover {

namespace {

// SplitMix64's finalizer.
std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

}

Edge sorted_edge(Index a, Index b) { return a < b ? Edge{a, b} : Edge{b, a}; }

Triangle sorted_triangle(Index a, Index b, Index c) {
    Triangle t{a, b, c};
    std::sort(t.begin(), t.end());
    return t;
}

std::size_t EdgeHash::operator()(const Edge& e) const noexcept { return mixed((std::uint64_t{e[0]} << 32) | e[1]); }

std::size_t TriangleHash::operator()(const Triangle& t) const noexcept {
    return mixed(mixed((std::uint64_t{t[0]} << 32) | t[1]) + t[2]);
}

void Constraints::add_apex(Index a, Index b, Index apex) {
    std::vector<Index>& apexes = segments_[sorted_edge(a, b)];
    apexes.insert(std::lower_bound(apexes.begin(), apexes.end(), apex), apex);
}

void Constraints::remove_apex(Index a, Index b, Index apex) {
    const auto segment = segments_.find(sorted_edge(a, b));
    std::vector<Index>& apexes = segment->second;
    apexes.erase(std::lower_bound(apexes.begin(), apexes.end(), apex));
    if (apexes.empty()) segments_.erase(segment);
}

void Constraints::add_facet(const Triangle& facet, Index origin) {
    const auto [a, b, c] = sorted_triangle(facet[0], facet[1], facet[2]);
    if (a == b || b == c || !facets_.try_emplace({a, b, c}, origin).second) return;
    add_apex(a, b, c);
    add_apex(b, c, a);
    add_apex(c, a, b);
}

void Constraints::remove_facet(const Triangle& facet) {
    const auto [a, b, c] = sorted_triangle(facet[0], facet[1], facet[2]);
    if (facets_.erase({a, b, c}) == 0) return;
    remove_apex(a, b, c);
    remove_apex(b, c, a);
    remove_apex(c, a, b);
}

std::vector<Edge> Constraints::segments() const {
    std::vector<Edge> all;
    all.reserve(segments_.size());
    for (const auto& segment : segments_) all.push_back(segment.first);
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<Triangle> Constraints::facets() const {
    std::vector<Triangle> all;
    all.reserve(facets_.size());
    for (const auto& facet : facets_) all.push_back(facet.first);
    std::sort(all.begin(), all.end());
    return all;
}

}
