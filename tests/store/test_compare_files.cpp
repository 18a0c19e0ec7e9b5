// SPDX-License-Identifier: MIT
#include "store/compare_files.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bundle/small_bundle.h"
#include "store/bundle_file.h"

using namespace crumple;
using namespace crumple::store;

namespace {

Comparison compare(const Bundle& a, const Bundle& b) {
    return compare_files(FileReader(to_image(a), "a"), FileReader(to_image(b, Layout::contiguous), "b"));
}

}

TEST(CompareFiles, TwoEmptyFilesAreEqual) {
    const Comparison comparison =
        compare_files(FileReader(FileWriter().finish(), "a"), FileReader(FileWriter().finish(), "b"), "/");
    EXPECT_EQ(comparison.compared, 0u);
    EXPECT_TRUE(comparison.differing.empty());
}

TEST(CompareFiles, LayoutMakesNoDifference) {
    const Comparison comparison = compare(test::small_bundle(), test::small_bundle());
    EXPECT_GT(comparison.compared, 40u);
    EXPECT_TRUE(comparison.differing.empty());
}

TEST(CompareFiles, NamesTheFirstDatasetAndTheLargestDifference) {
    const Bundle a = test::small_bundle();
    Bundle b = a;
    b.mass[2] += 0.5f;
    b.mass[7] += 2.0f;
    b.volume[1] = std::nanf("");
    b.regions[0] = "spire";
    const Comparison comparison = compare(a, b);
    ASSERT_EQ(comparison.differing.size(), 3u);
    const DatasetDifference& mass = comparison.differing[0];
    EXPECT_EQ(mass.path, "/bundle/mass");
    EXPECT_EQ(mass.elements, 2u);
    EXPECT_EQ(mass.first_row, 2u);
    EXPECT_EQ(mass.largest, 2.0);
    EXPECT_EQ(mass.largest_row, 7u);
    EXPECT_EQ(comparison.differing[1].first_value, "tower");
    EXPECT_EQ(comparison.differing[1].second_value, "spire");
    EXPECT_TRUE(std::isinf(comparison.differing[2].largest));
}

TEST(CompareFiles, TellsMissingDatasetsAndOtherShapes) {
    Bundle a = test::small_bundle(2);
    Bundle b = test::small_bundle(3);
    b.visuals[0].name = "rust";
    const Comparison comparison = compare(a, b);
    const auto kind_of = [&](const std::string& path) {
        for (const DatasetDifference& difference : comparison.differing) {
            if (difference.path == path) return std::string(name_of(difference.kind));
        }
        return std::string("equal");
    };
    EXPECT_EQ(kind_of("/bundle/tets"), "shape");
    EXPECT_EQ(kind_of("/bundle/visual/paint/tet"), "only_in_first");
    EXPECT_EQ(kind_of("/bundle/visual/rust/tet"), "only_in_second");
    EXPECT_EQ(kind_of("/bundle/materials/name"), "equal");
}
