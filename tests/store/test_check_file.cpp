// SPDX-License-Identifier: MIT
#include "store/check_file.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "bundle/small_bundle.h"
#include "store/bundle_file.h"

using namespace crumple;
using namespace crumple::store;

namespace {

// All of a small file is slow; the quick run steps through it by a prime.
std::size_t stride() { return std::getenv("CRUMPLE_FULL_TESTS") ? 1 : 97; }

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
    for (std::size_t i = 0; i < image.size(); i += stride()) {
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
