// SPDX-License-Identifier: MIT
#include "samples/solids.h"

#include <map>

#include "samples/curve.h"
#include "samples/loft.h"

namespace crumple::samples {
namespace {

using Lattice = std::array<int, 3>;
using Quad = std::array<Index, 4>;

// Blends a point of the cube [-1, 1]^3 with the sphere.
Vec3 rounded(Vec3 p, double rounding) {
    const double size = length(p);
    return size == 0 ? p : p * (1 - rounding) + p / size * rounding;
}

Ring circle_ring(Part& part, Vec3 centre, Vec3 u, Vec3 v, int count, double offset, Color color) {
    Ring ring;
    for (int k = 0; k < count; ++k) {
        const double place = (k + offset) / count;
        const Turn t = turn(place);
        ring.vertices.push_back(add_vertex(part, centre + u * t.cosine + v * t.sine, color));
        ring.places.push_back(place);
    }
    return ring;
}

Vec3 unit(Vec3 v) { return v / length(v); }

// Any direction across d, always the same for the same d.
Vec3 across(Vec3 d) { return unit(std::abs(d.y) < 0.9 ? cross(d, Vec3{0, 1, 0}) : cross(d, Vec3{1, 0, 0})); }

}

void add_box(Part& part, const Box& box, Color color) {
    std::map<Lattice, Index> vertices;
    const auto vertex = [&](Lattice at) {
        const auto [entry, is_new] = vertices.try_emplace(at, none);
        if (is_new) {
            Vec3 p;
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = 2.0 * at[static_cast<std::size_t>(axis)] / box.cells[static_cast<std::size_t>(axis)] - 1;
            p = rounded(p, box.rounding);
            entry->second =
                add_vertex(part, box.centre + Vec3{p.x * box.half.x, p.y * box.half.y, p.z * box.half.z}, color);
        }
        return entry->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        for (const int side : {0, box.cells[axis]}) {
            for (int i = 0; i < box.cells[u]; ++i) {
                for (int j = 0; j < box.cells[v]; ++j) {
                    const auto corner = [&](int di, int dj) {
                        Lattice at{};
                        at[axis] = side;
                        at[u] = i + di;
                        at[v] = j + dj;
                        return vertex(at);
                    };
                    // In braces: the order in which vertices are made must not depend on the compiler.
                    const Quad quad = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
                    if (side == 0) {
                        add_quad(part, quad[0], quad[3], quad[2], quad[1]);
                    } else {
                        add_quad(part, quad[0], quad[1], quad[2], quad[3]);
                    }
                }
            }
        }
    }
}

void add_revolved(Part& part, Vec3 centre, std::span<const Hoop> hoops, Color color) {
    const auto middle = [&](const Hoop& hoop) { return centre + Vec3{hoop.x, 0, 0}; };
    Ring last;
    for (std::size_t i = 1; i + 1 < hoops.size(); ++i) {
        const Hoop& hoop = hoops[i];
        const Ring ring =
            circle_ring(part, middle(hoop), {0, hoop.radius, 0}, {0, 0, hoop.radius}, hoop.count, hoop.offset, color);
        if (i == 1) {
            close_with_point(part, reversed(ring), middle(hoops.front()), color);
        } else {
            stitch(part, last, ring);
        }
        last = ring;
    }
    close_with_point(part, last, middle(hoops.back()), color);
}

void add_torus(Part& part, const Torus& torus, Color color) {
    Vec3 axis, u;
    axis[torus.axis] = 1;
    u[(torus.axis + 1) % 3] = 1;
    const Vec3 v = cross(axis, u);
    std::vector<Ring> rings;
    for (int k = 0; k < torus.segments; ++k) {
        const Turn t = turn(static_cast<double>(k) / torus.segments);
        const Vec3 outward = u * t.cosine + v * t.sine;
        rings.push_back(circle_ring(part, torus.centre + outward * torus.radius, outward * torus.thickness,
                                    axis * -torus.thickness, torus.sides, 0, color));
    }
    for (std::size_t k = 0; k < rings.size(); ++k) stitch(part, rings[k], rings[(k + 1) % rings.size()]);
}

void add_pipe(Part& part, std::span<const Vec3> path, double radius, int sides, Color color) {
    Vec3 u = across(unit(path[1] - path[0]));
    Ring last;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Vec3 before = i > 0 ? unit(path[i] - path[i - 1]) : unit(path[1] - path[0]);
        const Vec3 after = i + 1 < path.size() ? unit(path[i + 1] - path[i]) : before;
        const Vec3 along = unit(before + after);
        u = unit(u - along * dot(u, along));  // carried along without twist
        const Ring ring = circle_ring(part, path[i], u * radius, cross(along, u) * radius, sides, 0, color);
        if (i == 0) {
            close_with_point(part, reversed(ring), path[0], color);
        } else {
            stitch(part, last, ring);
        }
        last = ring;
    }
    close_with_point(part, last, path.back(), color);
}

}
