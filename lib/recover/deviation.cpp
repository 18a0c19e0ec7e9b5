// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/measures.h"

namespace crumple::recover {

namespace {

double ratio(double a, double b) { return b != 0 ? a / b : 0; }

double distance_to_line(Vec3 p, Vec3 a, Vec3 b) {
    const Vec3 d = b - a;
    const Vec3 across = cross(d, p - a);
    return std::sqrt(ratio(dot(across, across), dot(d, d)));
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

double deviation_of_segment(const TetComplex& complex, const Edge& segment) {
    const Vec3 a = complex.position(segment[0]);
    const Vec3 d = complex.position(segment[1]) - a;
    std::vector<Crossing> crossings;
    crossings_of_segment(complex, segment[0], segment[1], crossings);
    double farthest = 0;
    for (const Crossing& crossing : crossings) {
        if (crossing.count != 3) continue;
        const Vec3 place = a + d * crossing_share(complex, segment, crossing);
        double nearest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            nearest = std::min(nearest, distance_to_line(place, complex.position(crossing.nodes[i]),
                                                         complex.position(crossing.nodes[(i + 1) % 3])));
        }
        farthest = std::max(farthest, nearest);
    }
    return ratio(farthest, length(d));
}

double deviation_of_facet(const TetComplex& complex, const Triangle& facet) {
    for (int i = 0; i < 3; ++i) {
        if (complex.find_edge(facet[i], facet[(i + 1) % 3]) == none) return 0;
    }
    const Vec3 a = complex.position(facet[0]);
    const Vec3 b = complex.position(facet[1]);
    const Vec3 c = complex.position(facet[2]);
    const Vec3 n = area_vector(a, b, c);
    const double longest = std::max({length(b - a), length(c - b), length(a - c)});
    FacetObstacles obstacles;
    obstacles_of_facet(complex, facet, obstacles);
    double farthest = 0;
    for (const PiercingEdge& edge : obstacles.edges) {
        const double p = std::fabs(dot(complex.position(edge.nodes[0]) - a, n));
        const double q = std::fabs(dot(complex.position(edge.nodes[1]) - a, n));
        farthest = std::max(farthest, std::min(p, q));
    }
    return ratio(farthest, length(n) * longest);
}

}
