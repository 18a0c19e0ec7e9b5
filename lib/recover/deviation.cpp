// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/measures.h"

namespace crumple::recover {

namespace {

double ratio(double a, double b) { return b != 0 ? a / b : 0; }

// Sine of the fold above which an edge of the shell is one to be seen: 5 degrees. Below it an exchanged diagonal moves
// the surface by less than 1/45 of its length, and thin triangles forced into the tets cost more than that is worth.
constexpr double sharp = 0.087;

// The plane of a triangle, to measure heights above it.
struct Plane {
    Vec3 through;
    Vec3 normal;  // of length 1, or 0 for a triangle without area

    Plane(Vec3 a, Vec3 b, Vec3 c) : through(a), normal(area_vector(a, b, c)) {
        const double size = length(normal);
        if (size > 0) normal = normal / size;
    }
    [[nodiscard]] double height(Vec3 p) const { return dot(p - through, normal); }
};

// How far the nodes of an edge or face reach to both sides of a plane: the lesser of the two.
double straddle(const TetComplex& complex, const Plane& plane, std::span<const Index> nodes) {
    double above = 0;
    double below = 0;
    for (const Index v : nodes) {
        const double height = plane.height(complex.position(v));
        above = std::max(above, height);
        below = std::max(below, -height);
    }
    return std::min(above, below);
}

bool is_flat(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 m = area_vector(a, b, c);
    const Vec3 n = area_vector(b, a, d);
    const Vec3 turn = cross(m, n);
    return dot(m, n) > 0 && dot(turn, turn) <= sharp * sharp * dot(m, m) * dot(n, n);
}

}

double crossing_share(const TetComplex& complex, const Edge& segment, const Crossing& crossing) {
    const auto at = [&](Index v) { return complex.position(v); };
    const Vec3 a = at(segment[0]);
    const Vec3 d = at(segment[1]) - a;
    if (crossing.count == 1) return ratio(dot(at(crossing.nodes[0]) - a, d), dot(d, d));
    if (crossing.count == 2) {
        // Nearest approach of two lines.
        const Vec3 p = at(crossing.nodes[0]) - a;
        const Vec3 e = at(crossing.nodes[1]) - at(crossing.nodes[0]);
        const Vec3 n = cross(d, e);
        return ratio(dot(cross(p, e), n), dot(n, n));
    }
    const Vec3 n = area_vector(at(crossing.nodes[0]), at(crossing.nodes[1]), at(crossing.nodes[2]));
    return ratio(dot(at(crossing.nodes[0]) - a, n), dot(d, n));
}

Vec3 piercing_place(const TetComplex& complex, const Triangle& facet, const Edge& edge) {
    const Crossing face{{facet[0], facet[1], facet[2]}, 3, none};
    const Vec3 p = complex.position(edge[0]);
    return p + (complex.position(edge[1]) - p) * std::clamp(crossing_share(complex, edge, face), 0.0, 1.0);
}

bool is_covered(const TetComplex& complex, const Triangle& facet) {
    FacetObstacles obstacles;
    obstacles_of_any_facet(complex, facet, obstacles);
    return obstacles.edges.empty() && obstacles.node == none;
}

bool is_covered(const TetComplex& complex, const Edge& segment, std::span<const Index> apexes) {
    std::vector<Crossing> crossings;
    crossings_of_segment(complex, segment[0], segment[1], crossings);
    return std::all_of(crossings.begin(), crossings.end(), [](const Crossing& c) { return c.count == 2; }) &&
           std::all_of(apexes.begin(), apexes.end(), [&](Index apex) {
               return is_covered(complex, Triangle{segment[0], segment[1], apex});
           });
}

double deviation_of_segment(const TetComplex& complex, const Edge& segment, std::span<const Index> apexes) {
    const Vec3 a = complex.position(segment[0]);
    const Vec3 b = complex.position(segment[1]);
    if (apexes.size() != 2 || !is_flat(a, b, complex.position(apexes[0]), complex.position(apexes[1])))
        return std::numeric_limits<double>::infinity();
    std::vector<Crossing> crossings;
    crossings_of_segment(complex, segment[0], segment[1], crossings);
    double farthest = 0;
    for (const Index apex : apexes) {
        const Plane plane(a, b, complex.position(apex));
        for (const Crossing& crossing : crossings) {
            const std::span<const Index> nodes(crossing.nodes.data(), crossing.count);
            farthest = std::max(farthest, straddle(complex, plane, nodes));
        }
    }
    return farthest;
}

double deviation_of_facet(const TetComplex& complex, const Triangle& facet) {
    const Vec3 a = complex.position(facet[0]);
    const Vec3 b = complex.position(facet[1]);
    const Vec3 c = complex.position(facet[2]);
    const Plane plane(a, b, c);
    FacetObstacles obstacles;
    obstacles_of_any_facet(complex, facet, obstacles);
    double farthest = 0;
    for (const PiercingEdge& edge : obstacles.edges)
        farthest = std::max(farthest, straddle(complex, plane, edge.nodes));
    return farthest;
}

}
