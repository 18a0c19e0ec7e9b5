// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/canonical.h"

#include <algorithm>
#include <array>

namespace crumple::delaunay {
namespace {

// corner[i]: which corner of the facet becomes corner i of the tet.
using CornerOrder = std::array<std::uint8_t, 4>;

CornerOrder canonical_corners(const std::array<Index, 4>& vertex) {
    CornerOrder corner{0, 1, 2, 3};
    bool is_odd = false;
    const auto sort_pair = [&](int i, int j) {
        if (vertex[corner[i]] > vertex[corner[j]]) {
            std::swap(corner[i], corner[j]);
            is_odd = !is_odd;
        }
    };
    sort_pair(0, 1);
    sort_pair(2, 3);
    sort_pair(0, 2);
    sort_pair(1, 3);
    sort_pair(1, 2);
    if (is_odd) std::swap(corner[2], corner[3]);
    return corner;
}

void reorder_corners(Facet& facet, const CornerOrder& order) {
    const auto vertex = facet.vertex;
    const auto neighbour = facet.neighbour;
    for (int i = 0; i < 4; ++i) {
        facet.vertex[i] = vertex[order[i]];
        facet.neighbour[i] = neighbour[order[i]];
    }
}

// Finite facets sorted by their corners: buckets by the first, then the few of each bucket by the others.
std::vector<Index> canonical_order(const LiftedHull& hull, const std::vector<Index>& finite) {
    const auto facets = hull.facets();
    std::vector<Index> start(hull.sites().count() + 1, 0);
    for (const Index f : finite) ++start[facets[f].vertex[0] + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<Index> order(finite.size());
    for (const Index f : finite) order[start[facets[f].vertex[0]]++] = f;
    // Each start has moved to the end of its bucket.
    Index begin = 0;
    for (std::size_t i = 0; i + 1 < start.size(); ++i) {
        std::sort(order.begin() + begin, order.begin() + start[i],
                  [&](Index a, Index b) { return facets[a].vertex < facets[b].vertex; });
        begin = start[i];
    }
    return order;
}

}

void write_canonical_tets(LiftedHull& hull, TetMesh& mesh) {
    const auto facets = hull.facets();
    const auto& source = hull.sites().source;
    std::vector<Index> finite;
    finite.reserve(facets.size());
    for (Index f = 0; f < facets.size(); ++f) {
        if (!hull.is_alive(f) || hull.is_infinite(f)) continue;
        finite.push_back(f);
        reorder_corners(facets[f], canonical_corners(facets[f].vertex));
    }
    const std::vector<Index> order = canonical_order(hull, finite);
    // From here on mark is the facet's number in the mesh; infinite facets have none.
    for (Facet& f : facets) f.mark = none;
    for (Index tet = 0; tet < order.size(); ++tet) facets[order[tet]].mark = tet;
    mesh.tets.resize(order.size());
    mesh.neighbours.resize(order.size());
    for (Index tet = 0; tet < order.size(); ++tet) {
        const Facet& f = facets[order[tet]];
        for (int corner = 0; corner < 4; ++corner) {
            mesh.tets[tet][corner] = source[f.vertex[corner]];
            mesh.neighbours[tet][corner] = facets[f.neighbour[corner] / 4].mark;
        }
    }
}

}
