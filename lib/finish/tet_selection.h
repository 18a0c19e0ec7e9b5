// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh from which tets are taken away and to which tets and nodes are added, and where its surface is a manifold.
// Unlike TetComplex it knows every tet at a node, however the surface is pinched there; and it can go back.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/index.h"
#include "mesh/tet_mesh.h"

namespace crumple::finish {

// Any of the three; empty ones do nothing.
struct SurfaceChange {
    std::vector<Index> gone;   // tets taken away
    std::vector<Tet> added;    // of nodes of the mesh and, numbered on from those, of `places`
    std::vector<Index> like;   // for each added tet, one of the mesh whose region it takes
    std::vector<Vec3> places;  // of new nodes, float-representable
    Index split_node = none;   // whose tets in split_tets get a node of their own at the same place
    std::vector<Index> split_tets;
    double cost = 0;  // cubic metres

    [[nodiscard]] bool is_empty() const { return gone.empty() && added.empty() && split_node == none; }
};

class TetSelection {
public:
    // REQUIRES: neighbours filled.
    explicit TetSelection(TetMesh mesh);

    [[nodiscard]] const TetMesh& mesh() const { return mesh_; }  // with the tets that went; neighbours as they were
    [[nodiscard]] Index first_added() const { return first_added_; }
    [[nodiscard]] bool is_there(Index tet) const { return is_there_[tet]; }
    [[nodiscard]] bool has(Index tet, Index node) const;
    [[nodiscard]] std::vector<Index> tets_at(Index node) const;
    [[nodiscard]] Index neighbour(Index tet, int corner) const;  // that is there
    [[nodiscard]] double volume(Index tet) const;

    // The exposed faces at a node as the edges opposite it, ascending: one closed cycle on a manifold.
    [[nodiscard]] std::vector<Edge> link_of(Index node) const;
    [[nodiscard]] bool is_manifold(Index node) const;

    // The other ends of edges at a node along which more than two faces of the surface meet, ascending.
    [[nodiscard]] std::vector<Index> bad_ends_at(Index node) const;

    // The tets at `node`, with `along` too unless it is none, in parts connected across faces that have both.
    [[nodiscard]] std::vector<std::vector<Index>> parts_at(Index node, Index along) const;

    // The nodes whose surface a change alters, those of its new places too; after it, a split node's new one is the
    // last of the mesh.
    [[nodiscard]] std::vector<Index> nodes_of(const SurfaceChange& change) const;

    void put(const SurfaceChange& change);
    void take_back(const SurfaceChange& change);  // the last one put

    // What is there: tets in their order, the added ones last, neighbours filled.
    [[nodiscard]] TetMesh take() &&;

private:
    void split(Index node, const std::vector<Index>& tets);
    void join(Index node, const std::vector<Index>& tets);

    TetMesh mesh_;
    Index first_added_;
    std::vector<std::vector<Index>> tets_at_;  // gone ones included
    std::vector<std::uint8_t> is_there_;
};

}
