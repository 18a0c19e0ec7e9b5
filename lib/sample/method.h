// SPDX-License-Identifier: GPL-3.0-or-later
// A method chooses where the interior points go, among candidates that are all allowed.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "core/vec3.h"
#include "sample/candidates.h"
#include "sample/sample.h"

namespace crumple::sample {

struct Chosen {
    std::vector<Vec3> points;  // no two alike, in the order they were chosen
    std::uint64_t tries = 0;
    std::uint64_t candidates = 0;
    double spacing = 0;  // how near two points may be, in h; 0 when the method does not say
};

// `free_size` is the integral of 1 / h^3 over the space that may take points: how many cubes of edge h fit in.
using MethodFunction = Chosen (*)(Drawing drawing, std::uint64_t count, double free_size, const Context& context);

Chosen choose_uniform(Drawing drawing, std::uint64_t count, double free_size, const Context& context);
Chosen choose_poisson(Drawing drawing, std::uint64_t count, double free_size, const Context& context);

[[nodiscard]] MethodFunction method_function(Method method);

}
