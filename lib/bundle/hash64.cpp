// SPDX-License-Identifier: MIT
#include "bundle/hash64.h"

#include <bit>
#include <cstring>

namespace crumple {
namespace {

// Names as in the specification.
constexpr std::uint64_t prime_1 = 0x9E3779B185EBCA87u;
constexpr std::uint64_t prime_2 = 0xC2B2AE3D27D4EB4Fu;
constexpr std::uint64_t prime_3 = 0x165667B19E3779F9u;
constexpr std::uint64_t prime_4 = 0x85EBCA77C2B2AE63u;
constexpr std::uint64_t prime_5 = 0x27D4EB2F165667C5u;

template <class Word>
std::uint64_t take(std::span<const std::byte>& bytes) {
    static_assert(std::endian::native == std::endian::little, "the checksum is defined on little-endian words");
    Word word;
    std::memcpy(&word, bytes.data(), sizeof word);
    bytes = bytes.subspan(sizeof word);
    return word;
}

std::uint64_t round(std::uint64_t lane, std::uint64_t word) { return std::rotl(lane + word * prime_2, 31) * prime_1; }

std::uint64_t merge(std::uint64_t hash, std::uint64_t lane) { return (hash ^ round(0, lane)) * prime_1 + prime_4; }

std::uint64_t hash_stripes(std::span<const std::byte>& bytes) {
    std::uint64_t a = prime_1 + prime_2;
    std::uint64_t b = prime_2;
    std::uint64_t c = 0;
    std::uint64_t d = 0 - prime_1;
    while (bytes.size() >= 32) {
        a = round(a, take<std::uint64_t>(bytes));
        b = round(b, take<std::uint64_t>(bytes));
        c = round(c, take<std::uint64_t>(bytes));
        d = round(d, take<std::uint64_t>(bytes));
    }
    std::uint64_t hash = std::rotl(a, 1) + std::rotl(b, 7) + std::rotl(c, 12) + std::rotl(d, 18);
    for (const std::uint64_t lane : {a, b, c, d}) hash = merge(hash, lane);
    return hash;
}

std::uint64_t hash_rest(std::uint64_t hash, std::span<const std::byte> bytes) {
    while (bytes.size() >= 8) {
        hash = std::rotl(hash ^ round(0, take<std::uint64_t>(bytes)), 27) * prime_1 + prime_4;
    }
    if (bytes.size() >= 4) {
        hash = std::rotl(hash ^ take<std::uint32_t>(bytes) * prime_1, 23) * prime_2 + prime_3;
    }
    while (!bytes.empty()) hash = std::rotl(hash ^ take<std::uint8_t>(bytes) * prime_5, 11) * prime_1;
    return hash;
}

std::uint64_t avalanche(std::uint64_t hash) {
    hash = (hash ^ hash >> 33) * prime_2;
    hash = (hash ^ hash >> 29) * prime_3;
    return hash ^ hash >> 32;
}

}

std::uint64_t hash64(std::span<const std::byte> bytes) {
    const std::uint64_t size = bytes.size();
    const std::uint64_t hash = size >= 32 ? hash_stripes(bytes) : prime_5;
    return avalanche(hash_rest(hash + size, bytes));
}

}
