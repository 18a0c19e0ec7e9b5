// SPDX-License-Identifier: MIT
#include "samples/off_circle.h"

#include <algorithm>
#include <map>

namespace crumple::samples {
namespace {

// An edge and the two corners across it.
struct Hinge {
    Index a, b;
    Index left, right;
};

std::vector<Hinge> hinges(const Part& part) {
    std::map<Edge, Index> across;
    for (const auto& t : part.triangles) {
        for (std::size_t i = 0; i < 3; ++i) across[{t[i], t[(i + 1) % 3]}] = t[(i + 2) % 3];
    }
    std::vector<Hinge> result;
    for (const auto& [edge, left] : across) {
        if (edge[0] < edge[1]) result.push_back({edge[0], edge[1], left, across.at({edge[1], edge[0]})});
    }
    return result;
}

double cotangent(Vec3 at, Vec3 p, Vec3 q) {
    const Vec3 u = p - at;
    const Vec3 v = q - at;
    return dot(u, v) / length(cross(u, v));
}

// Sum of the cotangents of the two angles across: 0 on a common circle, positive where the edge is the short way.
double clearance(const Part& part, const Hinge& h) {
    const auto& p = part.positions;
    return cotangent(p[h.left], p[h.a], p[h.b]) + cotangent(p[h.right], p[h.a], p[h.b]);
}

bool is_flat(const Part& part, const Hinge& h) {
    const auto& p = part.positions;
    const Vec3 n = cross(p[h.b] - p[h.a], p[h.left] - p[h.a]);
    const Vec3 m = cross(p[h.right] - p[h.a], p[h.b] - p[h.a]);
    return dot(n, m) > 0.9 * length(n) * length(m);
}

// The other diagonal of the two triangles, where it is the short way and not an edge already.
bool flip(Part& part, const Hinge& h) {
    std::size_t first = none;
    std::size_t second = none;
    for (std::size_t t = 0; t < part.triangles.size(); ++t) {
        const auto has = [&](Index v) { return std::count(part.triangles[t].begin(), part.triangles[t].end(), v) > 0; };
        if (has(h.left) && has(h.right)) return false;
        if (has(h.a) && has(h.b)) (has(h.left) ? first : second) = t;
    }
    part.triangles[first] = {h.left, h.a, h.right};
    part.triangles[second] = {h.right, h.b, h.left};
    return true;
}

void flip_long_diagonals(Part& part) {
    for (bool is_done = false; !is_done;) {
        is_done = true;
        for (const auto& h : hinges(part)) {
            if (!is_flat(part, h) || clearance(part, h) > -0.05 || !flip(part, h)) continue;
            is_done = false;
            break;  // the other hinges have changed
        }
    }
}

}

void move_off_circles(Part& part) {
    flip_long_diagonals(part);
    constexpr int passes = 60;
    constexpr double enough = 0.45;
    constexpr double step = 0.02;  // of the distance across
    const auto all = hinges(part);
    for (int pass = 0; pass < passes; ++pass) {
        bool is_done = true;
        for (const auto& h : all) {
            if (!is_flat(part, h) || clearance(part, h) > enough) continue;
            is_done = false;
            const Vec3 apart = (part.positions[h.left] - part.positions[h.right]) * step;
            const Vec3 closer = (part.positions[h.b] - part.positions[h.a]) * step;
            part.positions[h.left] += apart;
            part.positions[h.right] -= apart;
            part.positions[h.a] += closer;
            part.positions[h.b] -= closer;
        }
        if (is_done) break;
    }
    for (auto& p : part.positions) p = round_to_float(p);
}

}
