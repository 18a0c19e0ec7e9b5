// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/star.h"

#include <algorithm>
#include <bit>

namespace crumple::delaunay {
namespace {

constexpr std::uint64_t no_key = ~std::uint64_t{0};

}

void Star::reserve(std::size_t count) {
    if (count <= facet.size()) return;
    const std::size_t size = std::max(count, 2 * facet.size());
    facet.resize(size);
    beyond.resize(size);
    planes.resize(size);
    vertex.resize(size);
    position.resize(size);
}

void EdgeTable::start(std::uint32_t vertex_count, std::size_t edge_count) {
    is_direct_ = vertex_count <= direct_vertices;
    const std::uint32_t side = std::bit_ceil(std::max(vertex_count, 32u));
    const std::size_t size = is_direct_ ? std::size_t{side} * side : std::bit_ceil(2 * edge_count);
    if (cells_.size() < size) cells_.resize(size);
    shift_ = static_cast<std::uint32_t>(std::countr_zero(side));
    mask_ = size - 1;
    if (!is_direct_) keys_.assign(size, no_key);
}

// Open addressing; the first look at an edge claims its cell.
std::size_t EdgeTable::hashed_cell(std::uint32_t from, std::uint32_t to) {
    const std::uint64_t key = std::uint64_t{from} << 32 | to;
    std::size_t at = (key * 0x9e3779b97f4a7c15u >> 20) & mask_;
    while (keys_[at] != no_key && keys_[at] != key) at = (at + 1) & mask_;
    keys_[at] = key;
    return at;
}

}
