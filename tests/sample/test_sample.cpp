// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "core/error.h"
#include "mesh/shapes.h"
#include "mesh/shell_interior.h"
#include "sample/element_size.h"

using namespace crumple;
using namespace crumple::sample;

namespace {

std::vector<Vec3> interior_of(const Result& result) {
    return {result.points.positions.begin() + result.points.shell_vertex_count, result.points.positions.end()};
}

bool has_finding(const Report& report, const std::string& code) {
    return std::any_of(report.findings.begin(), report.findings.end(),
                       [&](const Finding& f) { return f.code == code; });
}

Result sample_count(const Shell& shell, std::string count, Method method = Method::poisson) {
    Params params;
    params.points = std::move(count);
    params.method = method;
    return sample_interior(shell, params);
}

void expect_distinct_floats(const std::vector<Vec3>& points) {
    for (const Vec3 p : points) EXPECT_EQ(round_to_float(p), p);
    std::vector<Vec3> sorted = points;
    std::sort(sorted.begin(), sorted.end(), lexicographic_less<double>);
    EXPECT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end());
}

TEST(Sample, AnEmptyShellGivesNoPointsAndSaysSo) {
    for (const char* count : {"auto", "100", "tets:1000"}) {
        const Result result = sample_count({}, count);
        EXPECT_TRUE(result.points.positions.empty());
        EXPECT_EQ(result.report.points, 0u);
        EXPECT_FALSE(result.report.findings.empty());
    }
}

TEST(Sample, AShellWithoutVolumeEndsWithoutPoints) {
    Shell sheet = shapes::tetrahedron();
    sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
    sheet.component = {0, 0};
    for (const Method method : {Method::poisson, Method::uniform}) {
        const Result result = sample_count(sheet, "1000", method);
        EXPECT_EQ(result.report.points, 0u);
        EXPECT_TRUE(has_finding(result.report, "SAMPLE_FEWER_POINTS"));
    }
}

TEST(Sample, ASingleTriangleEndsWithoutPoints) {
    Shell open = shapes::tetrahedron();
    open.triangles.resize(1);
    open.component.resize(1);
    const Result result = sample_count(open, "auto");
    EXPECT_EQ(result.report.points, 0u);
    EXPECT_TRUE(has_finding(result.report, "SAMPLE_OPEN_SHELL"));
}

TEST(Sample, VerticesAtOnePlaceEndWithoutPoints) {
    Shell shell = shapes::tetrahedron();
    for (Vec3& p : shell.positions) p = {1, 2, 3};
    EXPECT_EQ(sample_count(shell, "100").report.points, 0u);
}

TEST(Sample, AThinPlateNeedsNoPointsAndSaysSo) {
    const Result result = sample_count(shapes::thin_plate(), "auto");
    EXPECT_EQ(result.report.points, 0u);
    EXPECT_EQ(result.report.automatic_count, 0u);
    EXPECT_TRUE(has_finding(result.report, "SAMPLE_NO_INTERIOR"));
}

TEST(Sample, AThinPlatesThicknessAndShareAreTold) {
    const Report report = sample_count(shapes::thin_plate(0.02, 6), "auto").report;
    EXPECT_FLOAT_EQ(static_cast<float>(report.thinnest), 0.02f);
    EXPECT_EQ(report.thin_triangles, 2u * 2 * 6 * 6) << "both sides, not the rim";
    EXPECT_NEAR(report.thin_share, 2 / (2 + 4 * 0.02), 1e-6);
    const Report thick = sample_count(shapes::subdivided_box(4), "auto").report;
    EXPECT_EQ(thick.thin_triangles, 0u);
    EXPECT_EQ(thick.thin_share, 0);
    EXPECT_EQ(thick.thinnest, 0);
}

// The mean edge of the plate's triangles is (2 + sqrt 2) / 18: a tenth of that is 0.01897.
TEST(Sample, AThinPartIsAWarningBelowATenthOfItsEdges) {
    const auto severity = [](double thickness) {
        const Report report = sample_count(shapes::thin_plate(thickness, 6), "auto").report;
        const auto thin = std::find_if(report.findings.begin(), report.findings.end(),
                                       [](const Finding& f) { return f.code == "SAMPLE_THIN"; });
        EXPECT_NE(thin, report.findings.end());
        EXPECT_EQ(thin->count, report.thin_triangles);
        EXPECT_EQ(thin->places.size(), max_places);
        return thin->severity;
    };
    EXPECT_EQ(severity(0.0191), Severity::info);
    EXPECT_EQ(severity(0.0188), Severity::warning);
}

TEST(Sample, AskingAThinPlateForPointsEndsSoonAndSaysSo) {
    for (const Method method : {Method::poisson, Method::uniform}) {
        const Result result = sample_count(shapes::thin_plate(), "50000", method);
        EXPECT_LT(result.report.points, 50'000u);
        EXPECT_LT(result.report.tries, 1'000'000u);
        EXPECT_TRUE(has_finding(result.report, "SAMPLE_FEWER_POINTS"));
    }
}

TEST(Sample, LowerClearanceLetsPointsIntoAThinPlate) {
    Params params;
    params.points = "50";
    params.clearance = 0.01;
    const Shell plate = shapes::thin_plate(0.05);
    const Result result = sample_interior(plate, params);
    EXPECT_EQ(result.report.points, 50u);
    for (const Vec3 p : interior_of(result)) {
        EXPECT_GT(p.y, 0);
        EXPECT_LT(p.y, 0.05);
    }
}

TEST(Sample, ZeroPointsCanBeAskedFor) {
    const Shell box = shapes::subdivided_box(4);
    const Result result = sample_count(box, "0");
    EXPECT_EQ(result.points.positions, box.positions);
    EXPECT_GT(result.report.automatic_count, 0u);
    EXPECT_TRUE(result.report.findings.empty());
}

TEST(Sample, ABadCountIsAUsageError) { EXPECT_THROW((void)sample_count(shapes::box(), "many"), Error); }

TEST(Sample, ShellVerticesComeFirstAndUnchanged) {
    const Shell sphere = shapes::icosphere();
    const Result result = sample_count(sphere, "auto");
    ASSERT_EQ(result.points.shell_vertex_count, sphere.positions.size());
    EXPECT_TRUE(std::equal(sphere.positions.begin(), sphere.positions.end(), result.points.positions.begin()));
    EXPECT_EQ(result.report.points, result.points.positions.size() - sphere.positions.size());
    EXPECT_EQ(result.report.shell_vertices, sphere.positions.size());
}

TEST(Sample, PointsAreInsideFarEnoughDistinctAndFloat) {
    const Shell shell = shapes::torus(1, 0.4, 24, 12);
    const shapes::ElementSize size(shell);
    const ShellInterior interior(shell);
    for (const Method method : {Method::poisson, Method::uniform}) {
        const Result result = sample_count(shell, "300", method);
        const std::vector<Vec3> points = interior_of(result);
        EXPECT_EQ(points.size(), 300u);
        for (const Vec3 p : points) {
            EXPECT_NE(interior.material_at(p), none);
            EXPECT_GE(size.distance(p), 0.4 * size.at(p) * (1 - 1e-9));
        }
        expect_distinct_floats(points);
    }
}

TEST(Sample, TheAutomaticCountIsTheIntegralOverTheRoomyPart) {
    const Shell shell = shapes::subdivided_box(6, {0, 0, 0}, {2, 1, 1});
    const shapes::ElementSize size(shell);
    // Midpoint rule on a fine grid.
    double integral = 0;
    constexpr int cells = 24;
    constexpr double step = 1.0 / cells;
    for (int x = 0; x < 2 * cells; ++x) {
        for (int y = 0; y < cells; ++y) {
            for (int z = 0; z < cells; ++z) {
                const Vec3 p{(x + 0.5) * step, (y + 0.5) * step, (z + 0.5) * step};
                const double h = size.at(p);
                if (std::min({p.x, 2 - p.x, p.y, 1 - p.y, p.z, 1 - p.z}) > 0.35 * h)
                    integral += step * step * step / (0.7 * h * h * h);
            }
        }
    }
    const Report report = sample_count(shell, "auto").report;
    EXPECT_NEAR(static_cast<double>(report.automatic_count), integral, 0.06 * integral);
    EXPECT_EQ(report.points, report.automatic_count);
    EXPECT_EQ(report.wanted, report.automatic_count);
}

TEST(Sample, TargetTetsSetThePoints) {
    const Shell sphere = shapes::icosphere(1, 3);
    const Result result = sample_count(sphere, "tets:6000");
    EXPECT_NEAR(static_cast<double>(result.report.expected_tets), 6000, 6);
    EXPECT_EQ(result.report.points, result.report.wanted);
    EXPECT_GT(result.report.points, 100u);
}

TEST(Sample, FewerTetsThanTheShellGivesIsAFinding) {
    const Result result = sample_count(shapes::icosphere(1, 3), "tets:100");
    EXPECT_EQ(result.report.points, 0u);
    EXPECT_TRUE(has_finding(result.report, "SAMPLE_FEWER_TETS"));
}

TEST(Sample, NoPointLiesInACavityOrARigidPart) {
    for (const Role role : {Role::cavity, Role::rigid}) {
        Shell shell = shapes::nested_boxes(role);
        const Shell fine = shapes::subdivided_box(6, {0, 0, 0}, {3, 3, 3});
        Shell inner = shapes::subdivided_box(3, {1, 1, 1}, {2, 2, 2});
        shell = shapes::joined(fine, inner);
        shell.components[1].role = role;
        const std::vector<Vec3> points = interior_of(sample_count(shell, "500"));
        EXPECT_EQ(points.size(), 500u);
        for (const Vec3 p : points) {
            const bool is_in_hole = p.x > 1 && p.x < 2 && p.y > 1 && p.y < 2 && p.z > 1 && p.z < 2;
            EXPECT_FALSE(is_in_hole);
        }
    }
}

TEST(Sample, APartLockedAsAWholeTakesNoPointsAPartlyLockedOneDoes) {
    Shell shell = shapes::joined(shapes::subdivided_box(5), shapes::subdivided_box(5, {2, 0, 0}, {3, 1, 1}));
    std::fill(shell.locked.begin() + static_cast<std::ptrdiff_t>(shell.locked.size() / 2), shell.locked.end(), 1);
    shell.locked[0] = 1;
    const std::vector<Vec3> points = interior_of(sample_count(shell, "auto"));
    EXPECT_GT(points.size(), 5u);
    for (const Vec3 p : points) EXPECT_LT(p.x, 1);
}

TEST(Sample, AShellLockedAsAWholeTakesNoPoints) {
    Shell shell = shapes::subdivided_box(5);
    std::fill(shell.locked.begin(), shell.locked.end(), 1);
    const Result result = sample_count(shell, "auto");
    EXPECT_EQ(result.report.points, 0u);
    EXPECT_TRUE(has_finding(result.report, "SAMPLE_NO_INTERIOR"));
}

TEST(Sample, AnOpenShellIsSampledWithAFinding) {
    const Shell shell = shapes::without_triangle(shapes::icosphere(1, 3));
    const Result result = sample_count(shell, "auto");
    EXPECT_GT(result.report.points, 50u);
    EXPECT_TRUE(has_finding(result.report, "SAMPLE_OPEN_SHELL"));
    const ShellInterior interior(shell);
    for (const Vec3 p : interior_of(result)) EXPECT_NE(interior.material_at(p), none);
}

TEST(Sample, AnInwardWoundShellIsStillSolid) {
    EXPECT_EQ(sample_count(shapes::inverted(shapes::icosphere(1, 3)), "200").report.points, 200u);
}

TEST(Sample, ScalingTheShellScalesThePointsExactly) {
    const Shell shell = shapes::torus();
    for (const Method method : {Method::poisson, Method::uniform}) {
        const std::vector<Vec3> points = interior_of(sample_count(shell, "200", method));
        // From micrometres to kilometres; powers of two round nothing.
        for (const double scale : {0x1p-20, 0x1p13}) {
            const std::vector<Vec3> scaled = interior_of(sample_count(shapes::moved(shell, {}, scale), "200", method));
            ASSERT_EQ(scaled.size(), points.size());
            for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(scaled[i], points[i] * scale);
        }
    }
}

TEST(Sample, FarFromTheOriginPointsStayInsideAndDistinct) {
    // Near 1e5 floats are 1/128 apart: a box of 1/4 has 32 of them an axis.
    const Shell shell = shapes::moved(shapes::subdivided_box(4), {1e5, -1e5, 1e5}, 0.25);
    const ShellInterior interior(shell);
    for (const Method method : {Method::poisson, Method::uniform}) {
        const std::vector<Vec3> points = interior_of(sample_count(shell, "2000", method));
        EXPECT_GT(points.size(), 100u);
        for (const Vec3 p : points) EXPECT_NE(interior.material_at(p), none);
        expect_distinct_floats(points);
    }
}

TEST(Sample, SamePointsForAnyNumberOfThreads) {
    const Shell shell = shapes::torus();
    for (const Method method : {Method::poisson, Method::uniform}) {
        Params params;
        params.points = "500";
        params.method = method;
        const Result alone = sample_interior(shell, params);
        for (const unsigned jobs : {2u, 8u}) {
            Context context;
            context.jobs = jobs;
            const Result together = sample_interior(shell, params, context);
            EXPECT_EQ(alone.points.positions, together.points.positions);
            EXPECT_EQ(alone.report.tries, together.report.tries);
        }
    }
}

TEST(Sample, AnotherSeedGivesOtherPoints) {
    const Shell shell = shapes::icosphere(1, 3);
    Params params;
    const Result one = sample_interior(shell, params);
    params.seed = 2;
    const Result two = sample_interior(shell, params);
    EXPECT_EQ(one.report.automatic_count, two.report.automatic_count);
    EXPECT_NE(one.points.positions, two.points.positions);
}

TEST(Sample, ACancelledRunStops) {
    std::atomic<bool> cancelled = true;
    Context context;
    context.cancelled = &cancelled;
    EXPECT_THROW((void)sample_interior(shapes::icosphere(1, 3), {}, context), Error);
}

struct Names {
    std::set<std::string> names;
    template <class T, class... Rest>
    void field(std::string_view name, T&, Rest...) {
        EXPECT_TRUE(names.insert(std::string(name)).second) << name;
    }
};

TEST(Sample, EveryFieldIsDescribedOnce) {
    Names params;
    Params p;
    describe(params, p);
    EXPECT_EQ(params.names.size(), 5u);
    Names report;
    Report r;
    describe(report, r);
    EXPECT_EQ(report.names.size(), 16u);
}

}
