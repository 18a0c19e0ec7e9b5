// SPDX-License-Identifier: GPL-3.0-or-later
// How many points were asked for: "auto", "500" or "tets:5000".
#pragma once
#include <cstdint>
#include <string_view>

#include "core/fields.h"

namespace crumple::sample {

enum class CountKind {
    automatic,  // as the sizes of the shell's edges suggest
    points,     // so many interior points
    tets,       // so many interior points that about that many tets come out
};

struct Count {
    CountKind kind = CountKind::automatic;
    std::uint64_t number = 0;
};

inline constexpr std::uint64_t max_count = 1'000'000;

// The same for the schema: what parse_count takes, and nothing else.
inline constexpr Pattern count_pattern{"^(auto|0*(1000000|[0-9]{1,6})|tets:0*(1000000|[1-9][0-9]{0,5}))$"};

// Throws Error(usage) that shows what can be written.
[[nodiscard]] Count parse_count(std::string_view text);

// Tets inside a shell of that many vertices around that many interior points, and back (0 where the shell alone gives
// more).
[[nodiscard]] std::uint64_t expected_tets(std::uint64_t shell_vertices, std::uint64_t points);
[[nodiscard]] std::uint64_t points_for_tets(std::uint64_t shell_vertices, std::uint64_t tets);

}
