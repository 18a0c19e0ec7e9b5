// SPDX-License-Identifier: MIT
#include "store/seal.h"

#include <gtest/gtest.h>

#include <vector>

#include "store/sha256.h"

using crumple::store::find_damage;
using crumple::store::seal_size;

namespace {

std::vector<std::byte> sealed_file(std::size_t size) {
    std::vector<std::byte> file(size);
    for (std::size_t i = 0; i < size; ++i) file[i] = static_cast<std::byte>(i * 7);
    crumple::store::write_seal(file);
    return file;
}

}

TEST(Seal, FindsDamageInNothingAndInTooLittle) {
    EXPECT_FALSE(find_damage({}).empty());
    const auto file = sealed_file(600);
    for (std::size_t size = 0; size < 600; ++size)
        EXPECT_FALSE(find_damage(std::span(file).first(size)).empty()) << size;
}

TEST(Seal, AcceptsWhatItSealed) {
    EXPECT_EQ(find_damage(sealed_file(seal_size)), "");
    EXPECT_EQ(find_damage(sealed_file(5000)), "");
}

TEST(Seal, FindsEverySingleBit) {
    auto file = sealed_file(700);
    for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
        const auto mask = static_cast<std::byte>(1u << bit % 8);
        file[bit / 8] ^= mask;
        EXPECT_FALSE(find_damage(file).empty()) << "bit " << bit;
        file[bit / 8] ^= mask;
    }
    EXPECT_EQ(find_damage(file), "");
}

TEST(Seal, FindsWhatWasAppended) {
    auto file = sealed_file(700);
    file.push_back(std::byte{0});
    EXPECT_EQ(find_damage(file), "it should have 700 bytes and has 701");
}

TEST(Sha256, AgreesWithThePublishedTestVector) {
    // FIPS 180-4, appendix: "abc".
    const std::string abc = "abc";
    EXPECT_EQ(crumple::store::to_hex(crumple::store::sha256(std::as_bytes(std::span(abc)))),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}
