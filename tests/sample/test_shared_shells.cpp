// SPDX-License-Identifier: GPL-3.0-or-later
// Automatic counts on shells whose counts were worked out independently when the rule was chosen.
#include <gtest/gtest.h>

#include "mesh/shell_interior.h"
#include "sample/element_size.h"
#include "sample/read_obj_shell.h"
#include "sample/sample.h"

using namespace crumple;
using namespace crumple::sample;

namespace {

struct Expected {
    const char* file;
    double count;
    double tolerance;
};

class SharedShell : public testing::TestWithParam<Expected> {};

TEST_P(SharedShell, HasTheAutomaticCountOfTheStudyAndAllPointsInside) {
    CRUMPLE_NEEDS_DATA();
    const auto shell = shapes::read_obj_shell(test::data_folder() / "quality" / GetParam().file);
    ASSERT_TRUE(shell);
    const Result result = sample_interior(*shell);
    EXPECT_NEAR(static_cast<double>(result.report.automatic_count), GetParam().count, GetParam().tolerance);
    EXPECT_EQ(result.report.points, result.report.automatic_count);
    const shapes::ElementSize size(*shell);
    const ShellInterior interior(*shell);
    for (std::size_t i = shell->positions.size(); i < result.points.positions.size(); ++i) {
        const Vec3 p = result.points.positions[i];
        EXPECT_NE(interior.material_at(p), none);
        EXPECT_GE(size.distance(p), 0.4 * size.at(p) * (1 - 1e-9));
    }
}

// The study integrated by random points: some percent of the larger counts.
INSTANTIATE_TEST_SUITE_P(Quality, SharedShell,
                         testing::Values(Expected{"spot.obj", 370, 20}, Expected{"carbody.obj", 34, 6},
                                         Expected{"bonnet.obj", 0, 0}),
                         [](const auto& parameter) {
                             const std::string file = parameter.param.file;
                             return file.substr(0, file.find('.'));
                         });

}
