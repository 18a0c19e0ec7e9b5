// SPDX-License-Identifier: GPL-3.0-or-later
// Linked into a benchmark, counts what operator new hands out.
#pragma once
#include <cstddef>

namespace crumple::bench {

// Bytes in use now; and the most in use since the last reset.
[[nodiscard]] std::size_t heap_in_use();
[[nodiscard]] std::size_t heap_peak();
void reset_heap_peak();

}
