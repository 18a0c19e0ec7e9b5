// SPDX-License-Identifier: MIT
// Runs body(begin, end) over fixed chunks of [0, count). Chunks are the same for any number of threads, so work that
// writes only to its own indices (or sums per chunk, then over chunks in order) gives the same bytes at any --jobs.
#pragma once
#include <cstddef>
#include <functional>

#include "core/context.h"

namespace crumple {

// The first exception by chunk order is thrown again on the calling thread, after all threads stopped.
void parallel_for(const Context& context, std::size_t count, std::size_t chunk_size,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

}
