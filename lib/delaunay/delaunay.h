// SPDX-License-Identifier: GPL-3.0-or-later
// Exact Delaunay tetrahedralization: the lower convex hull of the points lifted to (p, |p|^2) in 4D, by quickhull
// [Barber, Dobkin, Huhdanpaa 1996] with a vertex at infinity. Cospherical ties break by coordinates, never by index, so
// the result is one and the same for any order of the points and equals CGAL's Delaunay_triangulation_3.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/point_set.h"
#include "mesh/tet_mesh.h"

namespace crumple::delaunay {

inline constexpr int version = 1;

// In which order points enter the hull. The tets are the same for each; only time and memory differ.
enum class Order {
    automatic,  // the fastest at this size
    quickhull,  // outside sets, farthest point first
    sampled,    // a random eighth by walking, the rest by outside sets
    brio,       // biased randomized insertion order [Amenta, Choi, Rote 2003], found by walking
};

inline constexpr EnumName<Order> order_names[] = {
    {Order::automatic, "auto"}, {Order::quickhull, "quickhull"}, {Order::sampled, "sampled"}, {Order::brio, "brio"}};
constexpr std::span<const EnumName<Order>> enum_names(Order) { return order_names; }

struct Params {
    Order order = Order::automatic;
};

template <class Visitor, FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    visit.field("order", p.order, "in which order points enter the hull: same tets, other speed");
}

struct Report {
    std::uint32_t points = 0;      // given
    std::uint32_t duplicates = 0;  // of them at the place of an earlier point, and so in no tet
    std::int32_t dimension = -1;   // of the points: 3 a solid, 2 a plane, 1 a line, 0 one place, -1 no points
    std::uint32_t tets = 0;
    std::uint32_t hull_faces = 0;
    std::uint64_t uncertain_tests = 0;    // in-sphere tests the floating-point planes left open
    std::uint64_t cospherical_tests = 0;  // of them exact ties, decided by coordinates
    Order order = Order::automatic;       // the one taken
    std::vector<Finding> findings;
};

template <class Visitor, FieldsOf<Report> R>
void describe(Visitor& visit, R& r) {
    visit.field("points", r.points, "points given");
    visit.field("duplicates", r.duplicates, "points at the place of an earlier point; no tet uses them");
    visit.field("dimension", r.dimension, "3 a solid, 2 a plane, 1 a line, 0 one place, -1 no points");
    visit.field("tets", r.tets, "tetrahedra of the convex hull");
    visit.field("hull_faces", r.hull_faces, "triangles on the convex hull");
    visit.field("uncertain_tests", r.uncertain_tests, "in-sphere tests that needed more than the first filter");
    visit.field("cospherical_tests", r.cospherical_tests, "in-sphere tests decided by the tie rule");
    visit.field("order", r.order, "the insertion order taken");
    visit.field("findings", r.findings, "what a person should know");
}

struct Result {
    TetMesh mesh;  // the whole convex hull; every node of the points at its index; tets in a canonical order
    // Empty without duplicates; else one entry a point: the first point at the same place (itself for most).
    std::vector<Index> duplicate_of;
    Report report;
};

// Any finite points. The order of tets and of their corners follows from coordinates alone: a point set given in
// another order yields the same tets in the same order, with other names of the nodes. Fewer than four points that span
// space give no tets, their dimension and a finding. 0.0 and -0.0 are one place. Throws Error(bad_input) on NaN or
// infinite coordinates and beyond 2^27 points.
[[nodiscard]] Result tetrahedralize(const PointSet& points, const Params& params = {}, const Context& context = {});

}
