// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_distance.h"

namespace crumple {

SurfaceDistance::SurfaceDistance(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
    corners_.reserve(triangles.size());
    std::vector<Box> boxes;
    boxes.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) {
        corners_.push_back({positions[a], positions[b], positions[c]});
        boxes.push_back(bounding_box(corners_.back()));
    }
    tree_ = Bvh(boxes);
}

Vec3 SurfaceDistance::closest_on(Index triangle, Vec3 p) const {
    const auto& [a, b, c] = corners_[triangle];
    return closest_point_on_triangle(a, b, c, p);
}

SurfaceDistance::Closest SurfaceDistance::closest(Vec3 p, Index guess) const {
    const auto distance_2 = [&](Index triangle) {
        const Vec3 offset = closest_on(triangle, p) - p;
        return dot(offset, offset);
    };
    Bvh::Nearest known;
    if (guess < corners_.size()) known = {guess, distance_2(guess)};
    const Bvh::Nearest nearest = tree_.nearest(p, distance_2, known);
    if (nearest.element == none) return {};
    return {nearest.element, closest_on(nearest.element, p), std::sqrt(nearest.distance_2)};
}

}
