// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/spatial_order.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "geometry/measures.h"

namespace crumple::bind {

namespace {

constexpr int bits_per_axis = 10;
constexpr int digit_bits = 10;  // three passes over 30 bits
constexpr std::uint32_t digit_count = 1u << digit_bits;

// Puts two zero bits between the low ten bits of x.
std::uint32_t spread(std::uint32_t x) {
    x = (x | (x << 16)) & 0x030000FFu;
    x = (x | (x << 8)) & 0x0300F00Fu;
    x = (x | (x << 4)) & 0x030C30C3u;
    return (x | (x << 2)) & 0x09249249u;
}

struct Key {
    std::uint32_t code;
    Index index;
};

std::vector<Key> keys_of(std::span<const Vec3> positions) {
    const Box box = bounding_box(positions);
    const Vec3 size = box.high - box.low;
    constexpr double cells = (1 << bits_per_axis) - 1;
    std::vector<Key> keys;
    keys.reserve(positions.size());
    for (Index i = 0; i < positions.size(); ++i) {
        std::uint32_t code = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double share = size[axis] > 0 ? (positions[i][axis] - box.low[axis]) / size[axis] : 0;
            code |= spread(static_cast<std::uint32_t>(std::clamp(share, 0.0, 1.0) * cells)) << axis;
        }
        keys.push_back({code, i});
    }
    return keys;
}

void sort_by_digit(const std::vector<Key>& from, std::vector<Key>& to, int shift) {
    std::array<std::uint32_t, digit_count + 1> start{};
    for (const Key& key : from) ++start[((key.code >> shift) & (digit_count - 1)) + 1];
    for (std::uint32_t d = 0; d < digit_count; ++d) start[d + 1] += start[d];
    for (const Key& key : from) to[start[(key.code >> shift) & (digit_count - 1)]++] = key;
}

}

std::vector<Index> spatial_order(std::span<const Vec3> positions) {
    std::vector<Key> keys = keys_of(positions);
    std::vector<Key> sorted(keys.size());
    for (int shift = 0; shift < 3 * bits_per_axis; shift += digit_bits) {
        sort_by_digit(keys, sorted, shift);
        keys.swap(sorted);
    }
    std::vector<Index> order;
    order.reserve(keys.size());
    for (const Key& key : keys) order.push_back(key.index);
    return order;
}

}
