// SPDX-License-Identifier: GPL-3.0-or-later
// CRUMPLE_CLONES("avx2", "default") before a function compiles it once per instruction set; the loader picks by CPU.
// Without fused operations (-ffp-contract=off) every version gives the same bits.
// Address sanitizer runs before the loader's choice may, so there is only the plain version with it.
#pragma once

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CRUMPLE_PLAIN_ONLY
#endif
#endif

#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(CRUMPLE_PLAIN_ONLY)
#define CRUMPLE_CLONES(...) __attribute__((target_clones(__VA_ARGS__)))
#else
#define CRUMPLE_CLONES(...)
#endif
