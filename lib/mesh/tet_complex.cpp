// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tet_complex.h"

#include <algorithm>

#include "core/error.h"

namespace crumple {

TetComplex::TetComplex(const TetMesh& mesh)
    : positions_(mesh.positions),
      tet_at_(mesh.positions.size(), none),
      tets_(mesh.tets.size()),
      tet_count_(static_cast<Index>(mesh.tets.size())),
      shell_vertex_count_(mesh.shell_vertex_count),
      has_regions_(!mesh.region.empty()),
      stamp_(mesh.tets.size(), 0) {
    CRUMPLE_CHECK(mesh.neighbours.size() == mesh.tets.size(), "a mesh under change knows its neighbours");
    for (Index t = 0; t < tet_count_; ++t) {
        tets_[t] = {mesh.tets[t], mesh.neighbours[t], has_regions_ ? mesh.region[t] : none};
        for (const Index v : mesh.tets[t]) tet_at_[v] = t;
    }
}

Index TetComplex::add_node(Vec3 position) {
    positions_.push_back(position);
    tet_at_.push_back(none);
    return static_cast<Index>(positions_.size() - 1);
}

int TetComplex::corner_of(Index tet, Index node) const {
    const Tet& corners = tets_[tet].corners;
    for (int i = 0; i < 4; ++i) {
        if (corners[i] == node) return i;
    }
    return -1;
}

int TetComplex::face_towards(Index tet, Index neighbour) const {
    for (int i = 0; i < 4; ++i) {
        if (tets_[tet].neighbours[i] == neighbour) return i;
    }
    return -1;
}

std::uint32_t TetComplex::next_stamp() const {
    if (stamp_now_ == 0xffffffffu) {
        std::fill(stamp_.begin(), stamp_.end(), 0);
        stamp_now_ = 0;
    }
    return ++stamp_now_;
}

void TetComplex::star_of(Index node, std::vector<Index>& tets) const {
    tets.clear();
    if (tet_at_[node] == none) return;
    const std::uint32_t seen = next_stamp();
    tets.push_back(tet_at_[node]);
    stamp_[tet_at_[node]] = seen;
    for (std::size_t i = 0; i < tets.size(); ++i) {
        const Slot& slot = tets_[tets[i]];
        for (int corner = 0; corner < 4; ++corner) {
            const Index next = slot.neighbours[corner];
            if (slot.corners[corner] == node || next == none || stamp_[next] == seen) continue;
            stamp_[next] = seen;
            tets.push_back(next);
        }
    }
}

Index TetComplex::find_edge(Index a, Index b) const {
    std::vector<Index> star;
    star_of(a, star);
    for (const Index t : star) {
        if (corner_of(t, b) >= 0) return t;
    }
    return none;
}

Index TetComplex::find_face(Index a, Index b, Index c) const {
    std::vector<Index> star;
    star_of(a, star);
    for (const Index t : star) {
        if (corner_of(t, b) >= 0 && corner_of(t, c) >= 0) return t;
    }
    return none;
}

namespace {

// The other two corners y, z of a positive tet, so that (a, b, y, z) is positive.
std::array<Index, 2> across_edge(const Tet& tet, Index a, Index b) {
    // (i, j) and then the corners that complete an even permutation.
    static constexpr int completion[4][4][2] = {{{0, 0}, {2, 3}, {3, 1}, {1, 2}},
                                                {{3, 2}, {0, 0}, {0, 3}, {2, 0}},
                                                {{1, 3}, {3, 0}, {0, 0}, {0, 1}},
                                                {{2, 1}, {0, 2}, {1, 0}, {0, 0}}};
    int i = 0;
    int j = 0;
    for (int k = 0; k < 4; ++k) {
        if (tet[k] == a) i = k;
        if (tet[k] == b) j = k;
    }
    const auto& rest = completion[i][j];
    return {tet[rest[0]], tet[rest[1]]};
}

}

void TetComplex::ring_of(Index tet, Index a, Index b, TetRing& ring) const {
    ring.tets.clear();
    ring.link.clear();
    ring.is_closed = false;
    // Back to the surface, or once around.
    Index first = tet;
    for (Index t = tet;;) {
        const Index back = tets_[t].neighbours[corner_of(t, across_edge(tets_[t].corners, a, b)[1])];
        if (back == none) {
            first = t;
            break;
        }
        if (back == tet) {
            ring.is_closed = true;
            break;
        }
        t = back;
    }
    for (Index t = first;;) {
        const auto [y, z] = across_edge(tets_[t].corners, a, b);
        ring.tets.push_back(t);
        ring.link.push_back(y);
        const Index next = tets_[t].neighbours[corner_of(t, y)];
        if (next == none) ring.link.push_back(z);
        if (next == none || next == first) return;
        t = next;
    }
}

TetComplex::Side TetComplex::side(Index tet, int face) const {
    const Tet& corners = tets_[tet].corners;
    const auto& corner = tet_face_corners[face];
    Triangle sorted{corners[corner[0]], corners[corner[1]], corners[corner[2]]};
    std::sort(sorted.begin(), sorted.end());
    return {sorted, tet, static_cast<std::uint8_t>(face)};
}

void TetComplex::take_out(std::span<const Index> old) {
    const std::uint32_t going = next_stamp();
    for (const Index t : old) stamp_[t] = going;
    for (const Index t : old) {
        for (int face = 0; face < 4; ++face) {
            touched_nodes_.push_back(tets_[t].corners[face]);
            const Index outer = tets_[t].neighbours[face];
            touched_surface_ |= outer == none;
            if (outer == none || stamp_[outer] == going) continue;
            const int outer_face = face_towards(outer, t);
            sides_.push_back(side(outer, outer_face));
            tets_[outer].neighbours[outer_face] = none;
        }
    }
    for (const Index v : touched_nodes_) tet_at_[v] = none;
    for (const Side& outer : sides_) {
        for (const Index v : outer.corners) tet_at_[v] = outer.tet;
    }
    for (std::size_t i = old.size(); i-- > 0;) {
        tets_[old[i]] = {};
        free_.push_back(old[i]);
    }
    tet_count_ -= static_cast<Index>(old.size());
}

void TetComplex::put_in(std::span<const Tet> fresh, Index region) {
    for (const Tet& tet : fresh) {
        if (free_.empty()) {
            free_.push_back(slot_count());
            tets_.emplace_back();
            stamp_.push_back(0);
        }
        const Index t = free_.back();
        free_.pop_back();
        tets_[t] = {tet, {none, none, none, none}, region};
        fresh_.push_back(t);
        for (int face = 0; face < 4; ++face) {
            tet_at_[tet[face]] = t;
            sides_.push_back(side(t, face));
        }
    }
    tet_count_ += static_cast<Index>(fresh.size());
}

void TetComplex::link_sides() {
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
        return a.corners != b.corners ? a.corners < b.corners : a.tet < b.tet;
    });
    for (std::size_t i = 1; i < sides_.size(); ++i) {
        const Side& a = sides_[i - 1];
        const Side& b = sides_[i];
        if (a.corners != b.corners) continue;
        CRUMPLE_CHECK(i < 2 || sides_[i - 2].corners != a.corners, "at most two tets share a face");
        tets_[a.tet].neighbours[a.face] = b.tet;
        tets_[b.tet].neighbours[b.face] = a.tet;
    }
}

// A node of a pinched surface may have tets left that share no face with those that went.
void TetComplex::find_lost_nodes() {
    if (!touched_surface_) return;
    for (const Index v : touched_nodes_) {
        if (tet_at_[v] != none) continue;
        for (Index t = 0; t < slot_count() && tet_at_[v] == none; ++t) {
            if (is_tet(t) && corner_of(t, v) >= 0) tet_at_[v] = t;
        }
    }
}

std::span<const Index> TetComplex::replace(std::span<const Index> old, std::span<const Tet> fresh, Index region) {
    sides_.clear();
    fresh_.clear();
    touched_nodes_.clear();
    touched_surface_ = false;
    take_out(old);
    put_in(fresh, region);
    link_sides();
    find_lost_nodes();
    return fresh_;
}

TetMesh TetComplex::to_mesh() const {
    TetMesh mesh;
    mesh.positions = positions_;
    mesh.shell_vertex_count = shell_vertex_count_;
    mesh.tets.reserve(tet_count_);
    std::vector<Index> number(tets_.size(), none);
    for (Index t = 0; t < slot_count(); ++t) {
        if (!is_tet(t)) continue;
        number[t] = static_cast<Index>(mesh.tets.size());
        mesh.tets.push_back(tets_[t].corners);
        if (has_regions_) mesh.region.push_back(tets_[t].region);
    }
    mesh.neighbours.reserve(tet_count_);
    for (Index t = 0; t < slot_count(); ++t) {
        if (!is_tet(t)) continue;
        std::array<Index, 4> across = tets_[t].neighbours;
        for (Index& n : across) n = n == none ? none : number[n];
        mesh.neighbours.push_back(across);
    }
    return mesh;
}

}
