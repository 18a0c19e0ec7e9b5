// SPDX-License-Identifier: MIT
// Something a person should know about an asset: a stable code, how bad, how often, and where the first few are.
#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

enum class Severity { info, warning, error };

// The position of what has none: a name, an array, a whole file.
inline constexpr Vec3 nowhere{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::quiet_NaN()};

struct Place {
    Vec3 position;         // metres, in the asset's space, or nowhere
    Index element = none;  // vertex, triangle or tet, as the finding's code says
    std::string name;      // what the artist knows it by: component, mesh or material; may be empty
};

struct Finding {
    std::string code;  // SHELL_OPEN, LOCK_CONFLICT, ...: never renamed
    Severity severity = Severity::info;
    std::string message;  // what, and what to try
    std::uint64_t count = 1;
    std::vector<Place> places;  // the first few only, at most max_places
};

inline constexpr std::size_t max_places = 8;

[[nodiscard]] inline bool wants_place(const Finding& finding) { return finding.places.size() < max_places; }

// One more of what the finding counts: its place is told while it is among the first few.
inline void count_one(Finding& finding, Place place) {
    ++finding.count;
    if (wants_place(finding)) finding.places.push_back(std::move(place));
}

}
