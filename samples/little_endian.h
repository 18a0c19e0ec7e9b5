// SPDX-License-Identifier: MIT
// Binary formats store numbers lowest byte first, whatever the machine.
#pragma once
#include <bit>
#include <cstdint>
#include <string>

namespace crumple::samples {

inline void append_u32(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((value >> shift) & 0xffu);
}

inline void append_float(std::string& bytes, double value) {
    append_u32(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

}
