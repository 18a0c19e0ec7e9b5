// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/conflict.h"

#include <cassert>

#include "geometry/predicates.h"

namespace crumple::delaunay {
namespace {

// The corner that comes last in lexicographic order, leaving out one (or none: 4).
int last_corner(const std::array<Vec3, 4>& tet, int left_out) {
    int last = left_out == 0 ? 1 : 0;
    for (int i = last + 1; i < 4; ++i) {
        if (i != left_out && lexicographic_less(tet[last], tet[i])) last = i;
    }
    return last;
}

int orientation_with(std::array<Vec3, 4> tet, int replaced, Vec3 point, double grain) {
    tet[replaced] = point;
    return orient3d(tet[0], tet[1], tet[2], tet[3], grain);
}

}

bool is_inside_after_tie(const std::array<Vec3, 4>& tet, Vec3 point, double grain) {
    const int first = last_corner(tet, 4);
    if (lexicographic_less(tet[first], point)) return false;  // raising the point itself takes it out
    if (const int sign = orientation_with(tet, first, point, grain)) return sign > 0;
    // The point is coplanar with the other three, hence on their circle, hence on no line through two of them.
    const int second = last_corner(tet, first);
    if (lexicographic_less(tet[second], point)) return false;
    const int sign = orientation_with(tet, second, point, grain);
    assert(sign != 0);
    return sign > 0;
}

}
