// SPDX-License-Identifier: GPL-3.0-or-later
// Shells that a Delaunay tetrahedralization of their vertices misses: twisted, thin, needled, wound around each other.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/random.h"
#include "mesh/shapes.h"

namespace crumple::shapes {

// One closed solid component out of positions and triangles.
inline Shell solid_of(std::vector<Vec3> positions, std::vector<Triangle> triangles) {
    Shell shell;
    for (Vec3& p : positions) p = round_to_float(p);
    shell.locked.assign(positions.size(), 0);
    for (Index v = 0; v < positions.size(); ++v) shell.source_vertex.push_back(v);
    shell.component.assign(triangles.size(), 0);
    shell.positions = std::move(positions);
    shell.triangles = std::move(triangles);
    Component component;
    component.name = "solid";
    component.is_closed = true;
    shell.components.push_back(component);
    return shell;
}

// The prism over a regular polygon whose top is turned, in layers, its side faces folded inwards along the diagonals
// that the turning makes long. With three sides and one layer this is Schoenhardt's polyhedron: it cannot be cut into
// tets without a further node.
inline Shell twisted_prism(int sides = 3, int layers = 1, double turn = std::numbers::pi / 6, double height = 1) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    const auto at = [&](int layer, int side) { return static_cast<Index>(layer * sides + (side % sides)); };
    for (int layer = 0; layer <= layers; ++layer) {
        for (int side = 0; side < sides; ++side) {
            const double angle = 2 * std::numbers::pi * side / sides + turn * layer;
            positions.push_back({std::cos(angle), height * layer, -std::sin(angle)});
        }
    }
    for (int layer = 0; layer < layers; ++layer) {
        for (int side = 0; side < sides; ++side) {
            const Index a = at(layer, side), b = at(layer, side + 1), c = at(layer + 1, side),
                        d = at(layer + 1, side + 1);
            triangles.push_back({a, b, d});
            triangles.push_back({a, d, c});
        }
    }
    for (int side = 1; side + 1 < sides; ++side) {
        triangles.push_back({at(0, 0), at(0, side + 1), at(0, side)});
        triangles.push_back({at(layers, 0), at(layers, side), at(layers, side + 1)});
    }
    return solid_of(std::move(positions), std::move(triangles));
}

// The plate between two copies of y = x z on [-1, 1]^2, `gap` apart, every cell folded the hollow way: the two sides
// come near each other along skew lines, as in Chazelle's polyhedron.
inline Shell saddle_plate(int cells = 6, double gap = 0.05) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    const int n = cells + 1;
    const auto at = [&](int side, int i, int k) { return static_cast<Index>((side * n + i) * n + k); };
    for (int side = 0; side < 2; ++side) {
        for (int i = 0; i < n; ++i) {
            for (int k = 0; k < n; ++k) {
                const double x = 2.0 * i / cells - 1;
                const double z = 2.0 * k / cells - 1;
                positions.push_back({x, x * z + side * gap, z});
            }
        }
    }
    const auto quad = [&](Index a, Index b, Index c, Index d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    };
    for (int i = 0; i < cells; ++i) {
        for (int k = 0; k < cells; ++k) {
            quad(at(1, i, k), at(1, i, k + 1), at(1, i + 1, k + 1), at(1, i + 1, k));
            quad(at(0, i + 1, k), at(0, i + 1, k + 1), at(0, i, k + 1), at(0, i, k));
        }
    }
    for (int i = 0; i < cells; ++i) {
        quad(at(0, i, 0), at(1, i, 0), at(1, i + 1, 0), at(0, i + 1, 0));
        quad(at(0, i + 1, cells), at(1, i + 1, cells), at(1, i, cells), at(0, i, cells));
        quad(at(0, 0, i + 1), at(1, 0, i + 1), at(1, 0, i), at(0, 0, i));
        quad(at(0, cells, i), at(1, cells, i), at(1, cells, i + 1), at(0, cells, i + 1));
    }
    return solid_of(std::move(positions), std::move(triangles));
}

// A ball whose every `every`-th vertex is pulled out.
inline Shell spiked_ball(int levels = 2, int every = 3, double reach = 2.5) {
    Shell shell = icosphere(1, levels);
    for (std::size_t v = 0; v < shell.positions.size(); v += every)
        shell.positions[v] = round_to_float(shell.positions[v] * reach);
    return shell;
}

// A ball whose vertices lie at random distances from its middle.
inline Shell rough_ball(int levels, double least, double most, std::uint64_t seed) {
    Shell shell = icosphere(1, levels);
    Rng random(seed, 77);
    for (Vec3& p : shell.positions) p = round_to_float(p * (least + (most - least) * random.next_unit()));
    return shell;
}

// A tube around the closed curve that winds p times around the y axis while it goes q times around a ring: (2, 3) is
// the trefoil knot.
inline Shell knot(int p = 2, int q = 3, double radius = 0.35, int around = 60, int across = 6) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    const auto curve = [&](double t) {
        const double r = 2 + std::cos(q * t);
        return Vec3{r * std::cos(p * t), std::sin(q * t), -r * std::sin(p * t)};
    };
    for (int i = 0; i < around; ++i) {
        const double t = 2 * std::numbers::pi * i / around;
        const Vec3 c = curve(t);
        Vec3 along = curve(t + 1e-4) - curve(t - 1e-4);
        along = along / length(along);
        Vec3 out{std::cos(p * t), 0, -std::sin(p * t)};
        Vec3 up = cross(along, out);
        up = up / length(up);
        out = cross(up, along);
        for (int k = 0; k < across; ++k) {
            const double angle = 2 * std::numbers::pi * k / across;
            positions.push_back(c + (out * std::cos(angle) + up * std::sin(angle)) * radius);
        }
    }
    const auto at = [&](int i, int k) { return static_cast<Index>((i % around) * across + (k % across)); };
    for (int i = 0; i < around; ++i) {
        for (int k = 0; k < across; ++k) {
            triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
            triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
        }
    }
    return solid_of(std::move(positions), std::move(triangles));
}

// Two rings that go through each other's hole, `gap` apart.
inline Shell linked_rings(double gap = 0.05, int around = 16, int across = 8) {
    const double minor = 0.5 - gap / 2;
    Shell a = torus(1, minor, around, across);
    Shell b = a;
    for (Vec3& p : b.positions) p = round_to_float(Vec3{p.x + 1, p.z, -p.y});
    return joined(std::move(a), b);
}

// The same shell with its triangles in another order and their corners turned.
inline Shell shuffled_triangles(Shell shell, std::uint64_t seed) {
    Rng random(seed, 5);
    for (std::size_t f = shell.triangles.size(); f-- > 1;) {
        const std::size_t other = random.next_below(static_cast<std::uint32_t>(f + 1));
        std::swap(shell.triangles[f], shell.triangles[other]);
        std::swap(shell.component[f], shell.component[other]);
        Triangle& t = shell.triangles[f];
        std::rotate(t.begin(), t.begin() + random.next_below(3), t.end());
    }
    return shell;
}

}
