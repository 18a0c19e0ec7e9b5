// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/winding_number.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "mesh/shapes.h"

namespace crumple {
namespace {

struct Soup {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
};

// A wavy torus: 2 * around * across triangles, concave, many tree levels.
Soup wavy_torus(int around, int across) {
    Soup soup;
    const auto number = [&](int i, int j) { return static_cast<Index>((i % around) * across + j % across); };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double u = 2 * std::numbers::pi * i / around;
            const double v = 2 * std::numbers::pi * j / across;
            const double r = 0.4 + 0.1 * std::sin(5 * u) * std::cos(3 * v);
            soup.positions.push_back(
                {(1 + r * std::cos(v)) * std::cos(u), r * std::sin(v), (1 + r * std::cos(v)) * std::sin(u)});
            soup.triangles.push_back({number(i, j), number(i, j + 1), number(i + 1, j)});
            soup.triangles.push_back({number(i + 1, j), number(i, j + 1), number(i + 1, j + 1)});
        }
    }
    return soup;
}

// The definition, with an arctangent a triangle.
double slow_winding(const Soup& soup, Vec3 p) {
    double sum = 0;
    for (const auto& t : soup.triangles) {
        const Vec3 a = soup.positions[t[0]] - p;
        const Vec3 b = soup.positions[t[1]] - p;
        const Vec3 c = soup.positions[t[2]] - p;
        const double below =
            length(a) * length(b) * length(c) + dot(a, b) * length(c) + dot(b, c) * length(a) + dot(c, a) * length(b);
        sum += 2 * std::atan2(dot(a, cross(b, c)), below);
    }
    return sum / (4 * std::numbers::pi);
}

std::vector<Vec3> points_around(std::uint64_t seed, int count) {
    Rng rng(seed);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double x = rng.next_unit() * 4 - 2;
        const double y = rng.next_unit() * 2 - 1;
        points.push_back({x, y, rng.next_unit() * 4 - 2});
    }
    return points;
}

TEST(WindingNumber, OfNothingIsZero) {
    EXPECT_EQ(WindingNumber({}, {}).at({1, 2, 3}), 0);
    const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}};
    const std::vector<Triangle> flat{{0, 1, 1}, {0, 0, 0}};
    EXPECT_EQ(WindingNumber(positions, flat).at({0, 0, 0}), 0);
}

TEST(WindingNumber, EqualsTheDefinitionOnClosedAndOpenSurfaces) {
    Soup soup = wavy_torus(40, 24);
    for (const int dropped : {0, 1, 300}) {
        soup.triangles.resize(soup.triangles.size() - dropped);
        const WindingNumber winding(soup.positions, soup.triangles);
        for (const Vec3 p : points_around(7, 300)) EXPECT_NEAR(winding.at(p), slow_winding(soup, p), 1e-11);
    }
}

TEST(WindingNumber, IsAWholeNumberOffAClosedSurface) {
    const Soup soup = wavy_torus(48, 24);
    const WindingNumber winding(soup.positions, soup.triangles);
    int inside = 0;
    for (const Vec3 p : points_around(3, 500)) {
        const double w = winding.at(p);
        EXPECT_NEAR(w, std::round(w), 1e-12);
        inside += w > 0.5;
    }
    EXPECT_GT(inside, 20);
}

TEST(WindingNumber, CountsOverlappingSurfacesTwice) {
    Soup soup = wavy_torus(20, 10);
    const auto once = soup.triangles;
    soup.triangles.insert(soup.triangles.end(), once.begin(), once.end());
    EXPECT_NEAR(WindingNumber(soup.positions, soup.triangles).at({1, 0, 0}), 2, 1e-12);
}

TEST(WindingNumber, OrderAndWeldingDoNotChangeABit) {
    const Soup soup = wavy_torus(30, 16);
    Soup torn;  // unwelded, reversed, corners rotated
    for (auto t = soup.triangles.rbegin(); t != soup.triangles.rend(); ++t) {
        const auto first = static_cast<Index>(torn.positions.size());
        for (const int corner : {1, 2, 0}) torn.positions.push_back(soup.positions[(*t)[corner]]);
        torn.triangles.push_back({first, first + 1, first + 2});
    }
    const WindingNumber a(soup.positions, soup.triangles);
    const WindingNumber b(torn.positions, torn.triangles);
    for (const Vec3 p : points_around(11, 200)) EXPECT_EQ(a.at(p), b.at(p));
}

TEST(WindingNumber, RaysThroughCornersEdgesAndAlongSidesCountRight) {
    // A box of a grid: rays from grid points along the axes run into corners, along edges and within sides.
    const Shell box = shapes::subdivided_box(4, {0, 0, 0}, {4, 4, 4});
    const WindingNumber winding(box.positions, box.triangles);
    for (int x = 1; x < 4; ++x) {
        for (int y = 1; y < 4; ++y) {
            for (int z = 1; z < 4; ++z) {
                EXPECT_EQ(winding.at({double(x), double(y), double(z)}), 1);
                EXPECT_EQ(winding.at({x * 0.5, y - 0.25, double(z)}), 1);
                EXPECT_EQ(winding.at({double(x), double(y), -1.0 * z}), 0);
            }
        }
    }
}

TEST(WindingNumber, AHoleIsSeenTheSameFromBothSidesOfItsCap) {
    // Exactly in the plane of the missing side, an ulp above and an ulp below.
    Shell box = shapes::box();
    std::erase_if(box.triangles, [&](const Triangle& t) {
        return std::all_of(t.begin(), t.end(), [&](Index v) { return box.positions[v].z == 1; });
    });
    const WindingNumber winding(box.positions, box.triangles);
    for (const double x : {0.5, 0.25, 0.3}) {
        const double in_plane = winding.at({x, 0.375, 1});
        EXPECT_NEAR(in_plane, 0.5, 1e-9);
        EXPECT_NEAR(winding.at({x, 0.375, std::nextafter(1.0, 0.0)}), in_plane, 1e-9);
        EXPECT_NEAR(winding.at({x, 0.375, std::nextafter(1.0, 2.0)}), in_plane, 1e-9);
        EXPECT_NEAR(winding.at({x, 0.375, 1 - 1e-200}), in_plane, 1e-9);
    }
    EXPECT_GT(winding.at({0.5, 0.5, 0.5}), 0.8);
    EXPECT_LT(winding.at({0.5, 0.5, 1.5}), 0.3);
}

TEST(WindingNumber, ClosedSurfacesGiveWholeNumbersToTheLastBit) {
    const Shell shell =
        shapes::joined(shapes::torus(1, 0.4, 24, 12), shapes::inverted(shapes::icosphere(0.7, 2, {1, 0, 0})));
    const WindingNumber winding(shell.positions, shell.triangles);
    for (const Vec3 p : points_around(29, 500)) EXPECT_EQ(winding.at(p), std::round(winding.at(p)));
}

TEST(WindingNumber, IsOneHalfOnAFlatSide) {
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<Triangle> sides{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    EXPECT_NEAR(WindingNumber(corners, sides).at({0.25, 0.25, 0}), 0.5, 1e-12);
    EXPECT_TRUE(std::isfinite(WindingNumber(corners, sides).at({0, 0, 0})));
    EXPECT_TRUE(std::isfinite(WindingNumber(corners, sides).at({0.5, 0, 0})));
}

TEST(WindingNumber, ScaleAndPlaceDoNotMatter) {
    const Soup soup = wavy_torus(24, 12);
    for (const double scale : {1e-30, 1e-6, 1e6, 1e30}) {
        Soup scaled = soup;
        for (Vec3& p : scaled.positions) p = p * scale;
        const WindingNumber winding(scaled.positions, scaled.triangles);
        EXPECT_NEAR(winding.at(Vec3{1, 0, 0} * scale), 1, 1e-12);
        EXPECT_NEAR(winding.at(Vec3{0, 0, 0}), 0, 1e-12);
        EXPECT_NEAR(winding.at(Vec3{1e9, 1e9, 1e9} * scale), 0, 1e-12);
    }
}

// Small rims and one that runs over most of the torus.
Soup torn_torus() {
    Soup soup = wavy_torus(40, 24);
    std::erase_if(soup.triangles, [&](const Triangle& t) { return t[0] % 97 == 0 || t[0] % 24 < 5; });
    return soup;
}

TEST(WindingNumber, EnclosesWhereTheNumberIsAboveOneHalf) {
    for (const Soup& soup : {wavy_torus(40, 24), torn_torus()}) {
        const WindingNumber winding(soup.positions, soup.triangles);
        int enclosed = 0;
        for (const Vec3 p : points_around(17, 3000)) {
            EXPECT_EQ(winding.encloses(p), std::fabs(winding.at(p)) > 0.5 + 1e-9);
            enclosed += winding.encloses(p);
        }
        EXPECT_GT(enclosed, 50);
    }
}

TEST(WindingNumber, OfAnOpenSurfaceIsAsNearAsAskedFor) {
    const Soup soup = torn_torus();
    const WindingNumber winding(soup.positions, soup.triangles);
    for (const double tolerance : {0.2, 0.01, 1e-4}) {
        for (const Vec3 p : points_around(19, 500)) EXPECT_NEAR(winding.at(p, tolerance), winding.at(p), tolerance);
    }
}

TEST(WindingNumber, OfADiscIsKnown) {
    // Seen from height h over the middle of a disc of radius 1: (1 - h / sqrt(1 + h^2)) / 2 of the sphere.
    Soup disc;
    const int count = 4000;
    disc.positions.push_back({0, 0, 0});
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        disc.positions.push_back({std::cos(angle), std::sin(angle), 0});
        disc.triangles.push_back({0, static_cast<Index>(i + 1), static_cast<Index>((i + 1) % count + 1)});
    }
    const WindingNumber winding(disc.positions, disc.triangles);
    for (const double h : {0.1, 1.0, 5.0}) EXPECT_NEAR(winding.at({0, 0, -h}), (1 - h / std::hypot(1, h)) / 2, 1e-6);
    EXPECT_NEAR(winding.at({0, 0, 1}), -winding.at({0, 0, -1}), 1e-12);
}

TEST(WindingNumber, KnowsExactlyWhatLiesOnTheSurface) {
    const Shell box = shapes::without_triangle(shapes::subdivided_box(2, {0, 0, 0}, {2, 2, 2}), 0);
    const WindingNumber winding(box.positions, box.triangles);
    EXPECT_TRUE(winding.is_on_surface({1, 1, 2}));
    EXPECT_TRUE(winding.is_on_surface({2, 0.25, 1.5}));
    EXPECT_FALSE(winding.is_on_surface({2, 0.25, std::nextafter(2.0, 3.0)}));
    EXPECT_FALSE(winding.is_on_surface({1, 1, 1}));
    const auto [a, b, c] = shapes::subdivided_box(2, {0, 0, 0}, {2, 2, 2}).triangles[0];
    const Vec3 in_the_hole = (box.positions[a] * 2.0 + box.positions[b] + box.positions[c]) * 0.25;
    EXPECT_FALSE(winding.is_on_surface(in_the_hole));
}

}
}
