// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/hilbert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace crumple::delaunay {
namespace {

constexpr int bits_per_axis = 21;

struct Keyed {
    std::uint64_t key;
    Index point;
};

// Spreads the low 21 bits of v to every third bit.
std::uint64_t spread_bits(std::uint64_t v) {
    v = (v | v << 32) & 0x1f00000000ffffu;
    v = (v | v << 16) & 0x1f0000ff0000ffu;
    v = (v | v << 8) & 0x100f00f00f00f00fu;
    v = (v | v << 4) & 0x10c30c30c30c30c3u;
    return (v | v << 2) & 0x1249249249249249u;
}

// Position on the curve of a cell, by Skilling's transposed form [2004, "Programming the Hilbert curve"].
std::uint64_t hilbert_key(std::array<std::uint32_t, 3> cell) {
    for (std::uint32_t bit = 1u << (bits_per_axis - 1); bit > 1; bit >>= 1) {
        const std::uint32_t low = bit - 1;
        for (std::uint32_t& axis : cell) {
            // Without branches: invert the low bits of the first axis, or swap them with this one's.
            const std::uint32_t is_set = 0u - static_cast<std::uint32_t>((axis & bit) != 0);
            const std::uint32_t swapped = (cell[0] ^ axis) & low & ~is_set;
            cell[0] ^= (low & is_set) | swapped;
            axis ^= swapped;
        }
    }
    cell[1] ^= cell[0];
    cell[2] ^= cell[1];
    std::uint32_t flips = 0;
    for (std::uint32_t bit = 1u << (bits_per_axis - 1); bit > 1; bit >>= 1) {
        if (cell[2] & bit) flips ^= bit - 1;
    }
    for (std::uint32_t& axis : cell) axis ^= flips;
    return spread_bits(cell[0]) << 2 | spread_bits(cell[1]) << 1 | spread_bits(cell[2]);
}

std::vector<Keyed> make_keys(std::span<const Vec3> positions) {
    Vec3 low = positions[0];
    Vec3 high = positions[0];
    for (const Vec3& p : positions) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    const Vec3 size = high - low;
    const double cells = (1 << bits_per_axis) - 1;
    double scale = cells / std::max({size.x, size.y, size.z});
    // One place, or a box wider than double can say: one cell, and coordinates order the points.
    if (!std::isfinite(scale) || !std::isfinite(size.x + size.y + size.z)) scale = 0;
    std::vector<Keyed> keys(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        std::array<std::uint32_t, 3> cell{};
        for (int axis = 0; axis < 3 && scale != 0; ++axis) {
            cell[axis] = static_cast<std::uint32_t>(std::min((positions[i][axis] - low[axis]) * scale, cells));
        }
        keys[i] = {hilbert_key(cell), static_cast<Index>(i)};
    }
    return keys;
}

// Least significant digit first, so equal keys keep the order of their indices.
void radix_sort(std::vector<Keyed>& keys) {
    constexpr int digit_bits = 11;
    constexpr std::uint64_t digit_mask = (1u << digit_bits) - 1;
    std::vector<Keyed> other(keys.size());
    for (int shift = 0; shift < 3 * bits_per_axis; shift += digit_bits) {
        std::array<std::uint32_t, digit_mask + 1> start{};
        for (const Keyed& k : keys) ++start[k.key >> shift & digit_mask];
        std::uint32_t sum = 0;
        for (std::uint32_t& s : start) sum += std::exchange(s, sum);
        for (const Keyed& k : keys) other[start[k.key >> shift & digit_mask]++] = k;
        keys.swap(other);
    }
}

}

std::vector<Index> hilbert_order(std::span<const Vec3> positions) {
    if (positions.empty()) return {};
    std::vector<Keyed> keys = make_keys(positions);
    radix_sort(keys);
    for (auto run = keys.begin(); run != keys.end();) {
        auto end = run + 1;
        while (end != keys.end() && end->key == run->key) ++end;
        std::stable_sort(run, end, [&](const Keyed& a, const Keyed& b) {
            return lexicographic_less(positions[a.point], positions[b.point]);
        });
        run = end;
    }
    std::vector<Index> order(keys.size());
    std::transform(keys.begin(), keys.end(), order.begin(), [](const Keyed& k) { return k.point; });
    return order;
}

}
