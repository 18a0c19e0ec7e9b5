// SPDX-License-Identifier: GPL-3.0-or-later
// The body of the fuzz target on random bytes, so that every build runs it; the fuzzer itself needs clang.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "core/random.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace crumple {
namespace {

TEST(DelaunayFuzzed, AnyBytesAreAPointSetItAnswersOrRefuses) {
    for (std::uint64_t round = 0; round < 1000; ++round) {
        Rng rng(77, round);
        std::vector<std::uint8_t> bytes(1 + rng.next_below(400));
        // Few distinct bytes make many equal, collinear and coplanar points.
        const std::uint32_t distinct = 1 + rng.next_below(256);
        for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(rng.next_below(distinct));
        bytes[0] = static_cast<std::uint8_t>(round);
        EXPECT_EQ(LLVMFuzzerTestOneInput(bytes.data(), bytes.size()), 0);
    }
}

}
}
