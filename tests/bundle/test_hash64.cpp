// SPDX-License-Identifier: MIT
#include "bundle/hash64.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

using namespace crumple;

namespace {

std::uint64_t hash_text(std::string_view text) { return hash64(std::as_bytes(std::span(text))); }

}

// Values of the reference implementation (xxhsum -H64).
TEST(Hash64, IsXxh64OfEveryLengthClass) {
    EXPECT_EQ(hash_text(""), 0xef46db3751d8e999u);
    EXPECT_EQ(hash_text("a"), 0xd24ec4f1a98c6e5bu);
    EXPECT_EQ(hash_text("abc"), 0x44bc2cf5ad770999u);
    EXPECT_EQ(hash_text("Nobody inspects the spammish repetition"), 0xfbcea83c8a378bf1u);
}

TEST(Hash64, DoesNotCareWhereTheBytesLie) {
    std::vector<std::byte> bytes(300);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i * 7 + i / 256);
    const std::uint64_t expected = hash64(std::span(bytes).first(200));
    for (std::size_t shift = 1; shift < 9; ++shift) {
        std::vector<std::byte> moved(shift);
        moved.insert(moved.end(), bytes.begin(), bytes.begin() + 200);
        EXPECT_EQ(hash64(std::span(moved).subspan(shift)), expected);
    }
}

TEST(Hash64, ChangesWithEveryBitOfEveryLength) {
    for (std::size_t size = 1; size < 100; ++size) {
        std::vector<std::byte> bytes(size, std::byte{0x5a});
        const std::uint64_t before = hash64(bytes);
        for (std::size_t bit = 0; bit < 8 * size; ++bit) {
            const std::byte mask{static_cast<unsigned char>(1u << bit % 8)};
            bytes[bit / 8] ^= mask;
            ASSERT_NE(hash64(bytes), before) << "bit " << bit << " of " << size << " bytes";
            bytes[bit / 8] ^= mask;
        }
    }
}
