// SPDX-License-Identifier: GPL-3.0-or-later
// The lower hull of the lifted sites, closed by a vertex at infinity: its finite facets are the Delaunay tets, its
// infinite ones the faces of the convex hull. A site sees a facet when it lies inside the tet's circumsphere, or beyond
// the hull face. Inserting a site replaces the facets it sees by the star of the site.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/index.h"
#include "delaunay/facet_plane.h"
#include "delaunay/sites.h"
#include "delaunay/star.h"

namespace crumple::delaunay {

// vertex[0] is the newest one, the plane's origin, never the one at infinity.
struct Facet {
    std::array<Index, 4> vertex;     // positive; the one at infinity counts as a point beyond the hull
    std::array<Index, 4> neighbour;  // across the ridge opposite corner i: 4 * facet + the corner opposite there
};

// What a test of a facet reads, apart from the rest: half a cache line.
struct alignas(32) FacetSide {
    FacetPlane plane;
    Index origin;        // vertex[0] again
    std::uint32_t mark;  // of the last insertion that looked at it
};
static_assert(sizeof(Facet) == 32 && sizeof(FacetSide) == 32);

class LiftedHull {
public:
    // Facets are expected at 6.8 a site, as random points have; more are fine.
    explicit LiftedHull(Sites& sites);

    // REQUIRES: the tet of these four sites is positive.
    void start(const std::array<Index, 4>& simplex);

    // REQUIRES: sees(site, facet), site not yet inserted.
    void insert(Index site, Index facet);

    [[nodiscard]] bool sees(Index site, Index facet);
    [[nodiscard]] bool sees_certainly(Index site, Index facet) const { return plane_side(site, facet) > 0; }

    [[nodiscard]] std::span<const Facet> facets() const { return facets_; }
    [[nodiscard]] const Sites& sites() const { return sites_; }
    [[nodiscard]] bool is_alive(Index facet) const { return facets_[facet].vertex[0] != none; }
    [[nodiscard]] bool is_infinite(Index facet) const { return infinite_corner(facets_[facet]) != 0; }

    // Of the last insertion (or start): the new facets, their planes, and the facets that went, as 4 * facet + a
    // corner. New facets live where old ones went, as far as those go.
    [[nodiscard]] std::span<const Index> star() const { return {star_.facet.data(), star_.facet_count}; }
    [[nodiscard]] const StarPlanes& star_planes() const { return star_.planes; }
    [[nodiscard]] std::span<const Index> replaced() const { return {cavity_.data(), cavity_size_}; }

    // Frees what only insertions need.
    void finish();

    [[nodiscard]] std::uint64_t uncertain_tests() const { return uncertain_tests_; }
    [[nodiscard]] std::uint64_t tie_tests() const { return tie_tests_; }

private:
    [[nodiscard]] int infinite_corner(const Facet& facet) const;
    [[nodiscard]] int plane_side(Index site, Index facet) const;
    [[nodiscard]] bool sees_exactly(Index site, Index facet);
    void set_simplex_plane(Index facet);
    void set_side(Index facet, const FacetPlane& plane);
    void begin_cavity(Index facet);
    void find_cavity(Index site);
    void number_vertex(Index vertex, const Site& origin);
    void take_slots();
    void note_edges();
    void make_facets(Index site);

    Sites& sites_;
    std::vector<Facet> facets_;
    std::vector<FacetSide> sides_;
    std::vector<Index> free_;
    std::uint32_t insertion_ = 0;

    // Facets the site at hand sees, as 4 * facet + a corner; all others of its corners belong to facets before it.
    std::vector<Index> cavity_;
    std::size_t cavity_size_ = 0;
    Star star_;
    EdgeTable edges_;

    std::uint64_t uncertain_tests_ = 0;
    std::uint64_t tie_tests_ = 0;
};

inline int LiftedHull::infinite_corner(const Facet& facet) const {
    const Index infinity = sites_.infinity();
    return facet.vertex[3] == infinity ? 3 : facet.vertex[2] == infinity ? 2 : facet.vertex[1] == infinity ? 1 : 0;
}

inline int LiftedHull::plane_side(Index site, Index facet) const {
    const FacetSide& side = sides_[facet];
    const Site& origin = sites_.at[side.origin];
    const Site& point = sites_.at[site];
    return side.plane.side(point.x - origin.x, point.y - origin.y, point.z - origin.z);
}

inline bool LiftedHull::sees(Index site, Index facet) {
    const int side = plane_side(site, facet);
    return side != 0 ? side > 0 : sees_exactly(site, facet);
}

}
