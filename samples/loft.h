// SPDX-License-Identifier: MIT
// Closed surfaces from rings of vertices: neighbours are stitched, the last ring is closed.
#pragma once
#include <span>
#include <vector>

#include "samples/model.h"

namespace crumple::samples {

// A closed ring of a part's vertices, counter-clockwise seen from where the loft goes, each with its place in [0, 1)
// around the ring. Stitching pairs equal places, so rings may have different numbers of vertices.
struct Ring {
    std::vector<Index> vertices;
    std::vector<double> places;
};

// Adds `count` vertices to the part at the places (k + offset) / count of a closed polyline given by dense points,
// equally far along it.
Ring add_ring(Part& part, std::span<const Vec3> outline, int count, double offset, Color color);

// Triangles between two rings, outward.
void stitch(Part& part, const Ring& from, const Ring& to);

// Closes a ring around one new vertex.
void close_with_point(Part& part, const Ring& ring, Vec3 point, Color color);

// Closes a long flat ring by zipping its two halves together; place 0 and place 1/2 are the middles of the halves.
void close_by_zipping(Part& part, const Ring& ring);

// A ring running the other way round, as the far end of a loft is seen.
[[nodiscard]] Ring reversed(const Ring& ring);

}
