// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/usage.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "sandbox/sandbox.h"

TEST(Usage, MemoryThatWasHeldAndGivenBackCounts) {
    const crumple::pipeline::UsageMeter meter;
    const double before = meter.read().peak_memory_mb;
    {
        std::vector<char> block(64u << 20, 1);
        EXPECT_EQ(block[block.size() / 2], 1);
    }
    EXPECT_GE(meter.read().peak_memory_mb, before + 60);
}

TEST(Usage, MemoryOfAChildCounts) {
    const crumple::pipeline::UsageMeter meter;
    const double before = meter.read().peak_memory_mb;
    const auto outcome = crumple::sandbox::run_in_child(
        [] {
            const std::vector<char> block(300u << 20, 1);
            return std::vector<std::byte>(1, static_cast<std::byte>(block[block.size() / 2]));
        },
        {});
    ASSERT_EQ(outcome.ending, crumple::sandbox::Ending::ok);
    EXPECT_GE(meter.read().peak_memory_mb, before + 250);
}

TEST(Usage, TimesNeverRunBackwards) {
    const crumple::pipeline::UsageMeter meter;
    const auto first = meter.read();
    double sum = 0;
    for (int i = 0; i < 1000000; ++i) sum += i;
    const auto second = meter.read();
    EXPECT_GT(sum, 0);
    EXPECT_GE(first.wall_s, 0);
    EXPECT_GE(second.wall_s, first.wall_s);
    EXPECT_GE(second.cpu_s, first.cpu_s);
}
