// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/lifted_hull.h"

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "delaunay/conflict.h"
#include "geometry/predicates.h"

namespace crumple::delaunay {
namespace {

// A facet and a corner share 32 bits.
constexpr std::size_t most_facets = std::size_t{1} << 30;

// First sizes of the scratch of an insertion; a random site's star has 27 facets.
constexpr std::size_t usual_star = 256;

}

LiftedHull::LiftedHull(Sites& sites) : sites_(sites) {
    const std::size_t usual_facets = sites.count() * std::size_t{34} / 5 + 64;
    facets_.reserve(usual_facets);
    sides_.reserve(usual_facets);
    cavity_.resize(usual_star);
    star_.reserve(usual_star);
}

void LiftedHull::set_side(Index facet, const FacetPlane& plane) {
    FacetSide& side = sides_[facet];
    side.plane = plane;
    side.origin = facets_[facet].vertex[0];
    side.mark = 0;
    if (sites_.exact_only) side.plane.normal_error = std::numeric_limits<float>::infinity();
}

void LiftedHull::set_simplex_plane(Index facet) {
    const auto& vertex = facets_[facet].vertex;
    const Site& origin = sites_.at[vertex[0]];
    for (std::uint32_t i = 1; i < 4; ++i) {
        const Site& p = sites_.at[vertex[i]];
        if (vertex[i] == sites_.infinity()) {
            star_.position.set_infinite(i - 1);
        } else {
            star_.position.set(i - 1, p.x - origin.x, p.y - origin.y, p.z - origin.z);
        }
        star_.planes.corner[i - 1][0] = i - 1;
    }
    make_planes(star_.position, star_.planes, 1);
    set_side(facet, star_.planes[0]);
}

void LiftedHull::start(const std::array<Index, 4>& simplex) {
    facets_.resize(5);
    sides_.resize(5);
    facets_[0].vertex = simplex;
    for (Index i = 0; i < 4; ++i) {
        Facet& outer = facets_[i + 1];
        for (int k = 0; k < 3; ++k) outer.vertex[k] = simplex[tet_face_corners[i][k]];
        outer.vertex[3] = sites_.infinity();
        facets_[0].neighbour[i] = 4 * (i + 1) + 3;
        outer.neighbour[3] = i;
    }
    // Two infinite facets meet opposite the vertex each of them lacks of the other.
    for (Index i = 0; i < 4; ++i) {
        for (Index k = 0; k < 3; ++k) {
            const auto other = static_cast<Index>(tet_face_corners[i][k]);
            Index corner = 0;
            while (facets_[other + 1].vertex[corner] != simplex[i]) ++corner;
            facets_[i + 1].neighbour[k] = 4 * (other + 1) + corner;
        }
    }
    star_.facet_count = facets_.size();
    for (Index i = 0; i < facets_.size(); ++i) {
        set_simplex_plane(i);
        star_.facet[i] = i;
    }
}

bool LiftedHull::sees_exactly(Index site, Index number) {
    ++uncertain_tests_;
    const Facet& facet = facets_[number];
    std::array<Vec3, 4> corner;
    for (int i = 0; i < 4; ++i) corner[i] = sites_.at[facet.vertex[i]].position();
    const Vec3 point = sites_.at[site].position();
    if (const int infinite = infinite_corner(facet)) {
        corner[infinite] = point;
        const int side = orient3d(corner[0], corner[1], corner[2], corner[3], sites_.grain);
        // In the plane of the hull face its circle decides, which the finite tet's sphere cuts out of the plane.
        return side != 0 ? side > 0 : sees(site, facet.neighbour[infinite] / 4);
    }
    const int side = in_sphere(corner[0], corner[1], corner[2], corner[3], point, sites_.grain);
    if (side != 0) return side > 0;
    ++tie_tests_;
    return is_inside_after_tie(corner, point, sites_.grain);
}

void LiftedHull::number_vertex(Index vertex, const Site& origin) {
    Site& site = sites_.at[vertex];
    if (site.stamp == insertion_) return;
    site.stamp = insertion_;
    site.local = star_.vertex_count++;
    star_.vertex[site.local] = vertex;
    if (vertex == sites_.infinity()) {
        star_.position.set_infinite(site.local);
    } else {
        star_.position.set(site.local, site.x - origin.x, site.y - origin.y, site.z - origin.z);
    }
}

void LiftedHull::begin_cavity(Index facet) {
    ++insertion_;
    star_.facet_count = 0;
    star_.vertex_count = 0;
    cavity_[0] = 4 * facet;
    cavity_size_ = 1;
    sides_[facet].mark = 2 * insertion_ + 1;
}

// The facets the site sees are connected: spread from the first over all ridges. Marks: odd seen, even not seen.
// Whether a facet is seen is a coin toss that no branch predictor wins, and the answer comes late; so both outcomes are
// written down and only the counters depend on it.
void LiftedHull::find_cavity(Index site) {
    const std::uint32_t unseen = 2 * insertion_;
    const Site& origin = sites_.at[site];
    for (const Index vertex : facets_[cavity_[0] / 4].vertex) number_vertex(vertex, origin);
    for (std::size_t next = 0; next < cavity_size_; ++next) {
        if (cavity_.size() < cavity_size_ + 4) cavity_.resize(2 * cavity_.size());
        star_.reserve(std::max<std::size_t>(star_.facet_count, star_.vertex_count) + 4);
        const Facet& inner = facets_[cavity_[next] / 4];
        number_vertex(inner.vertex[cavity_[next] % 4], origin);
        std::uint32_t local[4];
        for (int corner = 0; corner < 4; ++corner) local[corner] = sites_.at[inner.vertex[corner]].local;
        for (int corner = 0; corner < 4; ++corner) {
            const Index beyond = inner.neighbour[corner];
            FacetSide& other = sides_[beyond / 4];
            if (other.mark - unseen > 1) {
                const bool is_seen = sees(site, beyond / 4);
                other.mark = unseen + is_seen;
                cavity_[cavity_size_] = beyond;
                cavity_size_ += is_seen;
            }
            const int* face = tet_face_corners[corner];
            star_.add_triangle(local[face[0]], local[face[1]], local[face[2]], beyond, other.mark == unseen);
        }
    }
}

// New facets live where old ones were, as far as those go.
void LiftedHull::take_slots() {
    const std::size_t reused = std::min(cavity_size_, star_.facet_count);
    for (std::size_t i = 0; i < reused; ++i) star_.facet[i] = cavity_[i] / 4;
    for (std::size_t i = reused; i < cavity_size_; ++i) {
        facets_[cavity_[i] / 4].vertex[0] = none;
        free_.push_back(cavity_[i] / 4);
    }
    for (std::size_t i = reused; i < star_.facet_count; ++i) {
        if (!free_.empty()) {
            star_.facet[i] = free_.back();
            free_.pop_back();
        } else {
            if (facets_.size() == most_facets) throw Error(ErrorKind::budget, "delaunay: more than 2^30 tetrahedra");
            star_.facet[i] = static_cast<Index>(facets_.size());
            facets_.emplace_back();
            sides_.emplace_back();
        }
    }
}

void LiftedHull::note_edges() {
    edges_.start(star_.vertex_count, 3 * star_.facet_count);
    for (std::size_t i = 0; i < star_.facet_count; ++i) {
        const std::uint32_t a = star_.planes.corner[0][i];
        const std::uint32_t b = star_.planes.corner[1][i];
        const std::uint32_t c = star_.planes.corner[2][i];
        const Index code = 4 * star_.facet[i];
        edges_.put(b, c, code + 1);
        edges_.put(c, a, code + 2);
        edges_.put(a, b, code + 3);
    }
}

void LiftedHull::make_facets(Index site) {
    for (std::size_t i = 0; i < star_.facet_count; ++i) {
        const std::uint32_t a = star_.planes.corner[0][i];
        const std::uint32_t b = star_.planes.corner[1][i];
        const std::uint32_t c = star_.planes.corner[2][i];
        const Index beyond = star_.beyond[i];
        Facet& facet = facets_[star_.facet[i]];
        facet.vertex = {site, star_.vertex[a], star_.vertex[b], star_.vertex[c]};
        facet.neighbour = {beyond, edges_.get(c, b), edges_.get(a, c), edges_.get(b, a)};
        set_side(star_.facet[i], star_.planes[i]);
        facets_[beyond / 4].neighbour[beyond % 4] = 4 * star_.facet[i];
    }
}

void LiftedHull::insert(Index site, Index facet) {
    begin_cavity(facet);
    find_cavity(site);
    take_slots();
    note_edges();
    make_planes(star_.position, star_.planes, star_.facet_count);
    make_facets(site);
}

void LiftedHull::finish() {
    std::vector<FacetSide>().swap(sides_);
    std::vector<Index>().swap(free_);
}

}
