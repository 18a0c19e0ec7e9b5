// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/canonical.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace crumple::delaunay {
namespace {

bool is_tet(const LiftedHull& hull, Index facet) { return hull.is_alive(facet) && !hull.is_infinite(facet); }

// Corners in rising order, the last two swapped where only that keeps the tet positive; neighbours go with them.
void sort_corners(Tet& corner, std::array<Index, 4>& neighbour) {
    bool is_odd = false;
    const auto sort_pair = [&](int i, int j) {
        const bool swaps = corner[i] > corner[j];
        const Tet old_corner = corner;
        const auto old_neighbour = neighbour;
        corner[i] = swaps ? old_corner[j] : old_corner[i];
        corner[j] = swaps ? old_corner[i] : old_corner[j];
        neighbour[i] = swaps ? old_neighbour[j] : old_neighbour[i];
        neighbour[j] = swaps ? old_neighbour[i] : old_neighbour[j];
        is_odd ^= swaps;
    };
    sort_pair(0, 1);
    sort_pair(2, 3);
    sort_pair(0, 2);
    sort_pair(1, 3);
    sort_pair(1, 2);
    if (is_odd) {
        std::swap(corner[2], corner[3]);
        std::swap(neighbour[2], neighbour[3]);
    }
}

class CanonicalWriter {
public:
    CanonicalWriter(const LiftedHull& hull, TetMesh& mesh) : hull_(hull), mesh_(mesh) {}

    void write() {
        make_buckets();
        fill_buckets();
        Index begin = 0;
        for (const Index end : bucket_end_) {
            sort_bucket(begin, end);
            begin = end;
        }
        name_neighbours();
    }

private:
    // One bucket a site: the tets whose lowest corner it is. bucket_end_ holds the beginnings until they are filled.
    void make_buckets() {
        const auto facets = hull_.facets();
        bucket_end_.assign(hull_.sites().count(), 0);
        for (Index f = 0; f < facets.size(); ++f) {
            if (is_tet(hull_, f)) ++bucket_end_[*std::min_element(facets[f].vertex.begin(), facets[f].vertex.end())];
        }
        Index count = 0;
        for (Index& end : bucket_end_) count += std::exchange(end, count);
        mesh_.tets.resize(count);
        mesh_.neighbours.resize(count);
        facet_of_.resize(count);
    }

    void fill_buckets() {
        const auto facets = hull_.facets();
        for (Index f = 0; f < facets.size(); ++f) {
            if (!is_tet(hull_, f)) continue;
            Tet corner = facets[f].vertex;
            auto neighbour = facets[f].neighbour;
            sort_corners(corner, neighbour);
            const Index place = bucket_end_[corner[0]]++;
            mesh_.tets[place] = corner;
            mesh_.neighbours[place] = neighbour;
            facet_of_[place] = f;
        }
    }

    void sort_bucket(Index begin, Index end) {
        entries_.clear();
        for (Index place = begin; place < end; ++place) {
            entries_.push_back({mesh_.tets[place], mesh_.neighbours[place], facet_of_[place]});
        }
        order_.clear();
        for (std::uint32_t i = 0; i < entries_.size(); ++i) {
            const Tet& corner = entries_[i].corner;
            order_.push_back({std::uint64_t{corner[1]} << 32 | corner[2], corner[3], i});
        }
        std::sort(order_.begin(), order_.end());
        for (const Rank& rank : order_) {
            const Entry& entry = entries_[rank.entry];
            mesh_.tets[begin] = entry.corner;
            mesh_.neighbours[begin] = entry.neighbour;
            facet_of_[begin++] = entry.facet;
        }
    }

    // Facets become tets, none where they are infinite, and sites become points.
    void name_neighbours() {
        const auto& source = hull_.sites().source;
        std::vector<Index> tet_of(hull_.facets().size(), none);
        for (Index tet = 0; tet < facet_of_.size(); ++tet) tet_of[facet_of_[tet]] = tet;
        for (auto& neighbours : mesh_.neighbours) {
            for (Index& neighbour : neighbours) neighbour = tet_of[neighbour / 4];
        }
        for (Tet& tet : mesh_.tets) {
            for (Index& corner : tet) corner = source[corner];
        }
    }

    struct Entry {
        Tet corner;
        std::array<Index, 4> neighbour;
        Index facet;
    };
    struct Rank {
        std::uint64_t second_and_third;
        Index fourth;
        std::uint32_t entry;
        auto operator<=>(const Rank&) const = default;
    };

    const LiftedHull& hull_;
    TetMesh& mesh_;
    std::vector<Index> bucket_end_;
    std::vector<Index> facet_of_;
    std::vector<Entry> entries_;  // of the bucket at hand
    std::vector<Rank> order_;
};

}

void write_canonical_tets(const LiftedHull& hull, TetMesh& mesh) { CanonicalWriter(hull, mesh).write(); }

}
