// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/face_removal.h"

#include <algorithm>

namespace crumple::finish {

namespace {

// More faces than this between two nodes do not occur where shapes are worth keeping.
constexpr int max_depth = 3;

// The two tets on a face, one with the node above, the other with the node below.
struct Sandwich {
    Index upper;
    Index lower;
};

class FaceRemoval {
public:
    FaceRemoval(const WorkMesh& mesh, Index above, Index below, double floor, Exchange& exchange)
        : mesh_(mesh), above_(above), below_(below), floor_(floor), exchange_(exchange) {}

    // Removes the face (x, y, z) of `here`, counter-clockwise seen from above. The least shape, 0: in vain.
    double remove_first(Sandwich here, Index x, Index y, Index z) {
        take(here);
        double least = beyond(here, x, y, max_depth);
        if (least > floor_) least = std::min(least, beyond(here, y, z, max_depth));
        if (least > floor_) least = std::min(least, beyond(here, z, x, max_depth));
        return least;
    }

private:
    void take(Sandwich here) {
        exchange_.old.push_back(here.upper);
        exchange_.old.push_back(here.lower);
    }

    // The best that can stand at side (x, y) of a removed face: one tet, or what comes of removing the next face too.
    double beyond(Sandwich here, Index x, Index y, int depth) {
        const std::size_t old = exchange_.old.size();
        const std::size_t fresh = exchange_.fresh.size();
        const Tet tet{below_, above_, x, y};
        const double alone = shape_of(mesh_, tet);
        if (depth > 0) {
            const double farther = remove_next(here, x, y, depth, std::max(alone, floor_));
            if (farther > std::max(alone, floor_)) return farther;
            exchange_.old.resize(old);
            exchange_.fresh.resize(fresh);
        }
        exchange_.fresh.push_back(tet);
        return alone;
    }

    double remove_next(Sandwich here, Index x, Index y, int depth, double wanted) {
        const TetComplex& complex = mesh_.complex;
        const Index upper = across(here.upper, above_, x, y);
        const Index lower = across(here.lower, below_, x, y);
        if (upper == none || lower == none) return 0;
        const Index apex = other_corner(upper, above_, x, y);
        if (complex.corner_of(lower, apex) < 0 || complex.region(upper) != complex.region(here.upper)) return 0;
        if (complex.region(lower) != complex.region(here.upper)) return 0;
        if (complex.neighbour(upper, complex.corner_of(upper, above_)) != lower) return 0;
        const bool is_taken = std::find(exchange_.old.begin(), exchange_.old.end(), upper) != exchange_.old.end();
        if (is_taken) return 0;
        take({upper, lower});
        double least = beyond({upper, lower}, x, apex, depth - 1);
        if (least > wanted) least = std::min(least, beyond({upper, lower}, apex, y, depth - 1));
        return least;
    }

    [[nodiscard]] Index other_corner(Index tet, Index a, Index b, Index c) const {
        for (const Index v : mesh_.complex.corners(tet)) {
            if (v != a && v != b && v != c) return v;
        }
        return none;
    }

    // The tet on the other side of the face (a, b, c) of `tet`.
    [[nodiscard]] Index across(Index tet, Index a, Index b, Index c) const {
        return mesh_.complex.neighbour(tet, mesh_.complex.corner_of(tet, other_corner(tet, a, b, c)));
    }

    const WorkMesh& mesh_;
    Index above_;
    Index below_;
    double floor_;
    Exchange& exchange_;
};

}

bool plan_face_removal(const WorkMesh& mesh, Index tet, int corner, double floor, Exchange& exchange) {
    exchange.clear();
    const TetComplex& complex = mesh.complex;
    const Index other = complex.neighbour(tet, corner);
    if (other == none || complex.region(other) != complex.region(tet)) return false;
    const Index below = complex.corners(tet)[corner];
    const Index above = complex.corners(other)[complex.face_towards(other, tet)];
    // The face is counter-clockwise seen from outside the tet, which is where the other node lies: above.
    const auto& face = tet_face_corners[corner];
    const Tet& corners = complex.corners(tet);
    FaceRemoval removal(mesh, above, below, floor, exchange);
    exchange.least = removal.remove_first({other, tet}, corners[face[0]], corners[face[1]], corners[face[2]]);
    return exchange.least > floor && are_positive(mesh, exchange.fresh);
}

}
