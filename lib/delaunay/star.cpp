// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/star.h"

#include <bit>

namespace crumple::delaunay {
namespace {

constexpr std::uint64_t no_key = ~std::uint64_t{0};

}

void EdgeTable::start(std::uint32_t vertex_count, std::size_t edge_count) {
    is_direct_ = vertex_count <= direct_vertices;
    if (is_direct_) return;
    const std::size_t size = std::bit_ceil(2 * edge_count);
    mask_ = size - 1;
    keys_.assign(size, no_key);
    if (cells_.size() < size) cells_.resize(size);
}

// Open addressing; the first look at an edge claims its cell.
std::size_t EdgeTable::hashed_cell(std::uint32_t from, std::uint32_t to) const {
    const std::uint64_t key = std::uint64_t{from} << 32 | to;
    std::size_t at = (key * 0x9e3779b97f4a7c15u >> 20) & mask_;
    while (keys_[at] != no_key && keys_[at] != key) at = (at + 1) & mask_;
    keys_[at] = key;
    return at;
}

}
