// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/insertion.h"

#include <algorithm>

#include "finish/hole.h"
#include "geometry/measures.h"

namespace crumple::finish {

namespace {

// Larger holes hardly ever pay and cost more to smooth.
constexpr std::size_t largest_edge_hole = 16;
constexpr std::size_t largest_hole = 40;
constexpr std::size_t largest_star = 60;
constexpr std::size_t largest_ring = 20;

// A hole is good enough to start from when the node sees all of it; moving the node must do the rest.
constexpr double seen = 1e-3;

// Hole and place fitted to each other so often.
constexpr int fitting_rounds = 2;

// In a hole that stays as it is the place goes on so often.
constexpr int settling_rounds = 3;

// So deep below an edge of the surface is the first place of a node, in lengths of the edge: where both ends see it
// under a right angle.
constexpr double depth_below_edge = 0.5;

// Keeps what is better than all before.
class Search {
public:
    Search(const WorkMesh& mesh, double bad, double price, Insertion& best)
        : mesh_(mesh), bad_(bad), price_(price), best_(best) {}

    // `least`: what the faces of the hole must be better than from the first place.
    void try_hole(Vec3 place, std::span<const Index> tets, std::size_t most, double least) {
        Hole hole(mesh_, place, tets);
        if (!hole.open(least, most)) return;
        for (int round = 0; round < fitting_rounds; ++round) {
            hole.grow(bad_, most);
            const double most_gain = hole.old_badness(bad_);
            hole.settle();
            if (!(most_gain > price_)) continue;
            hole.settle_badness(bad_);
            keep(hole, most_gain - hole.new_badness(bad_));
        }
    }

    [[nodiscard]] bool is_found() const { return is_found_; }

private:
    void keep(const Hole& hole, double gain) {
        if (!(gain > price_) || !(hole.least() >= least_shape(mesh_, hole.tets())) || !hole.is_sound(true)) return;
        hole.write(best_.exchange);
        best_.place = hole.place();
        best_.gain = price_ = gain;
        is_found_ = true;
    }

    const WorkMesh& mesh_;
    double bad_;
    double price_;
    Insertion& best_;
    bool is_found_ = false;
};

// The centre of the inscribed sphere: in a long tet near its short end, where a node helps.
Vec3 incentre(const Vec3 (&at)[4]) {
    Vec3 sum{};
    double areas = 0;
    for (int i = 0; i < 4; ++i) {
        const auto& face = tet_face_corners[i];
        const double area = length(area_vector(at[face[0]], at[face[1]], at[face[2]]));
        sum += at[i] * area;
        areas += area;
    }
    return areas > 0 ? sum / areas : at[0];
}

// Below an edge of the surface, towards the nodes around it.
Vec3 below_edge(const WorkMesh& mesh, const TetRing& ring, Index a, Index b) {
    const Vec3 middle = (mesh.at(a) + mesh.at(b)) * 0.5;
    Vec3 inwards{};
    for (const Index v : ring.link) {
        const Vec3 towards = mesh.at(v) - middle;
        const double size = length(towards);
        if (size > 0) inwards += towards / size;
    }
    const double size = length(inwards);
    return size > 0 ? middle + inwards * (depth_below_edge * length(mesh.at(b) - mesh.at(a)) / size) : middle;
}

}

bool plan_insertion_on_edge(const WorkMesh& mesh, const TetRing& ring, Index a, Index b, double floor,
                            Insertion& insertion) {
    if (!ring.is_closed || ring.tets.size() > largest_edge_hole || !is_of_one_region(mesh, ring.tets)) return false;
    Hole hole(mesh, (mesh.at(a) + mesh.at(b)) * 0.5, ring.tets);
    if (!hole.open(0.3 * floor, largest_edge_hole)) return false;
    for (int round = 0; round < settling_rounds; ++round) hole.settle();
    if (!(hole.least() > floor) || !hole.is_sound(false)) return false;
    hole.write(insertion.exchange);
    insertion.place = hole.place();
    return true;
}

bool plan_new_node(const WorkMesh& mesh, Index tet, double bad, double price, Insertion& insertion) {
    const Tet corners = mesh.complex.corners(tet);
    const Vec3 at[4] = {mesh.at(corners[0]), mesh.at(corners[1]), mesh.at(corners[2]), mesh.at(corners[3])};
    Search search(mesh, bad, price, insertion);
    search.try_hole((at[0] + at[1] + at[2] + at[3]) * 0.25, std::span(&tet, 1), largest_hole, seen);
    search.try_hole(incentre(at), std::span(&tet, 1), largest_hole, seen);
    TetRing ring;
    for (const auto& edge : tet_edge_corners) {
        const Index a = corners[edge[0]];
        const Index b = corners[edge[1]];
        mesh.complex.ring_of(tet, a, b, ring);
        if (ring.tets.size() > largest_ring || !is_of_one_region(mesh, ring.tets)) continue;
        const Vec3 middle = (mesh.at(a) + mesh.at(b)) * 0.5;
        search.try_hole(ring.is_closed ? middle : below_edge(mesh, ring, a, b), ring.tets, largest_hole, seen);
    }
    return search.is_found();
}

bool plan_reseat(const WorkMesh& mesh, Index node, std::span<const Index> star, double bad, double price,
                 Insertion& insertion) {
    if (star.size() > largest_star) return false;
    Search search(mesh, bad, price, insertion);
    search.try_hole(mesh.at(node), star, star.size() + largest_hole / 2, 0);
    return search.is_found();
}

}
