// SPDX-License-Identifier: GPL-3.0-or-later
// A vector a node, taken as one long vector. Sums run in the order of the nodes.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec3.h"

namespace crumple::quality {

[[nodiscard]] inline double dot(std::span<const Vec3> a, std::span<const Vec3> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
    return sum;
}

// a += factor b
inline void add(std::span<Vec3> a, double factor, std::span<const Vec3> b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

// Numbers between -1 and 1, the same on every machine.
[[nodiscard]] std::vector<Vec3> noise(std::size_t count, std::uint64_t seed);

}
