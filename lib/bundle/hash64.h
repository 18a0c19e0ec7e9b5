// SPDX-License-Identifier: MIT
// A checksum against accidental damage, fast enough to read at the speed of memory; no protection against malice.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace crumple {

// XXH64 with seed 0 [Collet, "xxHash fast digest algorithm", specification 0.1.1].
[[nodiscard]] std::uint64_t hash64(std::span<const std::byte> bytes);

}
