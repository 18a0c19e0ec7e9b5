// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "solver/body.h"
#include "solver/spline.h"

namespace crumple::solver::test {
namespace {

struct Curve {
    Curve(SplineKind kind, std::vector<float> t, const std::function<Vec3f(float)>& at)
        : times(std::move(t)), values(times.size()), slopes(times.size()), scratch(times.size()) {
        for (std::size_t i = 0; i < times.size(); ++i) values[i] = at(times[i]);
        find_slopes(kind, times, values, slopes, scratch);
    }
    [[nodiscard]] Spline spline() const { return {times, values, slopes}; }
    [[nodiscard]] Vec3f at(float t) const { return value_at(spline(), t); }

    std::vector<float> times;
    std::vector<Vec3f> values;
    std::vector<Vec3f> slopes;
    std::vector<float> scratch;
};

constexpr SplineKind kinds[] = {SplineKind::catmull_rom, SplineKind::natural_cubic};
const std::vector<float> uneven{0, 0.5f, 0.7f, 1.4f, 2, 3};

Vec3f wave(float t) { return {std::sin(3 * t), t * t, std::cos(5 * t)}; }

// Of the second derivative, by differences of doubles inside one span.
double bend(const Curve& curve, float t) {
    const double h = 0.02;
    const auto at = [&](double s) { return static_cast<double>(curve.at(static_cast<float>(s)).x); };
    return (at(t + h) - 2 * at(t) + at(t - h)) / (h * h);
}

}

TEST(Spline, NoKeyOneKeyAndTwoKeysWork) {
    for (const SplineKind kind : kinds) {
        EXPECT_EQ(value_at({}, 1), Vec3f{});
        EXPECT_EQ(Curve(kind, {1}, wave).at(5), wave(1));
        const Curve line(kind, {1, 3}, [](float t) { return Vec3f{t, 0, 0}; });
        EXPECT_FLOAT_EQ(line.at(1.5f).x, 1.5f);
    }
}

TEST(Spline, PassesThroughItsKeysAndStandsStillOutside) {
    for (const SplineKind kind : kinds) {
        const Curve curve(kind, uneven, wave);
        for (const float t : uneven) EXPECT_LT(length(curve.at(t) - wave(t)), 1e-6f);
        EXPECT_EQ(curve.at(-1), wave(0));
        EXPECT_EQ(curve.at(9), wave(3));
        for (const float t : uneven) EXPECT_LT(length(curve.at(t + 1e-4f) - curve.at(t - 1e-4f)), 2e-3f);
    }
}

TEST(Spline, StraightMotionStaysStraight) {
    for (const SplineKind kind : kinds) {
        const Curve line(kind, uneven, [](float t) { return Vec3f{2 * t, 1 - t, 3}; });
        for (float t = 0; t < 3; t += 0.1f) EXPECT_LT(length(line.at(t) - Vec3f{2 * t, 1 - t, 3}), 1e-5f);
    }
}

// Its slopes are those of the parabola through three keys, so between inner keys a parabola comes back.
TEST(Spline, CatmullRomKeepsAParabola) {
    const Curve curve(SplineKind::catmull_rom, uneven, [](float t) { return Vec3f{t * t, 0, 0}; });
    for (float t = 0.5f; t < 2; t += 0.05f) EXPECT_NEAR(curve.at(t).x, t * t, 1e-5);
}

TEST(Spline, CatmullRomIsLocal) {
    const Curve a(SplineKind::catmull_rom, uneven, wave);
    const Curve b(SplineKind::catmull_rom, uneven, [](float t) { return t == 3 ? Vec3f{9, 9, 9} : wave(t); });
    EXPECT_EQ(a.at(1), b.at(1));
    EXPECT_FALSE(a.at(2.5f) == b.at(2.5f));
}

TEST(Spline, NaturalCubicBendsContinuouslyAndNotAtItsEnds) {
    const Curve curve(SplineKind::natural_cubic, uneven, wave);
    for (const float t : {0.5f, 0.7f, 1.4f, 2.0f}) {
        // At t -+ h both differences lie inside one span; the bend is linear there.
        const double before = 2 * bend(curve, t - 0.03f) - bend(curve, t - 0.06f);
        const double after = 2 * bend(curve, t + 0.03f) - bend(curve, t + 0.06f);
        EXPECT_NEAR(before, after, 0.05 * (1 + std::abs(before))) << t;
    }
    EXPECT_NEAR(2 * bend(curve, 0.03f) - bend(curve, 0.06f), 0, 0.1);
}

TEST(Handle, ItsNodesAreWhereTheKeysSay) {
    Body body(grid_body({4, 2, 2}, {0.25f, 0.25f, 0.25f}, elastic_material(1e5), [](Vec3f p) { return p.x == 0; }));
    std::vector<Index> end;
    for (Index n = 0; n < body.node_count(); ++n) {
        if (body.rest(n).x == 1) end.push_back(n);
    }
    const Curve shift(SplineKind::natural_cubic, {0, 0.5f, 1}, [](float t) {
        return Vec3f{0.2f * t, 0.3f * t * t, 0};
    });
    const Curve turned(SplineKind::catmull_rom, {0, 1}, [](float t) { return Vec3f{1.57079633f * t, 0, 0}; });
    const Handle handle{end, {1, 0.25f, 0.25f}, shift.spline(), turned.spline()};
    std::vector<Constraint> room(body.node_count());
    for (int i = 0; i < 60; ++i) {
        StepInput input;
        const float time = static_cast<float>(i) * input.dt;
        const std::size_t count = drive(body.model, body.state, handle, time, input.dt, room);
        ASSERT_EQ(count, end.size());
        input.constraints = std::span(room).first(count);
        body.step(input);
    }
    for (const Index n : end) {
        // A quarter turn about x: (y, z) -> (-z, y) about the pivot.
        const Vec3f from = body.rest(n) - handle.pivot;
        const Vec3f expected = handle.pivot + Vec3f{from.x + 0.2f, -from.z + 0.3f, from.y};
        EXPECT_LT(length(body.x(n) - expected), 1e-4f);
    }
    EXPECT_GT(body.smallest_determinant(), 0.1);
}

TEST(Handle, DrivesLockedNodesToo) {
    Body body(grid_body({4, 1, 1}, {0.25f, 0.25f, 0.25f}, elastic_material(1e5), [](Vec3f p) { return p.x == 0; }));
    const std::vector<Index> locked{0, 1, 2, 3};
    const Curve shift(SplineKind::catmull_rom, {0, 1}, [](float t) { return Vec3f{0, t, 0}; });
    Constraint room[4];
    StepInput input;
    input.constraints =
        std::span(room).first(drive(body.model, body.state, {locked, {}, shift.spline(), {}}, 0.2f, input.dt, room));
    body.step(input);
    EXPECT_NEAR(body.x(0).y, 0.2f + input.dt, 1e-6);
}

}
