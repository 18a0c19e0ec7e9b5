// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/self_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "core/random.h"
#include "geometry/measures.h"
#include "mesh/shapes.h"
#include "shared_data.h"
#include "shared_data.h"

namespace crumple {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Pairs = std::set<std::pair<Index, Index>>;

Pairs pairs_of(const Shell& shell, const Context& context = {}) {
    Pairs pairs;
    for (const auto& meeting : self_intersections(shell.positions, shell.triangles, context)) {
        pairs.insert({meeting.first, meeting.second});
    }
    return pairs;
}

// CGAL's answer; faces that cannot be added to a halfedge mesh would be lost, so shells here are 2-manifold.
Pairs pairs_by_cgal(const Shell& shell) {
    Mesh mesh;
    std::vector<Mesh::Vertex_index> vertices;
    for (const Vec3& p : shell.positions) vertices.push_back(mesh.add_vertex({p.x, p.y, p.z}));
    for (const auto& [a, b, c] : shell.triangles) mesh.add_face(vertices[a], vertices[b], vertices[c]);
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(found));
    Pairs pairs;
    for (const auto& [a, b] : found) pairs.insert(std::minmax(static_cast<Index>(a), static_cast<Index>(b)));
    return pairs;
}

TEST(SelfIntersection, NothingMeetsInNothing) { EXPECT_TRUE(self_intersections({}, {}).empty()); }

TEST(SelfIntersection, CleanShapesHaveNone) {
    EXPECT_TRUE(pairs_of(shapes::subdivided_box(4)).empty());
    EXPECT_TRUE(pairs_of(shapes::icosphere(1, 3)).empty());
    EXPECT_TRUE(pairs_of(shapes::torus()).empty());
    EXPECT_TRUE(pairs_of(shapes::nested_boxes()).empty());
}

TEST(SelfIntersection, CrossedShapesGiveThePairsOfCgalAtAnyScale) {
    for (const double scale : {1e-20, 1.0, 1e15}) {
        const Shell shell = shapes::moved(shapes::joined(shapes::icosphere(1, 2), shapes::torus(1, 0.3, 24, 12)),
                                          {0.01 * scale, 0, 0}, scale);
        const Pairs pairs = pairs_of(shell);
        EXPECT_GT(pairs.size(), 50u);
        EXPECT_EQ(pairs, pairs_by_cgal(shell));
    }
}

TEST(SelfIntersection, RumpledSpheresGiveThePairsOfCgal) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        Shell shell = shapes::icosphere(1, 2);
        Rng rng(seed);
        for (Vec3& p : shell.positions)
            p = round_to_float(p * (0.2 + 1.6 * rng.next_unit()) + Vec3{0, 0.3, 0} * rng.next_unit());
        EXPECT_EQ(pairs_of(shell), pairs_by_cgal(shell)) << "seed " << seed;
    }
}

TEST(SelfIntersection, FlatAndFoldedShapesOnAGridGiveThePairsOfCgal) {
    // Small integer coordinates: most contacts are coplanar, or an edge or corner touching a side.
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        Shell shell = shapes::icosphere(1, 1);
        Rng rng(seed, 1);
        std::set<std::array<double, 3>> taken;
        for (Vec3& p : shell.positions) {
            do {
                for (int axis = 0; axis < 3; ++axis) p[axis] = rng.next_below(axis == 2 ? 2 + seed % 4 : 6);
            } while (!taken.insert({p.x, p.y, p.z}).second);
        }
        std::erase_if(shell.triangles, [&](const Triangle& t) {  // CGAL reports those without area against themselves
            return cross(shell.positions[t[1]] - shell.positions[t[0]],
                         shell.positions[t[2]] - shell.positions[t[0]]) == Vec3{};
        });
        EXPECT_EQ(pairs_of(shell), pairs_by_cgal(shell)) << "seed " << seed;
    }
}

// Positions and triangles of a plain OBJ file of the shared data; empty when it is not there.
Shell obj_of(const std::string& name) {
    std::ifstream file(test::data_folder() / name);
    Shell shell;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        Vec3 p;
        Triangle t{};
        if (kind == "v" && words >> p.x >> p.y >> p.z) shell.positions.push_back(p);
        if (kind == "f" && words >> t[0] >> t[1] >> t[2]) shell.triangles.push_back({t[0] - 1, t[1] - 1, t[2] - 1});
    }
    return shell;
}

TEST(SelfIntersection, RealShellsGiveThePairsOfCgal) {
    CRUMPLE_NEEDS_DATA();
    for (const auto& [name, crosses] : {std::pair{"cow", true}, {"spot", false}, {"fandisk", false}}) {
        const Shell shell = obj_of(std::string("quality/") + name + ".obj");
        ASSERT_FALSE(shell.triangles.empty()) << name;
        const Pairs pairs = pairs_of(shell);
        EXPECT_EQ(!pairs.empty(), crosses) << name;
        EXPECT_EQ(pairs, pairs_by_cgal(shell)) << name;
    }
}

TEST(SelfIntersection, PlacesLieOnBothTriangles) {
    const Shell shell = shapes::joined(shapes::box(), shapes::box({0.5, 0.5, 0.5}, {2, 2, 2}));
    const auto meetings = self_intersections(shell.positions, shell.triangles);
    ASSERT_FALSE(meetings.empty());
    for (const auto& meeting : meetings) {
        for (const Index t : {meeting.first, meeting.second}) {
            const auto& [a, b, c] = shell.triangles[t];
            const Vec3 nearest =
                closest_point_on_triangle(shell.positions[a], shell.positions[b], shell.positions[c], meeting.place);
            EXPECT_LT(length(nearest - meeting.place), 0.05);
        }
    }
}

TEST(SelfIntersection, DuplicatesAndFlatTrianglesDoNotCountAndCopiesStayBounded) {
    const std::vector<Vec3> positions{{0, 0, 0},        {1, 0, 0},       {0, 1, 0},
                                      {0.25, 0.25, -1}, {0.25, 0.25, 1}, {0.3, 0.3, 1}};
    EXPECT_TRUE(self_intersections(positions, std::vector<Triangle>{{0, 1, 2}, {2, 1, 0}, {3, 4, 4}}).empty());
    std::vector<Triangle> copies(300, Triangle{0, 1, 2});
    copies.insert(copies.end(), 300, Triangle{3, 4, 5});
    EXPECT_EQ(self_intersections(positions, copies, {}, 5).size(), 1500u);
}

TEST(SelfIntersection, ThreadsDoNotChangeIt) {
    const Shell shell = shapes::joined(shapes::icosphere(1, 3), shapes::torus(1, 0.3, 24, 12));
    Context four;
    four.jobs = 4;
    EXPECT_EQ(pairs_of(shell), pairs_of(shell, four));
}

}
}
