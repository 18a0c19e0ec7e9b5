// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for every result, whatever the points.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "delaunay/delaunay.h"
#include "geometry/predicates.h"

namespace crumple::checks {

inline delaunay::Result tetrahedralize(const std::vector<Vec3>& points,
                                       delaunay::Order order = delaunay::Order::automatic) {
    PointSet set;
    set.positions = points;
    return delaunay::tetrahedralize(set, {order});
}

inline std::vector<Tet> sorted_tets(const TetMesh& mesh) {
    std::vector<Tet> tets = mesh.tets;
    for (Tet& tet : tets) std::sort(tet.begin(), tet.end());
    std::sort(tets.begin(), tets.end());
    return tets;
}

inline void expect_positive_tets(const TetMesh& mesh) {
    std::size_t bad = 0;
    for (const Tet& t : mesh.tets) {
        const auto& p = mesh.positions;
        bad += orient3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) <= 0;
    }
    EXPECT_EQ(bad, 0u) << "tets that are not positive";
}

// Each neighbour shares the face, runs through it the other way, and points back; no point inside either's sphere.
inline void expect_delaunay_neighbours(const TetMesh& mesh) {
    ASSERT_EQ(mesh.neighbours.size(), mesh.tets.size());
    std::size_t broken = 0, not_delaunay = 0;
    const auto& p = mesh.positions;
    for (Index tet = 0; tet < mesh.tets.size(); ++tet) {
        const Tet& t = mesh.tets[tet];
        for (int corner = 0; corner < 4; ++corner) {
            const Index other = mesh.neighbours[tet][corner];
            if (other == none) continue;
            const auto& back = mesh.neighbours[other];
            const auto place = std::find(back.begin(), back.end(), tet);
            if (place == back.end()) {
                ++broken;
                continue;
            }
            const Index apex = mesh.tets[other][place - back.begin()];
            Tet with_apex = t;
            with_apex[corner] = apex;
            Tet expected = mesh.tets[other];
            std::sort(with_apex.begin(), with_apex.end());
            std::sort(expected.begin(), expected.end());
            broken += with_apex != expected;
            not_delaunay += in_sphere(p[t[0]], p[t[1]], p[t[2]], p[t[3]], p[apex]) > 0;
        }
    }
    EXPECT_EQ(broken, 0u) << "neighbours that do not match";
    EXPECT_EQ(not_delaunay, 0u) << "faces that are not Delaunay";
}

// A boundary face has every point on its inner side: the tets fill the convex hull of all points.
inline void expect_convex_boundary(const TetMesh& mesh) {
    std::size_t beyond = 0;
    for (Index tet = 0; tet < mesh.tets.size(); ++tet) {
        for (int corner = 0; corner < 4; ++corner) {
            if (mesh.neighbours[tet][corner] != none) continue;
            const int* face = tet_face_corners[corner];
            const auto& p = mesh.positions;
            const Tet& t = mesh.tets[tet];
            for (const Vec3& point : p) beyond += orient3d(p[t[face[0]]], p[t[face[1]]], p[t[face[2]]], point) > 0;
        }
    }
    EXPECT_EQ(beyond, 0u) << "points beyond boundary faces";
}

inline void expect_same_mesh(const TetMesh& a, const TetMesh& b) {
    EXPECT_TRUE(a.tets == b.tets) << "tets differ";
    EXPECT_TRUE(a.neighbours == b.neighbours) << "neighbours differ";
}

inline constexpr delaunay::Order every_order[] = {delaunay::Order::quickhull, delaunay::Order::sampled,
                                                  delaunay::Order::brio, delaunay::Order::automatic};

}
