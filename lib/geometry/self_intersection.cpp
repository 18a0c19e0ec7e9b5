// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/self_intersection.h"

#include "core/parallel_for.h"
#include "geometry/bvh.h"
#include "geometry/triangle_contact.h"

namespace crumple {

namespace {

constexpr std::size_t chunk_size = 256;

std::vector<MeetingTriangles> meetings_of(Index first, std::span<const Corners> corners, std::span<const Box> boxes,
                                          const Bvh& tree, std::size_t limit) {
    std::vector<Index> others;
    tree.touching(boxes[first], [&](Index other) {
        if (other > first) others.push_back(other);
        return false;
    });
    std::sort(others.begin(), others.end());
    std::vector<MeetingTriangles> found;
    for (const Index other : others) {
        if (found.size() == limit) break;
        if (!triangles_meet(corners[first], corners[other])) continue;
        found.push_back({first, other, contact_place(corners[first], corners[other])});
    }
    return found;
}

}

std::vector<MeetingTriangles> self_intersections(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                                                 const Context& context, std::size_t limit) {
    std::vector<Corners> corners;
    std::vector<Box> boxes;
    for (const auto& [a, b, c] : triangles) {
        corners.push_back({positions[a], positions[b], positions[c]});
        boxes.push_back(bounding_box(corners.back()));
    }
    const Bvh tree(boxes);
    std::vector<std::vector<MeetingTriangles>> by_chunk((triangles.size() + chunk_size - 1) / chunk_size);
    parallel_for(context, triangles.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        context.stop_if_cancelled();
        auto& found = by_chunk[begin / chunk_size];
        for (std::size_t t = begin; t < end; ++t) {
            const auto more = meetings_of(static_cast<Index>(t), corners, boxes, tree, limit);
            found.insert(found.end(), more.begin(), more.end());
        }
    });
    std::vector<MeetingTriangles> all;
    for (const auto& found : by_chunk) all.insert(all.end(), found.begin(), found.end());
    return all;
}

}
