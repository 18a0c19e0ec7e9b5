// SPDX-License-Identifier: MIT
// The caller's threads. The pieces of a loop are the same for any number of threads, and sums are taken per piece and
// then in order, so results have the same bits with and without them.
#pragma once
#include <algorithm>
#include <cstddef>

namespace crumple::solver {

struct Jobs {
    using Task = void (*)(void* context, std::size_t index);
    // Runs task(context, i) for i in [0, count), in any order on any threads, and returns when all are done.
    // Null: the calling thread does everything. Must not throw.
    void (*run)(void* user, std::size_t count, Task task, void* context) = nullptr;
    void* user = nullptr;
};

// body(piece, begin, end) over pieces of `size` of [0, count).
template <class Body>
void for_pieces(const Jobs& jobs, std::size_t count, std::size_t size, Body&& body) {
    const std::size_t pieces = (count + size - 1) / size;
    if (jobs.run == nullptr || pieces < 2) {
        for (std::size_t piece = 0; piece < pieces; ++piece) {
            body(piece, piece * size, std::min(count, (piece + 1) * size));
        }
        return;
    }
    struct Shared {
        Body& body;
        std::size_t count;
        std::size_t size;
    } shared{body, count, size};
    jobs.run(
        jobs.user, pieces,
        [](void* context, std::size_t piece) {
            const auto& s = *static_cast<Shared*>(context);
            s.body(piece, piece * s.size, std::min(s.count, (piece + 1) * s.size));
        },
        &shared);
}

}
