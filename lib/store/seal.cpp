// SPDX-License-Identifier: MIT
#include "store/seal.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "store/sha256.h"

namespace crumple::store {
namespace {

// Offsets of the fields; FORMAT.md tells them to others.
constexpr char magic[8] = {'C', 'R', 'U', 'M', 'P', 'L', 'E', '\n'};
constexpr std::size_t version_offset = 8;  // u32
constexpr std::size_t zero_offset = 12;    // u32, 0
constexpr std::size_t size_offset = 16;    // u64
constexpr std::size_t digest_offset = 24;  // 32 bytes
constexpr std::size_t end_offset = 56;     // zeros from here to seal_size
constexpr std::uint8_t seal_version = 1;

void put_little_endian(std::span<std::byte> to, std::uint64_t value) {
    for (std::byte& byte : to) {
        byte = static_cast<std::byte>(value & 0xff);
        value >>= 8;
    }
}

std::uint64_t get_little_endian(std::span<const std::byte> from) {
    std::uint64_t value = 0;
    for (std::size_t i = from.size(); i-- > 0;) value = value << 8 | std::to_integer<std::uint64_t>(from[i]);
    return value;
}

Digest digest_of(std::span<const std::byte> file) {
    return Sha256().update(file.first(digest_offset)).update(file.subspan(seal_size)).finish();
}

}

void write_seal(std::span<std::byte> file) {
    std::fill_n(file.begin(), seal_size, std::byte{0});
    std::memcpy(file.data(), magic, sizeof magic);
    put_little_endian(file.subspan(version_offset, 4), seal_version);
    put_little_endian(file.subspan(size_offset, 8), file.size());
    const Digest digest = digest_of(file);
    std::memcpy(file.data() + digest_offset, digest.data(), digest.size());
}

std::string find_damage(std::span<const std::byte> file) {
    if (file.size() < sizeof magic || std::memcmp(file.data(), magic, sizeof magic) != 0) {
        return "it is not a file written by crumple, or its first bytes are damaged";
    }
    if (file.size() < seal_size) return "it ends within its first " + std::to_string(seal_size) + " bytes";
    const std::uint64_t version = get_little_endian(file.subspan(version_offset, 4));
    if (version != seal_version) {
        return "its seal has version " + std::to_string(version) + ", this program reads " +
               std::to_string(seal_version);
    }
    const std::uint64_t size = get_little_endian(file.subspan(size_offset, 8));
    if (size != file.size()) {
        return "it should have " + std::to_string(size) + " bytes and has " + std::to_string(file.size());
    }
    const auto is_zero = [](std::byte b) { return b == std::byte{0}; };
    const auto padding = file.subspan(end_offset, seal_size - end_offset);
    const Digest digest = digest_of(file);
    if (std::memcmp(file.data() + digest_offset, digest.data(), digest.size()) != 0 ||
        get_little_endian(file.subspan(zero_offset, 4)) != 0 || !std::all_of(padding.begin(), padding.end(), is_zero)) {
        return "its bytes have changed since it was written (SHA-256)";
    }
    return "";
}

}
