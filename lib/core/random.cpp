// SPDX-License-Identifier: MIT
#include "core/random.h"

namespace crumple {

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
    // Multipliers and Weyl steps of the paper, section 3.3.
    constexpr std::uint64_t multiplier_0 = 0xD2511F53u;
    constexpr std::uint64_t multiplier_1 = 0xCD9E8D57u;
    constexpr std::uint32_t weyl_0 = 0x9E3779B9u;
    constexpr std::uint32_t weyl_1 = 0xBB67AE85u;
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t product_0 = multiplier_0 * counter[0];
        const std::uint64_t product_1 = multiplier_1 * counter[2];
        const auto high_0 = static_cast<std::uint32_t>(product_0 >> 32);
        const auto high_1 = static_cast<std::uint32_t>(product_1 >> 32);
        counter = {high_1 ^ counter[1] ^ key[0], static_cast<std::uint32_t>(product_1), high_0 ^ counter[3] ^ key[1],
                   static_cast<std::uint32_t>(product_0)};
        key[0] += weyl_0;
        key[1] += weyl_1;
    }
    return counter;
}

std::uint32_t Rng::next_u32() {
    if (left_ == 0) {
        numbers_ = philox4x32({static_cast<std::uint32_t>(block_), static_cast<std::uint32_t>(block_ >> 32),
                               static_cast<std::uint32_t>(stream_), static_cast<std::uint32_t>(stream_ >> 32)},
                              {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)});
        ++block_;
        left_ = 4;
    }
    return numbers_[4 - left_--];
}

std::uint32_t Rng::next_below(std::uint32_t bound) {
    // Lemire's multiply-and-reject: unbiased, and the same numbers everywhere.
    const std::uint32_t threshold = (0u - bound) % bound;
    for (;;) {
        const std::uint64_t product = std::uint64_t{next_u32()} * bound;
        if (static_cast<std::uint32_t>(product) >= threshold) return static_cast<std::uint32_t>(product >> 32);
    }
}

void Rng::seek(std::uint64_t block) {
    block_ = block;
    left_ = 0;
}

}
