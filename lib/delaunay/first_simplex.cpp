// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/first_simplex.h"

#include <cmath>
#include <utility>

#include "geometry/predicates.h"

namespace crumple::delaunay {
namespace {

// The site of largest measure if it is fit, else the first that is; none when no site is.
template <class Measure, class IsFit>
Index farthest_fit(const Sites& sites, const Measure& measure, const IsFit& is_fit) {
    Index best = 0;
    double largest = -1;
    for (Index site = 0; site < sites.count(); ++site) {
        const double value = measure(sites.at[site].position());
        if (value > largest) {
            largest = value;
            best = site;
        }
    }
    if (is_fit(sites.at[best].position())) return best;
    for (Index site = 0; site < sites.count(); ++site) {
        if (is_fit(sites.at[site].position())) return site;
    }
    return none;
}

}

FirstSimplex find_first_simplex(const Sites& sites) {
    FirstSimplex simplex;
    auto& [a, b, c, d] = simplex.vertex;
    if (sites.count() == 0) return simplex;
    simplex.dimension = 0;
    if (sites.count() == 1) return simplex;

    simplex.dimension = 1;
    a = 0;
    const Vec3 pa = sites.at[a].position();
    b = farthest_fit(
        sites, [&](Vec3 p) { return dot(p - pa, p - pa); }, [&](Vec3 p) { return !(p == pa); });
    const Vec3 pb = sites.at[b].position();
    const auto off_line = [&](Vec3 p) {
        const Vec3 area = cross(pb - pa, p - pa);
        return dot(area, area);
    };
    c = farthest_fit(sites, off_line, [&](Vec3 p) { return !are_collinear(pa, pb, p); });
    if (c == none) return simplex;

    simplex.dimension = 2;
    const Vec3 pc = sites.at[c].position();
    const auto off_plane = [&](Vec3 p) { return std::fabs(dot(cross(pb - pa, pc - pa), p - pa)); };
    d = farthest_fit(sites, off_plane, [&](Vec3 p) { return orient3d(pa, pb, pc, p) != 0; });
    if (d == none) return simplex;

    simplex.dimension = 3;
    if (orient3d(pa, pb, pc, sites.at[d].position()) < 0) std::swap(a, b);
    return simplex;
}

}
