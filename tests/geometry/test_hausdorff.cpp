// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/hausdorff.h"

#include <gtest/gtest.h>

#include "mesh/shapes.h"

namespace crumple {
namespace {

Farthest stray(const Shell& from, const Shell& to, const std::function<bool(const SurfaceSample&)>& counts = {}) {
    return farthest_sample(sample_surface(from.positions, from.triangles, 2000),
                           SurfaceDistance(to.positions, to.triangles), counts);
}

TEST(SurfaceDistance, OfNothingIsInfinite) {
    const SurfaceDistance surface({}, {});
    EXPECT_EQ(surface.closest({0, 0, 0}).triangle, none);
    EXPECT_TRUE(std::isinf(surface.closest({0, 0, 0}).distance));
}

TEST(SurfaceDistance, IsTheSameForEveryGuess) {
    const Shell torus = shapes::torus();
    const SurfaceDistance surface(torus.positions, torus.triangles);
    for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{2, 1, 3}, torus.positions[5]}) {
        const auto plain = surface.closest(p);
        EXPECT_NEAR(length(plain.point - p), plain.distance, 1e-12);
        for (Index guess = 0; guess < torus.triangles.size(); guess += 17) {
            EXPECT_EQ(surface.closest(p, guess).triangle, plain.triangle);
        }
    }
}

TEST(Hausdorff, SamplesCoverEveryTriangleAndVertex) {
    const Shell sphere = shapes::icosphere(1, 2);
    const auto samples = sample_surface(sphere.positions, sphere.triangles, 0);
    EXPECT_EQ(samples.size(), sphere.positions.size() + sphere.triangles.size());
    EXPECT_NEAR(static_cast<double>(sample_surface(sphere.positions, sphere.triangles, 5000).size()), 5000, 1500);
}

TEST(Hausdorff, ASurfaceDoesNotStrayFromItself) {
    const Shell sphere = shapes::icosphere();
    EXPECT_LT(stray(sphere, sphere).distance, 1e-15);
}

TEST(Hausdorff, IsOneSided) {
    const Shell small = shapes::box({1, 1, 1}, {2, 2, 2});
    const Shell big = shapes::box({0, 0, 0}, {3, 3, 3});
    EXPECT_DOUBLE_EQ(stray(small, big).distance, 1);
    EXPECT_DOUBLE_EQ(stray(big, small).distance, std::sqrt(3.0));
}

TEST(Hausdorff, OnlySamplesThatCountAreReported) {
    const Shell small = shapes::box({1, 1, 1}, {2, 2, 2});
    const Shell big = shapes::box({0, 0, 0}, {3, 3, 3});
    const auto low = stray(big, small, [](const SurfaceSample& s) { return s.position.x == 0 && s.position.y < 2; });
    EXPECT_EQ(low.sample.position.x, 0);
    EXPECT_LT(low.sample.position.y, 2);
    EXPECT_EQ(stray(big, small, [](const SurfaceSample&) { return false; }).distance, 0);
}

TEST(Hausdorff, ThreadsDoNotChangeIt) {
    const Shell torus = shapes::torus(1, 0.4, 40, 20);
    const Shell sphere = shapes::icosphere(1.2, 3);
    const auto samples = sample_surface(torus.positions, torus.triangles, 3000);
    const SurfaceDistance surface(sphere.positions, sphere.triangles);
    Context four;
    four.jobs = 4;
    const Farthest a = farthest_sample(samples, surface, {});
    const Farthest b = farthest_sample(samples, surface, {}, four);
    EXPECT_EQ(a.distance, b.distance);
    EXPECT_EQ(a.sample.position, b.sample.position);
}

}
}
