// SPDX-License-Identifier: GPL-3.0-or-later
// Finds, among some tets of a mesh, the one that contains a point, else the nearest.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/bvh.h"
#include "mesh/tet_mesh.h"

namespace crumple::bind {

struct Location {
    Index tet = none;  // of the mesh
    bool inside = false;
    std::array<double, 4> weights{};
    double distance = 0;  // metres to that tet
};

// What the previous point of a thread found: a good place to look first, never part of the answer.
struct Guess {
    Index tet = none;
    Index face = none;
};

struct Preferences {
    std::span<const Index> region_rank;  // C: of tets that share a point the one whose region ranks least wins
    std::function<Index(Vec3)> owner;    // the region that owns a point outside all tets, none if there is no such
    double max_weight = 1.5;             // beyond it `slack` metres farther counts as nearest too
    double slack = 0;
};

class TetLocator {
public:
    // region: only tets of this region, or all where it is none. Keeps a copy of what it needs.
    TetLocator(const TetMesh& mesh, Index region, Preferences preferences);

    [[nodiscard]] bool empty() const { return tets_.empty(); }

    // A function of places alone. REQUIRES: not empty, p finite.
    [[nodiscard]] Location locate(Vec3 p, Guess& guess) const;

private:
    struct LocalTet {
        std::array<Vec3, 4> corners;
        Tet nodes{};
        std::array<Index, 4> neighbours{none, none, none, none};  // of tets_, across the face opposite a corner
        Index mesh_tet = none;
        Index region = none;
        std::array<std::uint8_t, 4> corner_of_mesh{};  // which of `corners` the mesh's corner i is
    };
    struct Face {
        std::array<Vec3, 3> corners;
        std::array<Index, 3> nodes{};
        Index tet = none;  // of tets_
    };
    struct Candidate {
        Index tet = none;  // of tets_
        std::array<double, 4> weights{};
        double largest = 0;  // |weight|
    };

    [[nodiscard]] static Location located(const LocalTet& tet, bool inside, const std::array<double, 4>& weights,
                                          double distance);

    void collect_tets(const TetMesh& mesh, Index region);
    void link_neighbours(const TetMesh& mesh);
    void collect_faces();
    void collect_surroundings(std::size_t node_count);

    [[nodiscard]] Index walk(Vec3 p, Index from) const;
    [[nodiscard]] bool contains(Vec3 p, Guess& guess, Location& location) const;
    [[nodiscard]] Location nearest(Vec3 p, Guess& guess) const;
    [[nodiscard]] std::vector<Candidate> tets_at(const Face& face, unsigned corners, Vec3 p) const;
    [[nodiscard]] Candidate best_of(const std::vector<Candidate>& candidates, Vec3 p) const;
    [[nodiscard]] Candidate look_behind(Vec3 p, double distance, const Candidate& found) const;
    [[nodiscard]] Candidate candidate(Index tet, Vec3 p) const;
    [[nodiscard]] double distance_to(const LocalTet& tet, Vec3 p) const;
    [[nodiscard]] Index rank(Index tet) const;

    Preferences preferences_;
    std::vector<LocalTet> tets_;  // in an order that their places alone decide
    Bvh tet_tree_;
    std::vector<Face> faces_;  // the surface of tets_, ordered the same way
    Bvh face_tree_;
    std::vector<Index> around_start_;  // V + 1: the tets around a node,
    std::vector<Index> around_;        // of tets_
};

}
