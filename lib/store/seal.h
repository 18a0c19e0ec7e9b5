// SPDX-License-Identifier: MIT
// The first 512 bytes of every file we write: an HDF5 user block, which HDF5 readers skip. It holds the file's size and
// the SHA-256 of everything else, so that damage is known before HDF5, which trusts what it reads, sees a byte.
#pragma once
#include <cstddef>
#include <span>
#include <string>

namespace crumple::store {

inline constexpr std::size_t seal_size = 512;

// Fills the first seal_size bytes of the file. REQUIRES: file.size() >= seal_size.
void write_seal(std::span<std::byte> file);

// What is wrong with the file as a sentence, empty when not one of its bits has changed since write_seal.
[[nodiscard]] std::string find_damage(std::span<const std::byte> file);

}
