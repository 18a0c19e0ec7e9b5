// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/compare.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/small_work.h"
#include "pipeline/work_file.h"

using crumple::pipeline::compare_images;
using crumple::pipeline::work_image;
using crumple::pipeline::Workspace;

TEST(Compare, AFileEqualsItself) {
    const auto image = work_image(small_work::cooked(), {});
    const auto report = compare_images(image, "a", image, "b");
    EXPECT_TRUE(report.is_equal);
    EXPECT_GT(report.compared, 20u);
    EXPECT_EQ(report.first, "");
    EXPECT_NE(compare_text(report).find("equal"), std::string::npos);
}

TEST(Compare, TheBundleComesFirstAndTheLargestIsNamed) {
    Workspace work = small_work::cooked();
    const auto before = work_image(work, {});
    work.asset->shell.components[0].volume += 100;
    work.bundle->stiffness_scale[1] = 3;
    const auto report = compare_images(before, "a", work_image(work, {}), "b");
    EXPECT_FALSE(report.is_equal);
    EXPECT_EQ(report.first, "/bundle/stiffness_scale");
    EXPECT_EQ(report.largest, "/asset/shell/components/volume");
    EXPECT_DOUBLE_EQ(report.largest_size, 100);
    EXPECT_EQ(report.differing[0].first_row, 1u);
}

TEST(Compare, ADamagedFileIsRefused) {
    auto image = work_image(small_work::imported(), {});
    auto damaged = image;
    damaged[damaged.size() / 2] ^= std::byte{1};
    EXPECT_THROW((void)compare_images(image, "a", damaged, "b"), crumple::Error);
}
