// SPDX-License-Identifier: MIT
// Counter-based random numbers: Philox4x32-10 [Salmon, Moraes, Dror, Shaw 2011, "Parallel random numbers: as easy as
// 1, 2, 3"]. The i-th number of a stream is a pure function of (seed, stream, i), so it does not depend on threads,
// platform or the order of asking.
#pragma once
#include <array>
#include <cstdint>

namespace crumple {

// The raw generator: 128 bits from a 128-bit counter and a 64-bit key.
[[nodiscard]] std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                                      std::array<std::uint32_t, 2> key);

class Rng {
public:
    explicit Rng(std::uint64_t seed, std::uint64_t stream = 0) : seed_(seed), stream_(stream) {}

    [[nodiscard]] std::uint32_t next_u32();
    [[nodiscard]] double next_unit() { return unit(next_u32()); }       // in (0, 1)
    [[nodiscard]] std::uint32_t next_below(std::uint32_t bound);        // uniform in [0, bound), unbiased; bound > 0
    void seek(std::uint64_t block);                                     // continue at block of four numbers

    // (u + .5) / 2^32: never 0, never 1, exact in double.
    [[nodiscard]] static double unit(std::uint32_t u) { return (u + 0.5) * 0x1p-32; }

private:
    std::uint64_t seed_;
    std::uint64_t stream_;
    std::uint64_t block_ = 0;
    std::array<std::uint32_t, 4> numbers_{};
    int left_ = 0;
};

}
