// SPDX-License-Identifier: MIT
#include "store/check_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bundle/small_bundle.h"
#include "store/bundle_file.h"
#include "store/seal.h"

using namespace crumple;
using namespace crumple::store;

namespace {

std::vector<std::string> codes_of(const CheckedFile& checked) {
    std::vector<std::string> codes;
    for (const Finding& finding : checked.findings) codes.push_back(finding.code);
    return codes;
}

}

TEST(CheckFile, NothingIsNoFile) {
    EXPECT_EQ(codes_of(check_file({}, "none")), std::vector<std::string>{"FILE_UNREADABLE"});
}

TEST(CheckFile, AGoodBundleHasNoFindings) {
    const CheckedFile checked = check_file(to_image(test::small_bundle()), "good");
    EXPECT_TRUE(checked.findings.empty());
    EXPECT_TRUE(checked.bundle.has_value());
    EXPECT_EQ(checked.digest.size(), 64u);
}

TEST(CheckFile, AFileWithoutABundleIsCheckedByItsDigests) {
    FileWriter writer;
    writer.write_value("/points/count", 3.0);
    const CheckedFile checked = check_file(writer.finish(), "work");
    EXPECT_TRUE(checked.findings.empty());
    EXPECT_FALSE(checked.bundle.has_value());
}

TEST(CheckFile, EveryFlippedByteIsFound) {
    const std::vector<std::byte> good = to_image(test::small_bundle());
    std::vector<std::byte> image = good;
    for (std::size_t i = 0; i < image.size(); ++i) {
        image[i] ^= std::byte{0xff};
        EXPECT_EQ(codes_of(check_file(image, "flipped")), std::vector<std::string>{"FILE_UNREADABLE"}) << "byte " << i;
        image[i] = good[i];
    }
}

TEST(CheckFile, EveryTruncationIsFound) {
    const std::vector<std::byte> good = to_image(test::small_bundle());
    for (std::size_t size = 0; size < good.size(); size += 512) {
        const std::vector<std::byte> image(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
        EXPECT_FALSE(check_file(image, "short").findings.empty()) << "size " << size;
    }
}

TEST(CheckFile, ABrokenInvariantIsNamedBesideSoundBytes) {
    Bundle bundle = test::small_bundle();
    bundle.locked[0] = 0;
    const CheckedFile checked = check_file(to_image(bundle), "unlocked");
    EXPECT_EQ(codes_of(checked)[0], "BUNDLE_LOCK_MISSING");
    EXPECT_TRUE(checked.bundle.has_value());
}

// Bytes changed by someone who then sealed the file again: the digests still name the dataset.
TEST(CheckFile, ADigestNamesTheDatasetWhoseBytesChanged) {
    const Bundle bundle = test::small_bundle();
    std::vector<std::byte> image = to_image(bundle, Layout::contiguous);
    const auto mass = std::as_bytes(std::span(bundle.mass));
    const auto at = std::search(image.begin(), image.end(), mass.begin(), mass.end());
    ASSERT_NE(at, image.end());
    *at ^= std::byte{1};
    write_seal(image);
    const CheckedFile checked = check_file(image, "forged");
    ASSERT_FALSE(checked.findings.empty());
    EXPECT_EQ(checked.findings[0].code, "FILE_DAMAGED");
    ASSERT_EQ(checked.findings[0].places.size(), 2u) << "it has a second name in the view";
    EXPECT_EQ(checked.findings[0].places[0].name, "/VTKHDF/PointData/mass");
    EXPECT_EQ(checked.findings[0].places[1].name, "/bundle/mass");
}
