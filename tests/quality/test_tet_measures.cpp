// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/tet_measures.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/index.h"
#include "core/random.h"

using namespace crumple;
using namespace crumple::quality;

namespace {

using Corners = std::array<Vec3, 4>;

constexpr double regular_angle_deg = 70.528779365509308;  // acos(1 / 3)

// Corners of a cube of edge 1.
constexpr Corners regular{{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}};
constexpr Corners unit_corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

TetMeasures measure(const Corners& c) { return measure_tet(c[0], c[1], c[2], c[3]); }

Corners random_tet(Rng& rng) {
    Corners c;
    for (Vec3& p : c) p = {rng.next_unit(), rng.next_unit(), rng.next_unit()};
    if (dot(c[1] - c[0], cross(c[2] - c[0], c[3] - c[0])) < 0) std::swap(c[0], c[1]);
    return c;
}

// The angle at an edge by projecting the two other corners along it.
double angle_deg(Vec3 from, Vec3 to, Vec3 p, Vec3 q) {
    const Vec3 along = (to - from) / length(to - from);
    const Vec3 u = (p - from) - along * dot(p - from, along);
    const Vec3 v = (q - from) - along * dot(q - from, along);
    return std::atan2(length(cross(u, v)), dot(u, v)) * 180 / std::numbers::pi;
}

TEST(TetMeasures, AFlatTetIsAsBadAsCanBe) {
    const TetMeasures flat = measure_tet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0});
    EXPECT_EQ(flat.volume, 0);
    EXPECT_EQ(flat.min_dihedral, key_of_0_deg);
    EXPECT_EQ(flat.max_dihedral, key_of_180_deg);
    EXPECT_EQ(flat.radius_ratio, 0);
    EXPECT_EQ(flat.volume_lrms3, 0);
}

TEST(TetMeasures, FourEqualCornersAreMeasuredWithoutNan) {
    const TetMeasures point = measure_tet({1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3});
    EXPECT_EQ(point.volume, 0);
    EXPECT_EQ(point.min_dihedral, key_of_0_deg);
    EXPECT_EQ(point.longest_edge_2, 0);
}

TEST(TetMeasures, AnInvertedTetHasNegativeVolumeAndNoShape) {
    const TetMeasures inverted = measure({unit_corner[1], unit_corner[0], unit_corner[2], unit_corner[3]});
    EXPECT_DOUBLE_EQ(inverted.volume, -1.0 / 6);
    EXPECT_EQ(inverted.min_dihedral, key_of_0_deg);
    EXPECT_EQ(inverted.radius_ratio, 0);
}

TEST(TetMeasures, ARegularTetIsPerfect) {
    const TetMeasures shape = measure(regular);
    EXPECT_DOUBLE_EQ(shape.volume, 1.0 / 3);
    EXPECT_NEAR(degrees_of(shape.min_dihedral), regular_angle_deg, 1e-12);
    EXPECT_NEAR(degrees_of(shape.max_dihedral), regular_angle_deg, 1e-12);
    EXPECT_NEAR(shape.radius_ratio, 1, 1e-14);
    EXPECT_NEAR(shape.volume_lrms3, 1, 1e-14);
    EXPECT_DOUBLE_EQ(shape.shortest_edge_2, 2);
    EXPECT_DOUBLE_EQ(shape.longest_edge_2, 2);
}

TEST(TetMeasures, TheCornerOfACubeHasKnownAnglesAndRadii) {
    const TetMeasures shape = measure(unit_corner);
    EXPECT_NEAR(degrees_of(shape.max_dihedral), 90, 1e-12);
    EXPECT_NEAR(degrees_of(shape.min_dihedral), std::acos(1 / std::sqrt(3.0)) * 180 / std::numbers::pi, 1e-12);
    // r = 3 V / area = 1 / (3 + sqrt 3), R = sqrt(3) / 2.
    EXPECT_NEAR(shape.radius_ratio, 3 / (3 + std::sqrt(3.0)) / (std::sqrt(3.0) / 2), 1e-14);
    // lrms^2 = (3 * 1 + 3 * 2) / 6 = 1.5.
    EXPECT_NEAR(shape.volume_lrms3, std::sqrt(2.0) / std::pow(1.5, 1.5), 1e-14);
    EXPECT_DOUBLE_EQ(shape.shortest_edge_2, 1);
    EXPECT_DOUBLE_EQ(shape.longest_edge_2, 2);
}

TEST(TetMeasures, AnglesAgreeWithProjectionAlongTheEdges) {
    Rng rng(11);
    for (int i = 0; i < 500; ++i) {
        const Corners c = random_tet(rng);
        double least = 180;
        double largest = 0;
        for (int edge = 0; edge < 6; ++edge) {
            const auto at = [&](int e, int end) { return c[static_cast<std::size_t>(tet_edge_corners[e][end])]; };
            const double angle = angle_deg(at(edge, 0), at(edge, 1), at(5 - edge, 0), at(5 - edge, 1));
            least = std::min(least, angle);
            largest = std::max(largest, angle);
        }
        const TetMeasures shape = measure(c);
        // Near a right angle the arcsine loses half the digits.
        EXPECT_NEAR(degrees_of(shape.min_dihedral), least, 1e-5) << i;
        EXPECT_NEAR(degrees_of(shape.max_dihedral), largest, 1e-5) << i;
        EXPECT_EQ(min_dihedral_key(c[0], c[1], c[2], c[3]), shape.min_dihedral);
    }
}

TEST(TetMeasures, TinyAnglesKeepTheirDigits) {
    // Two opposite edges of length 1 crossing at a height: the angles at them are nearly 0 or 180 degrees.
    for (const double height : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const TetMeasures sliver = measure_tet({-0.5, 0, 0}, {0.5, 0, 0}, {0, 0.5, height}, {0, -0.5, height});
        ASSERT_GT(sliver.volume, 0);
        // sin a = 3 V l / (2 A B) at the four side edges: V = height / 6, l^2 = 1/2 + height^2, A = B = 1/4 nearly.
        EXPECT_NEAR(degrees_of(sliver.max_dihedral) / 180, 1, 2 * height);
        EXPECT_GT(sliver.min_dihedral, 0);
        EXPECT_NEAR(std::sqrt(sliver.min_dihedral) / height, std::sqrt(8.0), 1e-5 + 10 * height);
    }
}

TEST(TetMeasures, ScaleChangesNothingButSizes) {
    Rng rng(12);
    const Corners c = random_tet(rng);
    const TetMeasures shape = measure(c);
    for (const double scale : {0x1p-40, 0x1p-20, 0x1p13, 0x1p40}) {
        const TetMeasures scaled = measure({c[0] * scale, c[1] * scale, c[2] * scale, c[3] * scale});
        // Powers of two only shift exponents.
        EXPECT_EQ(scaled.min_dihedral, shape.min_dihedral);
        EXPECT_EQ(scaled.max_dihedral, shape.max_dihedral);
        EXPECT_DOUBLE_EQ(scaled.radius_ratio, shape.radius_ratio);
        EXPECT_DOUBLE_EQ(scaled.volume_lrms3, shape.volume_lrms3);
        EXPECT_DOUBLE_EQ(scaled.volume, shape.volume * scale * scale * scale);
    }
}

TEST(TetMeasures, EvenRenamingsOfCornersAgree) {
    Rng rng(13);
    for (int i = 0; i < 100; ++i) {
        const Corners c = random_tet(rng);
        const TetMeasures one = measure(c);
        const TetMeasures other = measure({c[1], c[2], c[0], c[3]});
        EXPECT_NEAR(one.min_dihedral, other.min_dihedral, 1e-12);
        EXPECT_NEAR(one.radius_ratio, other.radius_ratio, 1e-12);
    }
}

TEST(AngleKey, GrowsWithTheAngleThroughTheRightAngle) {
    double last = -1;
    for (const double angle : {0.0, 1e-6, 0.1, 9.99, 10.0, 45.0, 89.9, 90.0, 90.1, 135.0, 179.9, 180.0}) {
        const double sine = std::sin(angle * std::numbers::pi / 180);
        const AngleKey key = angle <= 90 ? sine * sine : 2 - sine * sine;
        EXPECT_GT(key, last);
        EXPECT_NEAR(degrees_of(key), angle, 1e-6);
        last = key;
    }
}

TEST(AngleKey, TheConstantForTenDegreesIsItsSineSquared) {
    const double sine = std::sin(std::numbers::pi / 18);
    EXPECT_DOUBLE_EQ(key_of_10_deg, sine * sine);
    EXPECT_NEAR(degrees_of(key_of_10_deg), 10, 1e-13);
}

}
