// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/cavity.h"

#include <algorithm>
#include <cmath>

#include "geometry/measures.h"
#include "geometry/predicates.h"

namespace crumple::recover {

namespace {

// A cone from a node that is there is good enough from this quality on: a node less is worth more than rounder tets.
constexpr double good_enough = 0.05;

// Like quality_of (flips.h) but for its constant factor, as it is only compared.
double shape_of(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const double squares = dot(b - a, b - a) + dot(c - a, c - a) + dot(d - a, d - a) + dot(c - b, c - b) +
                           dot(d - b, d - b) + dot(d - c, d - c);
    const double mean = squares / 6;
    return signed_volume(a, b, c, d) / (mean * std::sqrt(mean));
}

// Of the worst tet of a cone, or 0 when one is not positive. The apex itself is `node` or none.
double cone_quality(const TetComplex& complex, const Cavity& cavity, Index node, Vec3 apex, double at_least) {
    double worst = 2;
    for (const Triangle& face : cavity.faces) {
        if (has_corner(face, node)) continue;
        const Vec3 a = complex.position(face[0]);
        const Vec3 b = complex.position(face[1]);
        const Vec3 c = complex.position(face[2]);
        // Faces are seen counter-clockwise from outside, so the apex is on their other side.
        worst = std::min(worst, shape_of(a, c, b, apex));
        if (worst <= at_least || orient3d(a, c, b, apex) <= 0) return 0;
    }
    return worst;
}

std::vector<Index> nodes_of(const Cavity& cavity) {
    std::vector<Index> nodes;
    for (const Triangle& face : cavity.faces) nodes.insert(nodes.end(), face.begin(), face.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}

Triangle outward_face(const Tet& tet, int corner) {
    const auto& face = tet_face_corners[corner];
    return {tet[face[0]], tet[face[1]], tet[face[2]]};
}

Filling best_filling(const TetComplex& complex, const Cavity& cavity, Vec3 seed) {
    Filling best;
    const std::vector<Index> nodes = nodes_of(cavity);
    Vec3 middle;
    for (const Index v : nodes) {
        middle += complex.position(v) / static_cast<double>(nodes.size());
        const double quality = cone_quality(complex, cavity, v, complex.position(v), best.quality);
        if (quality > best.quality) best = {v, {}, quality};
    }
    if (best.quality >= good_enough) return best;
    double reach = 1;
    for (int halving = 0; halving < 20; ++halving, reach *= 0.5) {
        const Vec3 place = round_to_float(seed + (middle - seed) * reach);
        const double quality = cone_quality(complex, cavity, none, place, best.quality);
        if (quality > best.quality) best = {none, place, quality};
    }
    return best;
}

void append_cone(const Cavity& cavity, Index apex, std::vector<Tet>& tets) {
    for (const Triangle& face : cavity.faces) {
        if (!has_corner(face, apex)) tets.push_back({face[0], face[2], face[1], apex});
    }
}

}
