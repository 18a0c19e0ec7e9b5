// SPDX-License-Identifier: MIT
#include "core/parallel_for.h"

#include <algorithm>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace crumple {

void parallel_for(const Context& context, std::size_t count, std::size_t chunk_size,
                  const std::function<void(std::size_t, std::size_t)>& body) {
    if (count == 0) return;
    chunk_size = std::max<std::size_t>(chunk_size, 1);
    const std::size_t chunk_count = (count + chunk_size - 1) / chunk_size;
    const auto run_chunk = [&](std::size_t chunk) {
        const std::size_t begin = chunk * chunk_size;
        body(begin, std::min(begin + chunk_size, count));
    };
    const std::size_t thread_count = std::min<std::size_t>(std::max(context.jobs, 1u), chunk_count);
    if (thread_count == 1) {
        for (std::size_t chunk = 0; chunk < chunk_count; ++chunk) run_chunk(chunk);
        return;
    }

    std::vector<std::exception_ptr> failures(chunk_count);
    std::atomic<std::size_t> next_chunk = 0;
    std::atomic<bool> failed = false;
    const auto work = [&] {
        for (std::size_t chunk; !failed && (chunk = next_chunk++) < chunk_count;) {
            try {
                run_chunk(chunk);
            } catch (...) {
                failures[chunk] = std::current_exception();
                failed = true;
            }
        }
    };
    {
        std::vector<std::jthread> threads;
        try {
            for (std::size_t i = 1; i < thread_count; ++i) threads.emplace_back(work);
        } catch (const std::system_error&) {
            // The machine has no more threads to give: those there are do all of it.
        }
        work();
    }
    for (const auto& failure : failures) {
        if (failure) std::rethrow_exception(failure);
    }
}

}
