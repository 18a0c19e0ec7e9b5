// SPDX-License-Identifier: MIT
// How much a test does: CRUMPLE_FULL_TESTS=1 for the full sizes, CRUMPLE_EMULATED_TESTS=1 for processors that are
// emulated and take a hundred times as long, else what a developer waits for.
#pragma once
#include <cstdint>
#include <cstdlib>

namespace crumple::solver::test {

inline bool is_emulated() { return std::getenv("CRUMPLE_EMULATED_TESTS") != nullptr; }

template <class Number>
Number effort(Number quick, Number full, Number emulated) {
    if (is_emulated()) return emulated;
    return std::getenv("CRUMPLE_FULL_TESTS") != nullptr ? full : quick;
}

// Random crashes. With sanitizers one takes twenty times as long, so there are fewer.
#ifdef NDEBUG
inline constexpr std::uint64_t crash_runs = 1000;
inline constexpr std::uint64_t all_crash_runs = 100000;
#else
inline constexpr std::uint64_t crash_runs = 150;
inline constexpr std::uint64_t all_crash_runs = 5000;
#endif

}
