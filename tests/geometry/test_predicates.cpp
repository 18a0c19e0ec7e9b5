// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/predicates.h"

#include <CGAL/MP_Float.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/random.h"
#include "geometry/exact_predicates.h"

namespace crumple {
namespace {

// MP_Float knows no bounds on exponents, so it is the truth for every finite double.
using Oracle = CGAL::Simple_cartesian<CGAL::MP_Float>;

Oracle::Point_3 to_oracle(Vec3 p) { return {p.x, p.y, p.z}; }

int oracle_orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    return CGAL::orientation(to_oracle(a), to_oracle(b), to_oracle(c), to_oracle(d));
}

int oracle_in_sphere(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 e) {
    return CGAL::side_of_oriented_sphere(to_oracle(a), to_oracle(b), to_oracle(c), to_oracle(d), to_oracle(e));
}

void expect_true_signs(const std::vector<Vec3>& p) {
    EXPECT_EQ(orient3d(p[0], p[1], p[2], p[3]), oracle_orient3d(p[0], p[1], p[2], p[3]));
    EXPECT_EQ(exact::orient3d(p[0], p[1], p[2], p[3]), oracle_orient3d(p[0], p[1], p[2], p[3]));
    EXPECT_EQ(in_sphere(p[0], p[1], p[2], p[3], p[4]), oracle_in_sphere(p[0], p[1], p[2], p[3], p[4]));
    EXPECT_EQ(exact::in_sphere(p[0], p[1], p[2], p[3], p[4]), oracle_in_sphere(p[0], p[1], p[2], p[3], p[4]));
}

double signed_unit(Rng& rng) { return 2 * rng.next_unit() - 1; }

// Mantissas of 53 random bits at 2^low..2^high.
double any_double(Rng& rng, int low, int high) {
    const double mantissa = signed_unit(rng) + signed_unit(rng) * 0x1p-32;
    return std::ldexp(mantissa, low + static_cast<int>(rng.next_below(static_cast<std::uint32_t>(high - low + 1))));
}

TEST(Predicates, AnswerZeroForEqualPoints) {
    const Vec3 p{0.1, 0.2, 0.3};
    EXPECT_EQ(orient3d(p, p, p, p), 0);
    EXPECT_EQ(in_sphere(p, p, p, p, p), 0);
}

TEST(Predicates, OrientTheUnitTetPositively) {
    const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
    EXPECT_EQ(orient3d(a, b, c, d), 1);
    EXPECT_EQ(orient3d(b, a, c, d), -1);
    EXPECT_EQ(in_sphere(a, b, c, d, {0.25, 0.25, 0.25}), 1);
    EXPECT_EQ(in_sphere(a, b, c, d, {1, 1, 1}), 0);
    EXPECT_EQ(in_sphere(a, b, c, d, {1, 1, std::nextafter(1.0, 2.0)}), -1);
    EXPECT_EQ(in_sphere(a, b, c, d, {1, 1, std::nextafter(1.0, 0.0)}), 1);
}

TEST(Predicates, TreatNegativeZeroAsZero) {
    EXPECT_EQ(orient3d({-0.0, 0, 0}, {1, -0.0, 0}, {0, 1, -0.0}, {0.3, 0.3, 0.0}), 0);
}

TEST(Predicates, SeeOneUnitInTheLastPlaceBesideAPlane) {
    // Points of the plane x + y + z = 1.5 with short mantissas, then d nudged.
    const Vec3 a{0.5, 0.5, 0.5}, b{0.25, 0.75, 0.5}, c{1.25, 0.125, 0.125};
    const Vec3 on{0.375, 0.625, 0.5};
    EXPECT_EQ(orient3d(a, b, c, on), 0);
    Vec3 above = on, below = on;
    above.z = std::nextafter(on.z, 1.0);
    below.z = std::nextafter(on.z, 0.0);
    EXPECT_EQ(orient3d(a, b, c, above), -orient3d(a, b, c, below));
    EXPECT_NE(orient3d(a, b, c, above), 0);
}

TEST(Predicates, HoldAtTheEndsOfTheDoubleRange) {
    const double denormal = std::numeric_limits<double>::denorm_min();
    const double huge = std::numeric_limits<double>::max();
    for (const double s : {denormal, 1e-300, 1e-160, 1e-60, 1.0, 1e60, 1e100, 1e150, 1e300, huge}) {
        SCOPED_TRACE(s);
        expect_true_signs({{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}, {s, s, s}});
        expect_true_signs({{-s, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, -s, s}, {0, 0, -s}});
        expect_true_signs({{-s, -s, 0}, {s, s, 0}, {0, 0, 0}, {0, -s, s}, {s, 0, -s}});
    }
    expect_true_signs(
        {{-huge, -huge, -huge}, {huge, denormal, 0}, {0, huge, denormal}, {1, 1, huge}, {denormal, 0, 1}});
}

TEST(Predicates, AgreeWithMultiprecisionOnMixedMagnitudes) {
    Rng rng(7);
    for (const auto& [low, high] : {std::pair{-10, 10}, {-60, 60}, {-300, 70}, {-1074, 1000}, {-1074, -1040}}) {
        for (int round = 0; round < 60; ++round) {
            std::vector<Vec3> p(5);
            for (Vec3& q : p) q = {any_double(rng, low, high), any_double(rng, low, high), any_double(rng, low, high)};
            SCOPED_TRACE(round);
            expect_true_signs(p);
        }
    }
}

TEST(Predicates, AgreeWithMultiprecisionNearDegeneracy) {
    Rng rng(11);
    for (int round = 0; round < 400; ++round) {
        // Points of a small grid are often coplanar or cospherical; a nudge of one ulp makes the sign tiny.
        std::vector<Vec3> p(5);
        const double step = round % 2 == 0 ? 1.0 : 0.1;
        for (Vec3& q : p) {
            for (int axis = 0; axis < 3; ++axis) q[axis] = step * rng.next_below(3);
        }
        if (round % 4 >= 2) p[rng.next_below(5)].x *= 1 + 0x1p-52;
        SCOPED_TRACE(round);
        expect_true_signs(p);
    }
}

TEST(Predicates, AnswerTheSameWhenToldTheGrain) {
    Rng rng(12);
    for (const double grain : {1.0, 0x1p-20, 0x1p-150}) {
        for (const std::uint32_t range : {3u, 500u, 600u, 70000u, 4000000u}) {
            for (int round = 0; round < 40; ++round) {
                std::vector<Vec3> p(5);
                for (Vec3& q : p) {
                    for (int axis = 0; axis < 3; ++axis) q[axis] = grain * rng.next_below(range);
                }
                if (round % 2 == 0) p[3] = p[0] + p[1] - p[2];  // coplanar
                EXPECT_EQ(orient3d(p[0], p[1], p[2], p[3], grain), oracle_orient3d(p[0], p[1], p[2], p[3]));
                EXPECT_EQ(in_sphere(p[0], p[1], p[2], p[3], p[4], grain),
                          oracle_in_sphere(p[0], p[1], p[2], p[3], p[4]));
            }
        }
    }
}

TEST(Predicates, KnowCollinearPoints) {
    EXPECT_TRUE(are_collinear({1, 2, 3}, {1, 2, 3}, {4, 5, 6}));
    EXPECT_TRUE(are_collinear({0, 0, 0}, {1e-300, 2e-300, 0}, {1e300, 2e300, 0}));
    EXPECT_FALSE(are_collinear({0, 0, 0}, {1, 1, 1}, {2, 2, std::nextafter(2.0, 3.0)}));
    EXPECT_TRUE(are_collinear({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.7, 0.7, 0.7}));
}

TEST(Predicates, AgreeWithMultiprecisionFarFromTheOrigin) {
    Rng rng(13);
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec3> p(5);
        for (Vec3& q : p) q = {1e15 + rng.next_below(4), 1e15 + 0.5 * rng.next_below(4), 1e-12 * rng.next_unit()};
        SCOPED_TRACE(round);
        expect_true_signs(p);
    }
}

TEST(Predicates, ChangeSignWhenTwoPointsSwap) {
    Rng rng(17);
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec3> p(5);
        for (Vec3& q : p) q = {signed_unit(rng), signed_unit(rng), 1e-17 * signed_unit(rng)};
        EXPECT_EQ(orient3d(p[0], p[1], p[2], p[3]), -orient3d(p[1], p[0], p[2], p[3]));
        EXPECT_EQ(orient3d(p[0], p[1], p[2], p[3]), -orient3d(p[0], p[1], p[3], p[2]));
        EXPECT_EQ(in_sphere(p[0], p[1], p[2], p[3], p[4]), -in_sphere(p[0], p[2], p[1], p[3], p[4]));
    }
}

}
}
