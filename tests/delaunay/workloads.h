// SPDX-License-Identifier: GPL-3.0-or-later
// The point sets delaunay is tested and measured on: random, regular, cospherical, like a car's shell, and traps.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/random.h"
#include "core/vec3.h"

namespace crumple::workloads {

using Points = std::vector<Vec3>;

inline constexpr std::uint64_t seed = 20240607;

// 53 random bits in [0, 1), so that nothing is exact by luck.
inline double unit53(Rng& rng) {
    const double high = rng.next_u32() >> 5;
    const double low = rng.next_u32() >> 6;
    return (high * 0x1p26 + low) * 0x1p-53;
}

inline double gaussian(Rng& rng) {
    const double radius = std::sqrt(-2 * std::log(rng.next_unit()));
    return radius * std::cos(2 * std::numbers::pi * unit53(rng));
}

inline Points shuffled(Points points, std::uint64_t shuffle_seed = seed) {
    Rng rng(shuffle_seed, 99);
    for (std::size_t i = points.size(); i > 1; --i) {
        std::swap(points[i - 1], points[rng.next_below(static_cast<std::uint32_t>(i))]);
    }
    return points;
}

inline Points uniform(std::size_t count) {
    Rng rng(seed, 1);
    Points points(count);
    for (Vec3& p : points) {
        for (int axis = 0; axis < 3; ++axis) p[axis] = unit53(rng);
    }
    return points;
}

// Integer coordinates 0..side-1: every cell cospherical.
inline Points grid(int side) {
    Points points;
    for (int x = 0; x < side; ++x) {
        for (int y = 0; y < side; ++y) {
            for (int z = 0; z < side; ++z) points.push_back({double(x), double(y), double(z)});
        }
    }
    return shuffled(std::move(points));
}

// Normalised Gaussian vectors: on the sphere but for rounding.
inline Points sphere(std::size_t count) {
    Rng rng(seed, 2);
    Points points(count);
    for (Vec3& p : points) {
        p = {gaussian(rng), gaussian(rng), gaussian(rng)};
        p = p / length(p);
    }
    return points;
}

// 32 centres of very different spread.
inline Points clusters(std::size_t count) {
    Rng rng(seed, 3);
    Points centres(32);
    std::vector<double> spread(32);
    for (std::size_t i = 0; i < centres.size(); ++i) {
        centres[i] = {unit53(rng), unit53(rng), unit53(rng)};
        spread[i] = std::pow(10.0, -4 + 3 * unit53(rng));
    }
    Points points(count);
    for (Vec3& p : points) {
        const std::uint32_t i = rng.next_below(32);
        p = centres[i] + spread[i] * Vec3{gaussian(rng), gaussian(rng), gaussian(rng)};
    }
    return points;
}

namespace car_parts {

struct Cuboid {
    Vec3 low;
    Vec3 high;
};

inline constexpr Cuboid boxes[] = {{{-0.9, -2.1, 0.3}, {0.9, 2.1, 0.9}}, {{-0.75, -1.0, 0.9}, {0.75, 0.8, 1.5}}};

inline int steps(double size, double spacing) { return std::max(1, static_cast<int>(std::lround(size / spacing))); }

inline void add_box(Points& points, const Cuboid& box, double spacing) {
    const Vec3 size = box.high - box.low;
    const int nx = steps(size.x, spacing), ny = steps(size.y, spacing), nz = steps(size.z, spacing);
    for (int i = 0; i <= nx; ++i) {
        for (int j = 0; j <= ny; ++j) {
            for (int k = 0; k <= nz; ++k) {
                if (i % nx != 0 && j % ny != 0 && k % nz != 0) continue;
                points.push_back(
                    {box.low.x + size.x * i / nx, box.low.y + size.y * j / ny, box.low.z + size.z * k / nz});
            }
        }
    }
}

inline void add_wheel(Points& points, double x, double y, double spacing) {
    constexpr double radius = 0.35, width = 0.2;
    const int around = std::max(8, steps(2 * std::numbers::pi * radius, spacing));
    const int across = steps(width, spacing), rings = steps(radius, spacing);
    const auto add = [&](double dx, double r, int turn) {
        const double angle = 2 * std::numbers::pi * turn / around;
        points.push_back({x + dx, y + r * std::cos(angle), 0.35 + r * std::sin(angle)});
    };
    for (int turn = 0; turn < around; ++turn) {
        for (int i = 0; i <= across; ++i) add(width * (double(i) / across - 0.5), radius, turn);
        for (int ring = 0; ring < rings; ++ring) {
            for (const double side : {-0.5, 0.5}) add(side * width, radius * ring / rings, turn);
        }
    }
}

inline Points surface(double spacing) {
    Points points;
    for (const Cuboid& box : boxes) add_box(points, box, spacing);
    for (const double x : {-0.8, 0.8}) {
        for (const double y : {-1.3, 1.3}) add_wheel(points, x, y, spacing);
    }
    for (Vec3& p : points) p = round_to_float(p) + Vec3{};
    std::sort(points.begin(), points.end(), lexicographic_less<double>);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

}

// A car's shell on regular grids, mirror-symmetric, coplanar and cospherical everywhere, and as many points inside.
inline Points car(std::size_t count) {
    double low = 0.005, high = 1;
    for (int step = 0; step < 30; ++step) {
        const double spacing = std::sqrt(low * high);
        (car_parts::surface(spacing).size() > count / 2 ? low : high) = spacing;
    }
    Points points = car_parts::surface(high);
    Rng rng(seed, 4);
    while (points.size() < count) {
        const Vec3 p{1.8 * unit53(rng) - 0.9, 4.2 * unit53(rng) - 2.1, 0.3 + 1.2 * unit53(rng)};
        const auto holds = [p](const car_parts::Cuboid& box) {
            return p.x > box.low.x && p.x < box.high.x && p.y > box.low.y && p.y < box.high.y && p.z > box.low.z &&
                   p.z < box.high.z;
        };
        if (std::any_of(std::begin(car_parts::boxes), std::end(car_parts::boxes), holds)) {
            points.push_back(round_to_float(p));
        }
    }
    return shuffled(std::move(points));
}

// All integer points at one distance from the origin; radius 1105 has 6 630 of them.
inline Points integer_sphere(int radius) {
    Points points;
    for (int x = -radius; x <= radius; ++x) {
        for (int y = -radius; y <= radius; ++y) {
            const int square = radius * radius - x * x - y * y;
            if (square < 0) continue;
            const int z = static_cast<int>(std::lround(std::sqrt(double(square))));
            if (z * z != square) continue;
            points.push_back({double(x), double(y), double(z)});
            if (z != 0) points.push_back({double(x), double(y), double(-z)});
        }
    }
    return shuffled(std::move(points));
}

// Points alternating on two skew lines: every pair of edges makes a tet, quadratic output.
inline Points lines(int count) {
    Points points;
    for (int i = 0; i < count; ++i) {
        if (i % 2 == 0) {
            points.push_back({double(i), 0, 0});
        } else {
            points.push_back({0.25, double(i) - 0.5 * count, double(count)});
        }
    }
    return points;
}

inline Points octahedron() { return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}; }

inline Points cube() { return grid(2); }

// Rings of circles around an axis, an apex and the centres: what a fan of artists' triangles looks like.
inline Points cone_ring(int around) {
    Points points{{0, 0, 2}, {0, 0, 0}};
    for (int i = 0; i < around; ++i) {
        const double angle = 2 * std::numbers::pi * i / around;
        points.push_back(round_to_float({std::cos(angle), std::sin(angle), 0}));
        points.push_back(round_to_float({0.5 * std::cos(angle), 0.5 * std::sin(angle), 1}));
    }
    return points;
}

inline Points scaled(Points points, Vec3 factor, Vec3 offset = {}) {
    for (Vec3& p : points) p = Vec3{p.x * factor.x, p.y * factor.y, p.z * factor.z} + offset;
    return points;
}

inline Points scaled(Points points, double factor) { return scaled(std::move(points), {factor, factor, factor}); }

// A plane but for the last bit of z.
inline Points thin_slab(std::size_t count) {
    Points points = uniform(count);
    for (Vec3& p : points) p.z = p.z < 0.5 ? 1.0 : std::nextafter(1.0, 2.0);
    return points;
}

// z = x + y as doubles round it.
inline Points nearly_coplanar(std::size_t count) {
    Points points = uniform(count);
    for (Vec3& p : points) p.z = 0.1 * p.x + 0.7 * p.y;
    return points;
}

inline Points half_duplicated(std::size_t count) {
    Points points = uniform(count / 2);
    const Points again = points;
    points.insert(points.end(), again.begin(), again.end());
    return shuffled(std::move(points));
}

inline Points mixed_magnitudes(std::size_t count) {
    Rng rng(seed, 5);
    Points points(count);
    for (Vec3& p : points) {
        for (int axis = 0; axis < 3; ++axis) {
            p[axis] = (unit53(rng) - 0.5) * std::pow(10.0, -100 + 120 * unit53(rng));
        }
    }
    return points;
}

inline Points denormals(std::size_t count) {
    Rng rng(seed, 6);
    Points points(count);
    for (Vec3& p : points) {
        for (int axis = 0; axis < 3; ++axis) p[axis] = std::numeric_limits<double>::denorm_min() * rng.next_below(1000);
    }
    return points;
}

}
