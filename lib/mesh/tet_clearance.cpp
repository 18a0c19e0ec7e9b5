// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tet_clearance.h"

#include "geometry/predicates.h"

namespace crumple {

namespace {

// orient3d, without asking for exact arithmetic where shell and tet share a corner: almost every time.
int side_of(Vec3 a, Vec3 b, Vec3 c, Vec3 p) { return p == a || p == b || p == c ? 0 : orient3d(a, b, c, p); }

bool is_outside_a_face(const Corners& triangle, const std::array<Vec3, 4>& tet) {
    for (const auto& [a, b, c] : tet_face_corners) {
        // The tet's own side of its faces is the negative one.
        bool separates = true;
        for (const Vec3& p : triangle) separates = separates && side_of(tet[a], tet[b], tet[c], p) >= 0;
        if (separates) return true;
    }
    return false;
}

bool has_tet_on_one_side(const Corners& triangle, const std::array<Vec3, 4>& tet) {
    int lowest = 1;
    int highest = -1;
    for (const Vec3& p : tet) {
        const int side = side_of(triangle[0], triangle[1], triangle[2], p);
        lowest = std::min(lowest, side);
        highest = std::max(highest, side);
    }
    // All zero: a triangle without area, which has no plane.
    return (lowest >= 0 && highest > 0) || (highest <= 0 && lowest < 0);
}

// Does the plane through an edge of the tet and corner k of the triangle have the two on opposite sides?
bool edge_plane_separates(const Corners& triangle, const std::array<Vec3, 4>& tet, int edge, int k) {
    const Vec3 a = tet[tet_edge_corners[edge][0]];
    const Vec3 b = tet[tet_edge_corners[edge][1]];
    const Vec3 c = triangle[k];
    if (a == c || b == c) return false;
    // Edges are listed so that edge 5 - i joins the other two corners.
    const int first = side_of(a, b, c, tet[tet_edge_corners[5 - edge][0]]);
    const int second = side_of(a, b, c, tet[tet_edge_corners[5 - edge][1]]);
    if (first * second < 0 || (first == 0 && second == 0)) return false;
    const int side = first != 0 ? first : second;
    return side_of(a, b, c, triangle[(k + 1) % 3]) * side <= 0 && side_of(a, b, c, triangle[(k + 2) % 3]) * side <= 0;
}

}

// Two convex bodies are apart when some plane parts them: a face of one, or one through an edge of the tet and a corner
// of the triangle. The remaining kind, an edge of the triangle and a corner of the tet, is not tried: it decides few
// pairs.
bool may_enter(const Corners& triangle, const std::array<Vec3, 4>& tet) {
    if (is_outside_a_face(triangle, tet) || has_tet_on_one_side(triangle, tet)) return false;
    for (int edge = 0; edge < 6; ++edge) {
        for (int k = 0; k < 3; ++k) {
            if (edge_plane_separates(triangle, tet, edge, k)) return false;
        }
    }
    return true;
}

TetClearance::TetClearance(const Shell& shell) {
    std::vector<Box> boxes;
    for (const auto& [a, b, c] : shell.triangles) {
        triangles_.push_back({shell.positions[a], shell.positions[b], shell.positions[c]});
        boxes.push_back(bounding_box(triangles_.back()));
    }
    tree_ = Bvh(boxes);
}

bool TetClearance::is_clear(const std::array<Vec3, 4>& tet) const {
    bool is_clear = true;
    tree_.touching(bounding_box(tet), [&](Index triangle) {
        is_clear = !may_enter(triangles_[triangle], tet);
        return !is_clear;
    });
    return is_clear;
}

}
