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
    facets_.reserve(sites.count() * std::size_t{34} / 5 + 64);
    vertices_.resize(usual_star);
    planes_.resize(usual_star);
    star_.resize(usual_star);
}

void LiftedHull::set_simplex_plane(Facet& facet) {
    const Site& origin = sites_.at[facet.vertex[0]];
    for (std::uint32_t i = 1; i < 4; ++i) {
        const Site& p = sites_.at[facet.vertex[i]];
        if (facet.vertex[i] == sites_.infinity()) {
            vertices_.set_infinite(i - 1);
        } else {
            vertices_.set(i - 1, p.x - origin.x, p.y - origin.y, p.z - origin.z);
        }
        planes_.corner[i - 1][0] = i - 1;
    }
    make_planes(vertices_, planes_, 1);
    facet.plane = planes_[0];
    if (sites_.exact_only) facet.plane.normal_error = std::numeric_limits<float>::infinity();
}

void LiftedHull::start(const std::array<Index, 4>& simplex) {
    facets_.resize(5);
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
    star_size_ = facets_.size();
    for (Index i = 0; i < facets_.size(); ++i) {
        facets_[i].mark = 0;
        facets_[i].outside = none;
        set_simplex_plane(facets_[i]);
        star_[i] = i;
    }
}

bool LiftedHull::sees_exactly(Index site, const Facet& facet) {
    ++uncertain_tests_;
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

// The facets the site sees are connected: spread from the first over all ridges. Marks: odd seen, even not seen.
void LiftedHull::find_cavity(Index site, Index facet) {
    const std::uint32_t unseen = 2 * ++insertion_;
    const std::uint32_t seen = unseen + 1;
    cavity_.clear();
    rims_.clear();
    orphans_.clear();
    cavity_.push_back(facet);
    facets_[facet].mark = seen;
    for (std::size_t next = 0; next < cavity_.size(); ++next) {
        const Facet& inner = facets_[cavity_[next]];
        if (inner.outside != none) orphans_.push_back(inner.outside);
        for (int corner = 0; corner < 4; ++corner) {
            const Index beyond = inner.neighbour[corner];
            Facet& other = facets_[beyond / 4];
            if (other.mark == seen) continue;
            if (other.mark != unseen) {
                const bool is_seen = sees(site, beyond / 4);
                other.mark = is_seen ? seen : unseen;
                if (is_seen) {
                    cavity_.push_back(beyond / 4);
                    continue;
                }
            }
            const int* face = tet_face_corners[corner];
            rims_.push_back({{inner.vertex[face[0]], inner.vertex[face[1]], inner.vertex[face[2]]}, beyond});
        }
    }
}

// New facets live where old ones were, as far as those go.
void LiftedHull::take_slots() {
    star_size_ = rims_.size();
    if (star_.size() < star_size_) {
        star_.resize(2 * star_size_);
        planes_.resize(2 * star_size_);
        vertices_.resize(2 * star_size_);
    }
    const std::size_t reused = std::min(cavity_.size(), star_size_);
    std::copy_n(cavity_.begin(), reused, star_.begin());
    for (std::size_t i = reused; i < cavity_.size(); ++i) {
        facets_[cavity_[i]].vertex[0] = none;
        free_.push_back(cavity_[i]);
    }
    for (std::size_t i = reused; i < star_size_; ++i) {
        if (!free_.empty()) {
            star_[i] = free_.back();
            free_.pop_back();
        } else {
            if (facets_.size() == most_facets) throw Error(ErrorKind::budget, "delaunay: more than 2^30 tetrahedra");
            star_[i] = static_cast<Index>(facets_.size());
            facets_.emplace_back();
        }
    }
}

std::uint32_t LiftedHull::local_number(Index vertex, const Site& origin) {
    Site& site = sites_.at[vertex];
    if (site.stamp != insertion_) {
        site.stamp = insertion_;
        site.local = vertex_count_++;
        if (vertex == sites_.infinity()) {
            vertices_.set_infinite(site.local);
        } else {
            vertices_.set(site.local, site.x - origin.x, site.y - origin.y, site.z - origin.z);
        }
    }
    return site.local;
}

// Names the vertices of the star by small numbers and notes which facet runs through each directed edge.
void LiftedHull::number_star_vertices(Index site) {
    const Site& origin = sites_.at[site];
    vertex_count_ = 0;
    edges_.start(static_cast<std::uint32_t>(star_size_ / 2 + 2), 3 * star_size_);
    for (std::size_t i = 0; i < star_size_; ++i) {
        const auto& [a, b, c] = rims_[i].vertex;
        const std::uint32_t la = local_number(a, origin);
        const std::uint32_t lb = local_number(b, origin);
        const std::uint32_t lc = local_number(c, origin);
        planes_.corner[0][i] = la;
        planes_.corner[1][i] = lb;
        planes_.corner[2][i] = lc;
        const Index code = 4 * star_[i];
        edges_.put(lb, lc, code + 1);
        edges_.put(lc, la, code + 2);
        edges_.put(la, lb, code + 3);
    }
}

void LiftedHull::make_star(Index site) {
    make_planes(vertices_, planes_, star_size_);
    for (std::size_t i = 0; i < star_size_; ++i) {
        const Rim& rim = rims_[i];
        const std::uint32_t a = planes_.corner[0][i];
        const std::uint32_t b = planes_.corner[1][i];
        const std::uint32_t c = planes_.corner[2][i];
        Facet& facet = facets_[star_[i]];
        facet.vertex = {site, rim.vertex[0], rim.vertex[1], rim.vertex[2]};
        facet.neighbour = {rim.beyond, edges_.get(c, b), edges_.get(a, c), edges_.get(b, a)};
        facet.plane = planes_[i];
        if (sites_.exact_only) facet.plane.normal_error = std::numeric_limits<float>::infinity();
        facet.mark = 0;
        facet.outside = none;
        facets_[rim.beyond / 4].neighbour[rim.beyond % 4] = 4 * star_[i];
    }
}

void LiftedHull::insert(Index site, Index facet) {
    find_cavity(site, facet);
    take_slots();
    number_star_vertices(site);
    make_star(site);
}

}
