// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/crossings.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/error.h"
#include "geometry/predicates.h"

namespace crumple::recover {

namespace {

// The part of the closed triangle (p, q, r) that the line ab meets, known to cross its plane in one point: the face,
// one of its edges or one of its corners; count = 0 when it misses.
Crossing meet_line(const TetComplex& complex, Index a, Index b, const Triangle& face) {
    const auto at = [&](Index v) { return complex.position(v); };
    const auto [p, q, r] = face;
    const int pq = orient3d(at(a), at(b), at(p), at(q));
    const int qr = orient3d(at(a), at(b), at(q), at(r));
    const int rp = orient3d(at(a), at(b), at(r), at(p));
    const bool has_plus = pq > 0 || qr > 0 || rp > 0;
    const bool has_minus = pq < 0 || qr < 0 || rp < 0;
    if (has_plus == has_minus) return {};
    const int zeros = (pq == 0) + (qr == 0) + (rp == 0);
    if (zeros == 0) return {{p, q, r}, 3};
    if (zeros == 2) return {{pq != 0 ? r : qr != 0 ? p : q, none, none}, 1};
    if (pq == 0) return {{p, q, none}, 2};
    if (qr == 0) return {{q, r, none}, 2};
    return {{r, p, none}, 2};
}

Crossing leave_node(const TetComplex& complex, Index a, Index b, std::vector<Index>& star) {
    const auto at = [&](Index v) { return complex.position(v); };
    complex.star_of(a, star);
    for (const Index t : star) {
        if (complex.corner_of(t, b) >= 0) return {{b, none, none}, 1, t};
    }
    for (const Index t : star) {
        const Tet& tet = complex.corners(t);
        const auto& face = tet_face_corners[complex.corner_of(t, a)];
        // Counter-clockwise from outside: (a, u, v, w) is positive.
        const Index u = tet[face[0]];
        const Index v = tet[face[1]];
        const Index w = tet[face[2]];
        const int beyond_uv = orient3d(at(a), at(u), at(v), at(b));
        if (beyond_uv < 0) continue;
        const int beyond_vw = orient3d(at(a), at(v), at(w), at(b));
        if (beyond_vw < 0) continue;
        const int beyond_wu = orient3d(at(a), at(w), at(u), at(b));
        if (beyond_wu < 0) continue;
        const int zeros = (beyond_uv == 0) + (beyond_vw == 0) + (beyond_wu == 0);
        if (zeros == 0) return {{u, v, w}, 3, t};
        if (zeros == 1) {
            if (beyond_uv == 0) return {{u, v, none}, 2, t};
            if (beyond_vw == 0) return {{v, w, none}, 2, t};
            return {{w, u, none}, 2, t};
        }
        return {{beyond_uv != 0 ? w : beyond_vw != 0 ? u : v, none, none}, 1, t};
    }
    return {};
}

Crossing leave_face(const TetComplex& complex, Index a, Index b, const Crossing& entry) {
    const auto [u, v, w] = entry.nodes;
    int apex_before = 0;
    for (int i = 0; i < 4; ++i) {
        const Index corner = complex.corners(entry.tet)[i];
        if (corner != u && corner != v && corner != w) apex_before = i;
    }
    const Index tet = complex.neighbour(entry.tet, apex_before);
    if (tet == none) return {};
    Index x = none;
    for (const Index corner : complex.corners(tet)) {
        if (corner != u && corner != v && corner != w) x = corner;
    }
    if (x == b) return {{b, none, none}, 1, tet};
    for (const Triangle& face : {Triangle{x, u, v}, Triangle{x, v, w}, Triangle{x, w, u}}) {
        Crossing exit = meet_line(complex, a, b, face);
        exit.tet = tet;
        if (exit.count > 0) return exit;
    }
    return {};
}

Crossing leave_edge(const TetComplex& complex, Index a, Index b, const Crossing& entry, TetRing& ring) {
    const auto at = [&](Index v) { return complex.position(v); };
    const Index u = entry.nodes[0];
    const Index v = entry.nodes[1];
    complex.ring_of(entry.tet, u, v, ring);
    for (std::size_t i = 0; i < ring.tets.size(); ++i) {
        const Index y = ring.link[i];
        const Index z = ring.link[(i + 1) % ring.link.size()];
        const Index tet = ring.tets[i];
        if (y == b || z == b) return {{b, none, none}, 1, tet};
        const int before = orient3d(at(u), at(v), at(y), at(b));
        const int after = orient3d(at(u), at(v), at(b), at(z));
        if (before > 0 && after > 0) {
            for (const Triangle& face : {Triangle{u, y, z}, Triangle{v, y, z}}) {
                Crossing exit = meet_line(complex, a, b, face);
                exit.tet = tet;
                if (exit.count > 0) return exit;
            }
        }
        // Within the face (u, v, y), or (u, v, z) where the surface ends the ring.
        const bool along_y = before == 0 && after > 0;
        const bool along_z = after == 0 && before > 0;
        if (!along_y && !along_z) continue;
        const Index x = along_y ? y : z;
        const Index off = along_y ? z : y;
        const int at_x = orient3d(at(a), at(b), at(x), at(off));
        if (at_x == 0) return {{x, none, none}, 1, tet};
        const int at_u = orient3d(at(a), at(b), at(u), at(off));
        return {{at_x == at_u ? v : u, x, none}, 2, tet};
    }
    return {};
}

}

void crossings_of_segment(const TetComplex& complex, Index a, Index b, std::vector<Crossing>& crossings) {
    crossings.clear();
    std::vector<Index> star;
    TetRing ring;
    Crossing next = leave_node(complex, a, b, star);
    while (true) {
        CRUMPLE_CHECK(next.count > 0, "a segment between two nodes of a convex mesh stays in it");
        if (next.count == 1 && next.nodes[0] == b) return;
        crossings.push_back(next);
        if (next.count == 1) return;
        next = next.count == 3 ? leave_face(complex, a, b, next) : leave_edge(complex, a, b, next, ring);
    }
}

bool pierces(Vec3 a, Vec3 b, Vec3 p, Vec3 q, Vec3 r) {
    const int pq = orient3d(a, b, p, q);
    if (pq == 0 || orient3d(a, b, q, r) != pq || orient3d(a, b, r, p) != pq) return false;
    return orient3d(p, q, r, a) * orient3d(p, q, r, b) < 0;
}

bool segments_cross(Vec3 a, Vec3 b, Vec3 p, Vec3 q) {
    if (orient3d(a, b, p, q) != 0) return false;
    // Seen from a point off the plane: 2D orientations are orient3d with it.
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 eye = a;
        eye[axis] = std::fabs(a[axis]) * 2 + 1;
        const int ab_p = orient3d(a, b, p, eye);
        const int ab_q = orient3d(a, b, q, eye);
        if (ab_p == 0 || ab_q == 0) continue;
        return ab_p != ab_q && orient3d(p, q, a, eye) * orient3d(p, q, b, eye) < 0;
    }
    return false;
}

namespace {

// Adds the edges of the tets around `edge` that pierce the facet.
class Piercers {
public:
    Piercers(const TetComplex& complex, const Triangle& facet, FacetObstacles& obstacles)
        : complex_(complex), facet_(facet), found_(obstacles) {}

    void search(std::span<const Index> tets) {
        for (const Index t : tets) look_through(t);
        for (std::size_t i = 0; i < found_.edges.size() && found_.node == none; ++i) {
            const PiercingEdge edge = found_.edges[i];
            complex_.ring_of(edge.tet, edge.nodes[0], edge.nodes[1], ring_);
            for (const Index t : ring_.tets) look_through(t);
        }
    }

private:
    void look_through(Index tet) {
        const Tet& corners = complex_.corners(tet);
        for (const auto& [i, j] : tet_edge_corners) {
            const Edge edge{std::min(corners[i], corners[j]), std::max(corners[i], corners[j])};
            if (is_known(edge) || !is_piercing(edge)) continue;
            found_.edges.push_back({edge, tet});
        }
        for (const Index v : corners) {
            if (lies_within(v)) found_.node = v;
        }
    }

    [[nodiscard]] bool is_corner(Index v) const { return v == facet_[0] || v == facet_[1] || v == facet_[2]; }
    [[nodiscard]] bool is_known(const Edge& edge) const {
        return std::any_of(found_.edges.begin(), found_.edges.end(), [&](const auto& e) { return e.nodes == edge; });
    }
    [[nodiscard]] bool is_piercing(const Edge& edge) const {
        if (is_corner(edge[0]) || is_corner(edge[1])) return false;
        return pierces(at(edge[0]), at(edge[1]), at(facet_[0]), at(facet_[1]), at(facet_[2]));
    }
    [[nodiscard]] bool lies_within(Index v) const {
        if (is_corner(v) || orient3d(at(facet_[0]), at(facet_[1]), at(facet_[2]), at(v)) != 0) return false;
        const Vec3 a = at(facet_[0]);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 eye = a;
            eye[axis] = std::fabs(a[axis]) * 2 + 1;
            const int whole = orient3d(a, at(facet_[1]), at(facet_[2]), eye);
            if (whole == 0) continue;
            return orient3d(a, at(facet_[1]), at(v), eye) == whole &&
                   orient3d(at(facet_[1]), at(facet_[2]), at(v), eye) == whole &&
                   orient3d(at(facet_[2]), a, at(v), eye) == whole;
        }
        return false;
    }
    [[nodiscard]] Vec3 at(Index v) const { return complex_.position(v); }

    const TetComplex& complex_;
    const Triangle& facet_;
    FacetObstacles& found_;
    TetRing ring_;
};

}

void obstacles_of_facet(const TetComplex& complex, const Triangle& facet, FacetObstacles& obstacles) {
    obstacles.edges.clear();
    obstacles.node = none;
    const auto [a, b, c] = facet;
    const Index tet = complex.find_edge(a, b);
    CRUMPLE_CHECK(tet != none, "the edges of a facet come before it");
    TetRing ring;
    complex.ring_of(tet, a, b, ring);
    for (const Index v : ring.link) {
        if (v == c) return;
    }
    Piercers piercers(complex, facet, obstacles);
    const auto at = [&](Index v) { return complex.position(v); };
    for (std::size_t i = 0; i < ring.tets.size(); ++i) {
        const Index y = ring.link[i];
        const Index z = ring.link[(i + 1) % ring.link.size()];
        const int before = orient3d(at(a), at(b), at(y), at(c));
        const int after = orient3d(at(a), at(b), at(c), at(z));
        if (before >= 0 && after >= 0 && before + after > 0) piercers.search({&ring.tets[i], 1});
        if (!obstacles.edges.empty() || obstacles.node != none) return;
    }
}

// What cuts a triangle cuts its rim, or hangs together with what does: the tets at its corners and along its edges are
// enough to begin with.
void obstacles_of_any_facet(const TetComplex& complex, const Triangle& facet, FacetObstacles& obstacles) {
    obstacles.edges.clear();
    obstacles.node = none;
    std::vector<Index> tets;
    std::vector<Index> star;
    std::vector<Crossing> crossings;
    TetRing ring;
    for (int i = 0; i < 3; ++i) {
        complex.star_of(facet[i], star);
        tets.insert(tets.end(), star.begin(), star.end());
        crossings_of_segment(complex, facet[i], facet[(i + 1) % 3], crossings);
        for (const Crossing& crossing : crossings) {
            tets.push_back(crossing.tet);
            if (crossing.count != 2) continue;
            complex.ring_of(crossing.tet, crossing.nodes[0], crossing.nodes[1], ring);
            tets.insert(tets.end(), ring.tets.begin(), ring.tets.end());
        }
    }
    std::sort(tets.begin(), tets.end());
    tets.erase(std::unique(tets.begin(), tets.end()), tets.end());
    Piercers(complex, facet, obstacles).search(tets);
}

}
