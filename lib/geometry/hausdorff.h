// SPDX-License-Identifier: GPL-3.0-or-later
// How far one surface strays from another, measured at sample points: a lower bound of the one-sided Hausdorff distance
// that comes as near to it as the samples are dense.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "core/context.h"
#include "core/index.h"
#include "core/vec3.h"
#include "geometry/surface_distance.h"

namespace crumple {

struct SurfaceSample {
    Vec3 position;
    Index triangle = none;
};

// Every corner of every triangle (once a vertex), and about `count` points spread over the triangles by area, at least
// one a triangle. No randomness: the points are a regular pattern within each triangle.
[[nodiscard]] std::vector<SurfaceSample> sample_surface(std::span<const Vec3> positions,
                                                        std::span<const Triangle> triangles, std::size_t count);

struct Farthest {
    SurfaceSample sample;
    double distance = 0;  // metres, 0 when there is no sample
};

// The sample farthest from the surface among those that `counts` accepts; it is asked from the farthest down, so
// rarely. An empty surface is 0 away: there is nothing to measure against.
[[nodiscard]] Farthest farthest_sample(std::span<const SurfaceSample> samples, const SurfaceDistance& surface,
                                       const std::function<bool(const SurfaceSample&)>& counts,
                                       const Context& context = {});

}
