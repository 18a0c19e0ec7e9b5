// SPDX-License-Identifier: MIT
#include "core/random.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

using namespace crumple;

namespace {

using Block = std::array<std::uint32_t, 4>;

// Known answers of the authors' Random123 1.14, file kat_vectors, lines "philox4x32 10".
TEST(Philox, ZeroCounterAndKeyGiveTheKnownAnswer) {
    EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}), (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
}

TEST(Philox, AllOnesGiveTheKnownAnswer) {
    EXPECT_EQ(philox4x32({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
              (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
}

TEST(Philox, DigitsOfPiGiveTheKnownAnswer) {
    EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
              (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Rng, NumbersAreTheBlocksInOrder) {
    constexpr std::uint64_t seed = 0x123456789abcdef0;
    constexpr std::uint64_t stream = 0xfedcba9876543210;
    Rng rng(seed, stream);
    for (std::uint32_t block = 0; block < 3; ++block) {
        const Block expected = philox4x32({block, 0, 0x76543210, 0xfedcba98}, {0x9abcdef0, 0x12345678});
        for (const std::uint32_t number : expected) EXPECT_EQ(rng.next_u32(), number);
    }
}

TEST(Rng, SeekContinuesAtThatBlock) {
    Rng walked(7);
    for (int i = 0; i < 4 * 5; ++i) (void)walked.next_u32();
    Rng sought(7);
    (void)sought.next_u32();
    sought.seek(5);
    for (int i = 0; i < 9; ++i) EXPECT_EQ(walked.next_u32(), sought.next_u32());
}

TEST(Rng, SeekCrossesTheLowCounterWord) {
    Rng rng(7);
    rng.seek(std::uint64_t{1} << 32);
    EXPECT_EQ(rng.next_u32(), philox4x32({0, 1, 0, 0}, {7, 0})[0]);
}

TEST(Rng, SeedsAndStreamsDiffer) {
    std::set<std::uint32_t> firsts;
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
        for (std::uint64_t stream = 0; stream < 16; ++stream) firsts.insert(Rng(seed, stream).next_u32());
    }
    EXPECT_EQ(firsts.size(), 256u);
}

TEST(Rng, UnitsNeverReachZeroOrOne) {
    EXPECT_GT(Rng::unit(0), 0.0);
    EXPECT_LT(Rng::unit(0xffffffff), 1.0);
    EXPECT_EQ(Rng::unit(0), 0x1p-33);
    EXPECT_EQ(Rng::unit(0x80000000), 0.5 + 0x1p-33);
}

TEST(Rng, UnitsFillTheIntervalEvenly) {
    constexpr int draws = 100'000;
    std::vector<int> hits(10);
    Rng rng(42);
    for (int i = 0; i < draws; ++i) ++hits[static_cast<std::size_t>(rng.next_unit() * 10)];
    // Binomial with p = 0.1: standard deviation 95; five of them.
    for (const int hit : hits) EXPECT_NEAR(hit, draws / 10, 475);
}

TEST(Rng, NextBelowOneIsZero) {
    Rng rng(3);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(rng.next_below(1), 0u);
}

TEST(Rng, NextBelowStaysBelowAndReachesEveryValue) {
    for (const std::uint32_t bound : {2u, 3u, 7u, 10u}) {
        Rng rng(bound);
        std::vector<int> hits(bound);
        for (int i = 0; i < 7000; ++i) {
            const std::uint32_t number = rng.next_below(bound);
            ASSERT_LT(number, bound);
            ++hits[number];
        }
        // At most five standard deviations of a binomial, which are below 5 sqrt(7000 / 4).
        for (const int hit : hits) EXPECT_NEAR(hit, 7000.0 / bound, 210);
    }
}

TEST(Rng, NextBelowIsUnbiasedForTheWorstBound) {
    // Without rejection, every third value would come twice as often as the others.
    constexpr std::uint32_t bound = 0xc0000000;
    Rng rng(5);
    int thirds = 0;
    constexpr int draws = 30'000;
    for (int i = 0; i < draws; ++i) thirds += rng.next_below(bound) % 3 == 0 ? 1 : 0;
    EXPECT_NEAR(thirds, draws / 3, 5 * 82);
}

}
