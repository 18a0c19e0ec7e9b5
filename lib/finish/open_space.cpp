// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/open_space.h"

#include <algorithm>
#include <iterator>

#include "geometry/measures.h"
#include "geometry/predicates.h"

namespace crumple::finish {

namespace {

int side_of(std::span<const Vec3> at, Index a, Index b, Index c, Index p) {
    return p == a || p == b || p == c ? 0 : orient3d(at[a], at[b], at[c], at[p]);
}

// The tet's own side of its faces is the negative one.
bool is_beyond_a_face(std::span<const Vec3> at, std::span<const Index> corners, const Tet& tet) {
    return std::any_of(std::begin(tet_face_corners), std::end(tet_face_corners), [&](const auto& face) {
        return std::all_of(corners.begin(), corners.end(),
                           [&](Index v) { return side_of(at, tet[face[0]], tet[face[1]], tet[face[2]], v) >= 0; });
    });
}

bool has_tet_on_one_side(std::span<const Vec3> at, const Triangle& face, const Tet& tet) {
    int lowest = 0;
    int highest = 0;
    for (const Index v : tet) {
        lowest = std::min(lowest, side_of(at, face[0], face[1], face[2], v));
        highest = std::max(highest, side_of(at, face[0], face[1], face[2], v));
    }
    return (lowest == 0) != (highest == 0);
}

// Whether the plane through an edge of the tet and a corner of the face has the two on different sides.
bool edge_plane_separates(std::span<const Vec3> at, const Triangle& face, const Tet& tet, int edge, int k) {
    const Index a = tet[tet_edge_corners[edge][0]];
    const Index b = tet[tet_edge_corners[edge][1]];
    const Index c = face[k];
    // Edge 5 - i joins the two other corners.
    const int first = side_of(at, a, b, c, tet[tet_edge_corners[5 - edge][0]]);
    const int second = side_of(at, a, b, c, tet[tet_edge_corners[5 - edge][1]]);
    if (c == a || c == b || first * second < 0 || (first == 0 && second == 0)) return false;
    const int side = first != 0 ? first : second;
    return side_of(at, a, b, c, face[(k + 1) % 3]) * side <= 0 && side_of(at, a, b, c, face[(k + 2) % 3]) * side <= 0;
}

// Two convex bodies are apart when some plane parts them. Of all that could, those through an edge of the face and a
// corner of the tet are not tried: they decide few pairs.
bool is_apart(std::span<const Vec3> at, const Triangle& face, const Tet& tet) {
    if (is_beyond_a_face(at, face, tet) || has_tet_on_one_side(at, face, tet)) return true;
    for (int edge = 0; edge < 6; ++edge) {
        for (int k = 0; k < 3; ++k) {
            if (edge_plane_separates(at, face, tet, edge, k)) return true;
        }
    }
    return false;
}

}

OpenSpace::OpenSpace(std::span<const Vec3> positions, std::span<const Triangle> faces)
    : faces_(faces), tree_(tree_of(positions, faces)) {}

bool OpenSpace::has_room_for(std::span<const Vec3> positions, const Tet& tet, std::span<const Tet> others) const {
    if (orient3d(positions[tet[0]], positions[tet[1]], positions[tet[2]], positions[tet[3]]) <= 0) return false;
    Box box;
    for (const Index v : tet) box.add(positions[v]);
    bool is_open = true;
    tree_.touching(box, [&](Index f) {
        is_open = is_apart(positions, faces_[f], tet);
        return !is_open;
    });
    return is_open && std::all_of(others.begin(), others.end(), [&](const Tet& other) {
               return is_beyond_a_face(positions, other, tet) || is_beyond_a_face(positions, tet, other);
           });
}

}
