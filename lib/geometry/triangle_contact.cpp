// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/measures.h"
#include "geometry/predicates.h"

namespace crumple {

namespace {

// A plane to look at coplanar points in: two of the three axes, chosen so that the triangle keeps an area there.
struct Projection {
    int u = 0;
    int v = 1;

    // Sign of the turn a, b, c. orient3d over a point above c is the exact 2D determinant.
    [[nodiscard]] int turn(Vec3 a, Vec3 b, Vec3 c) const {
        return orient3d(flat(a), flat(b), flat(c), {c[u], c[v], 1});
    }

private:
    [[nodiscard]] Vec3 flat(Vec3 p) const { return {p[u], p[v], 0}; }
};

// Of the three axis pairs the first in which the corners are not in line; u = v when the triangle has no area.
Projection projection_of(const Corners& t) {
    for (const auto& [u, v] : {std::pair{0, 1}, {1, 2}, {2, 0}}) {
        const Projection projection{u, v};
        if (projection.turn(t[0], t[1], t[2]) != 0) return projection;
    }
    return {0, 0};
}

bool has_area(const Corners& t) {
    const Projection projection = projection_of(t);
    return projection.u != projection.v;
}

// All points in the plane of the triangle (a, b, c), which has area.
bool triangle_holds(const Projection& plane, const Corners& t, Vec3 p) {
    const int ab = plane.turn(t[0], t[1], p);
    const int bc = plane.turn(t[1], t[2], p);
    const int ca = plane.turn(t[2], t[0], p);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

bool in_box(const Projection& plane, Vec3 a, Vec3 b, Vec3 p) {
    for (const int axis : {plane.u, plane.v}) {
        if (p[axis] < std::min(a[axis], b[axis]) || p[axis] > std::max(a[axis], b[axis])) return false;
    }
    return true;
}

bool segments_meet_flat(const Projection& plane, Vec3 p, Vec3 q, Vec3 a, Vec3 b) {
    const int p_side = plane.turn(a, b, p);
    const int q_side = plane.turn(a, b, q);
    const int a_side = plane.turn(p, q, a);
    const int b_side = plane.turn(p, q, b);
    if (p_side * q_side < 0 && a_side * b_side < 0) return true;
    return (p_side == 0 && in_box(plane, a, b, p)) || (q_side == 0 && in_box(plane, a, b, q)) ||
           (a_side == 0 && in_box(plane, p, q, a)) || (b_side == 0 && in_box(plane, p, q, b));
}

bool segment_meets_flat(const Corners& t, Vec3 p, Vec3 q) {
    const Projection plane = projection_of(t);
    if (triangle_holds(plane, t, p) || triangle_holds(plane, t, q)) return true;
    for (int i = 0; i < 3; ++i) {
        if (segments_meet_flat(plane, p, q, t[i], t[(i + 1) % 3])) return true;
    }
    return false;
}

// Closed segment against closed triangle.
bool segment_meets(const Corners& t, Vec3 p, Vec3 q) {
    const int p_side = orient3d(t[0], t[1], t[2], p);
    const int q_side = orient3d(t[0], t[1], t[2], q);
    if (p_side == 0 && q_side == 0) return segment_meets_flat(t, p, q);
    if (p_side * q_side > 0) return false;
    if (p_side == 0) return triangle_holds(projection_of(t), t, p);
    if (q_side == 0) return triangle_holds(projection_of(t), t, q);
    const int ab = orient3d(p, q, t[0], t[1]);
    const int bc = orient3d(p, q, t[1], t[2]);
    const int ca = orient3d(p, q, t[2], t[0]);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

bool on_one_side(const Corners& plane, const Corners& t) {
    const int side = orient3d(plane[0], plane[1], plane[2], t[0]);
    return side != 0 && orient3d(plane[0], plane[1], plane[2], t[1]) == side &&
           orient3d(plane[0], plane[1], plane[2], t[2]) == side;
}

bool apart_triangles_meet(const Corners& a, const Corners& b) {
    if (on_one_side(a, b) || on_one_side(b, a)) return false;
    for (int i = 0; i < 3; ++i) {
        if (segment_meets(a, b[i], b[(i + 1) % 3]) || segment_meets(b, a[i], a[(i + 1) % 3])) return true;
    }
    return false;
}

// a[0] and b[0] are the shared corner. Beyond it the triangles meet when an edge away from the corner reaches the other
// triangle, or, in one plane, when an edge at the corner runs into the other's.
bool corner_sharers_meet(const Corners& a, const Corners& b) {
    return segment_meets(a, b[1], b[2]) || segment_meets(b, a[1], a[2]);
}

// a[0], a[1] and b[0], b[1] are the shared edge: only folded onto each other do they meet beyond it.
bool edge_sharers_meet(const Corners& a, const Corners& b) {
    if (orient3d(a[0], a[1], a[2], b[2]) != 0) return false;
    const Projection plane = projection_of(a);
    return plane.turn(a[0], a[1], a[2]) == plane.turn(a[0], a[1], b[2]);
}

// Brings the corners that both triangles have to the front, in the same order; returns their number.
int bring_shared_forward(Corners& a, Corners& b) {
    int shared = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = shared; j < 3; ++j) {
            if (!(a[i] == b[j])) continue;
            std::swap(a[i], a[shared]);
            std::swap(b[j], b[shared]);
            ++shared;
            break;
        }
    }
    return shared;
}

}

bool triangles_meet(const Corners& first, const Corners& second) {
    Corners a = first;
    Corners b = second;
    bool meet = false;
    switch (bring_shared_forward(a, b)) {
        case 0:
            meet = apart_triangles_meet(a, b);
            break;
        case 1:
            meet = corner_sharers_meet(a, b);
            break;
        case 2:
            meet = edge_sharers_meet(a, b);
            break;
        default:
            break;
    }
    // Asked last: few pairs come this far, and flat answers are the expensive ones.
    return meet && has_area(a) && has_area(b);
}

bool is_on_triangle(const Corners& triangle, Vec3 p) {
    if (!bounding_box(triangle).holds(p) || orient3d(triangle[0], triangle[1], triangle[2], p) != 0) return false;
    const Projection plane = projection_of(triangle);
    return plane.u != plane.v && triangle_holds(plane, triangle, p);
}

// The middle of the nearest points of an alternating walk: each step goes to the nearest point of the other triangle.
Vec3 contact_place(const Corners& a, const Corners& b) {
    Vec3 place = (b[0] + b[1] + b[2]) / 3;
    for (int step = 0; step < 16; ++step) {
        place = closest_point_on_triangle(a[0], a[1], a[2], place);
        place = closest_point_on_triangle(b[0], b[1], b[2], place);
    }
    return place;
}

}
