// SPDX-License-Identifier: GPL-3.0-or-later
// A tet mesh under change: tets are exchanged a handful at a time and keep knowing their neighbours. What may be
// exchanged for what is the caller's affair: this class never looks at a position. One thread at a time, reading
// included.
//
// A tet lives in a slot; the slot of a tet that went is used again, last freed first, so that the same exchanges always
// give the same numbers. Spans and references are good until the next call that is not const.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"
#include "mesh/tet_mesh.h"

namespace crumple {

// The tets around an edge (a, b) in order: tet i has the corners a, b, link[i], link[i + 1], positive as written.
struct TetRing {
    std::vector<Index> tets;  // n
    std::vector<Index> link;  // n nodes, the last followed by the first, when closed; n + 1 when the surface cuts it
    bool is_closed = false;
};

class TetComplex {
public:
    // REQUIRES: mesh.neighbours is filled. Regions are taken along when there are any.
    explicit TetComplex(const TetMesh& mesh);

    // --- nodes: added, moved, never renumbered
    [[nodiscard]] const std::vector<Vec3>& positions() const { return positions_; }
    [[nodiscard]] Vec3 position(Index node) const { return positions_[node]; }
    [[nodiscard]] Index tet_at(Index node) const { return tet_at_[node]; }  // some tet, none when no tet uses the node
    Index add_node(Vec3 position);                                          // in no tet yet
    void move_node(Index node, Vec3 position) { positions_[node] = position; }

    // --- tets
    [[nodiscard]] Index slot_count() const { return static_cast<Index>(tets_.size()); }
    [[nodiscard]] Index tet_count() const { return tet_count_; }
    [[nodiscard]] bool is_tet(Index slot) const { return tets_[slot].corners[0] != none; }
    [[nodiscard]] const Tet& corners(Index tet) const { return tets_[tet].corners; }
    [[nodiscard]] Index neighbour(Index tet, int corner) const { return tets_[tet].neighbours[corner]; }
    [[nodiscard]] Index region(Index tet) const { return tets_[tet].region; }  // none when there are no regions

    // Corner number 0..3 of a node, or of the face shared with a neighbour; -1 when there is none.
    [[nodiscard]] int corner_of(Index tet, Index node) const;
    [[nodiscard]] int face_towards(Index tet, Index neighbour) const;

    // --- around
    // Tets at a node that are connected across faces to tet_at(node): all of them where the mesh is a manifold.
    void star_of(Index node, std::vector<Index>& tets) const;
    // A tet with both nodes, all three, or none. Looks through the star of the first.
    [[nodiscard]] Index find_edge(Index a, Index b) const;
    [[nodiscard]] Index find_face(Index a, Index b, Index c) const;
    // The ring of an edge of `tet`. An open one runs from surface to surface.
    void ring_of(Index tet, Index a, Index b, TetRing& ring) const;

    // --- change
    // Takes the tets `old` away and puts `fresh` there, all with this region; tells the slots of the fresh ones in
    // their order. Faces that find no partner become surface. REQUIRES: `old` distinct; no face ends up at three tets.
    std::span<const Index> replace(std::span<const Index> old, std::span<const Tet> fresh, Index region = none);

    // --- out
    // Tets by slot; every node, whether used or not. shell_vertex_count is the one given at the start.
    [[nodiscard]] TetMesh to_mesh() const;

private:
    struct Slot {
        Tet corners{none, none, none, none};
        std::array<Index, 4> neighbours{none, none, none, none};
        Index region = none;
    };
    struct Side {
        Triangle corners;  // sorted
        Index tet;         // none: the surface
        std::uint8_t face;
    };

    void take_out(std::span<const Index> old);
    void put_in(std::span<const Tet> fresh, Index region);
    void link_sides();
    void find_lost_nodes();
    [[nodiscard]] Side side(Index tet, int face) const;
    [[nodiscard]] std::uint32_t next_stamp() const;

    std::vector<Vec3> positions_;
    std::vector<Index> tet_at_;
    std::vector<Slot> tets_;
    std::vector<Index> free_;
    Index tet_count_ = 0;
    Index shell_vertex_count_ = 0;
    bool has_regions_ = false;

    // Working memory.
    mutable std::vector<std::uint32_t> stamp_;  // by slot
    mutable std::uint32_t stamp_now_ = 0;
    std::vector<Side> sides_;
    std::vector<Index> fresh_;
    std::vector<Index> touched_nodes_;
    bool touched_surface_ = false;
};

}
