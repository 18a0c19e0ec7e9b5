// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/stream_read.h"

#include <cstring>

namespace crumple::bench {

float sum_of(std::span<const float> values) {
    using Wide = float __attribute__((vector_size(32)));
    // Enough sums that none waits for the one before.
    constexpr std::size_t count = 8, width = 8;
    Wide sums[count] = {};
    for (std::size_t i = 0; i + count * width <= values.size(); i += count * width) {
        for (std::size_t k = 0; k < count; ++k) {
            Wide some;
            std::memcpy(&some, &values[i + width * k], sizeof some);
            sums[k] += some;
        }
    }
    for (std::size_t k = 1; k < count; ++k) sums[0] += sums[k];
    return sums[0][0] + sums[0][7];
}

}
