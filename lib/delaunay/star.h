// SPDX-License-Identifier: GPL-3.0-or-later
// The star an insertion builds: its outer triangles, its vertices under small numbers, and how its facets join.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/index.h"
#include "delaunay/facet_plane.h"

namespace crumple::delaunay {

// F facets over V vertices, grown as needed and never shrunk.
struct Star {
    std::size_t facet_count = 0;
    std::vector<Index> facet;   // F: where it lives in the hull
    std::vector<Index> beyond;  // F: across the outer triangle, 4 * facet + corner
    StarPlanes planes;          // F: the outer triangle by local numbers, and the plane

    std::uint32_t vertex_count = 0;
    std::vector<Index> vertex;  // V: site behind a local number
    StarVertices position;      // V: relative to the new site

    // Room for so many facets, and vertices.
    void reserve(std::size_t count);
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, Index beyond_code, bool is_wanted) {
        planes.corner[0][facet_count] = a;
        planes.corner[1][facet_count] = b;
        planes.corner[2][facet_count] = c;
        beyond[facet_count] = beyond_code;
        facet_count += is_wanted;
    }
};

// Which facet of the star runs through a directed edge of local numbers: neighbours do so in opposite directions.
class EdgeTable {
public:
    // For a star of vertex_count vertices and edge_count directed edges; forgets earlier ones.
    void start(std::uint32_t vertex_count, std::size_t edge_count);
    void put(std::uint32_t from, std::uint32_t to, std::uint32_t value) { cells_[cell(from, to)] = value; }
    // REQUIRES: put before.
    [[nodiscard]] std::uint32_t get(std::uint32_t from, std::uint32_t to) { return cells_[cell(from, to)]; }

private:
    // Every edge read was written in the same star, so a direct table needs no clearing. The usual 32 vertices take 4
    // KB of the nearest cache; beyond 512, only in nearly quadratic triangulations, edges are hashed.
    static constexpr std::uint32_t direct_vertices = 512;

    [[nodiscard]] std::size_t cell(std::uint32_t from, std::uint32_t to) {
        return is_direct_ ? (std::size_t{from} << shift_ | to) : hashed_cell(from, to);
    }
    [[nodiscard]] std::size_t hashed_cell(std::uint32_t from, std::uint32_t to);

    bool is_direct_ = true;
    std::uint32_t shift_ = 0;
    std::size_t mask_ = 0;
    std::vector<std::uint32_t> cells_;
    std::vector<std::uint64_t> keys_;
};

}
