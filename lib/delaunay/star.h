// SPDX-License-Identifier: GPL-3.0-or-later
// Joins the facets of a star to each other: each has one outer triangle, and two triangles that run through the same
// edge in opposite directions belong to neighbours.
#pragma once
#include <cstdint>
#include <vector>

#include "core/index.h"

namespace crumple::delaunay {

class EdgeTable {
public:
    // For a star of vertex_count vertices and at most edge_count directed edges; forgets earlier ones.
    void start(std::uint32_t vertex_count, std::size_t edge_count);
    void put(std::uint32_t from, std::uint32_t to, std::uint32_t value) { cells_[cell(from, to)] = value; }
    // REQUIRES: put before.
    [[nodiscard]] std::uint32_t get(std::uint32_t from, std::uint32_t to) const { return cells_[cell(from, to)]; }

private:
    // Every edge read was written in the same star, so a direct table needs no clearing. 64 vertices are 16 KB, which
    // stay in the nearest cache; a larger star, rare, hashes its edges.
    static constexpr std::uint32_t direct_vertices = 64;

    [[nodiscard]] std::size_t cell(std::uint32_t from, std::uint32_t to) const {
        return is_direct_ ? from * direct_vertices + to : hashed_cell(from, to);
    }
    [[nodiscard]] std::size_t hashed_cell(std::uint32_t from, std::uint32_t to) const;

    bool is_direct_ = true;
    std::size_t mask_ = 0;
    std::vector<std::uint32_t> cells_ = std::vector<std::uint32_t>(direct_vertices * direct_vertices);
    mutable std::vector<std::uint64_t> keys_;
};

}
