// SPDX-License-Identifier: MIT
#include "core/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace crumple;

namespace {

Context with_jobs(unsigned jobs) {
    Context context;
    context.jobs = jobs;
    return context;
}

TEST(ParallelFor, NothingToDoCallsNobody) {
    parallel_for(with_jobs(4), 0, 16, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(ParallelFor, ZeroJobsAndZeroChunkSizeStillWork) {
    int sum = 0;
    parallel_for(with_jobs(0), 5, 0, [&](std::size_t begin, std::size_t end) { sum += static_cast<int>(end - begin); });
    EXPECT_EQ(sum, 5);
}

TEST(ParallelFor, EveryIndexIsVisitedOnce) {
    for (const unsigned jobs : {1u, 2u, 3u, 8u}) {
        for (const std::size_t count : {1u, 15u, 16u, 17u, 1000u}) {
            std::vector<std::atomic<int>> visits(count);
            parallel_for(with_jobs(jobs), count, 16, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) ++visits[i];
            });
            for (const auto& visit : visits) EXPECT_EQ(visit, 1);
        }
    }
}

TEST(ParallelFor, ChunksAreTheSameForAnyNumberOfThreads) {
    const auto chunks_with = [](unsigned jobs) {
        std::mutex mutex;
        std::set<std::pair<std::size_t, std::size_t>> chunks;
        parallel_for(with_jobs(jobs), 1003, 17, [&](std::size_t begin, std::size_t end) {
            const std::lock_guard lock(mutex);
            chunks.insert({begin, end});
        });
        return chunks;
    };
    const auto alone = chunks_with(1);
    EXPECT_EQ(alone.size(), 59u);
    EXPECT_EQ(chunks_with(2), alone);
    EXPECT_EQ(chunks_with(8), alone);
}

TEST(ParallelFor, SumsPerChunkAreTheSameBytesForAnyNumberOfThreads) {
    const auto sum_with = [](unsigned jobs) {
        constexpr std::size_t chunk = 64;
        std::vector<double> sums(10'000 / chunk + 1);
        parallel_for(with_jobs(jobs), 10'000, chunk, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) sums[begin / chunk] += 1.0 / static_cast<double>(i + 1);
        });
        double sum = 0;
        for (const double part : sums) sum += part;
        return sum;
    };
    EXPECT_EQ(sum_with(1), sum_with(2));
    EXPECT_EQ(sum_with(1), sum_with(7));
}

TEST(ParallelFor, AnExceptionReachesTheCaller) {
    for (const unsigned jobs : {1u, 4u}) {
        try {
            parallel_for(with_jobs(jobs), 100, 1, [](std::size_t begin, std::size_t) {
                if (begin == 40) throw std::runtime_error("forty");
            });
            FAIL();
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(std::string(error.what()), "forty");
        }
    }
}

TEST(ParallelFor, OfSeveralExceptionsTheFirstChunkOfThoseRunWins) {
    // Both chunks are in flight together before either throws.
    std::atomic<int> started = 0;
    try {
        parallel_for(with_jobs(2), 2, 1, [&](std::size_t begin, std::size_t) {
            ++started;
            while (started < 2) std::this_thread::yield();
            throw std::runtime_error(std::to_string(begin));
        });
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_EQ(std::string(error.what()), "0");
    }
}

TEST(ParallelFor, KeepsWorkingAfterAnException) {
    EXPECT_THROW(parallel_for(with_jobs(3), 10, 1, [](std::size_t, std::size_t) { throw std::runtime_error("x"); }),
                 std::runtime_error);
    std::atomic<int> visits = 0;
    parallel_for(with_jobs(3), 10, 1, [&](std::size_t, std::size_t) { ++visits; });
    EXPECT_EQ(visits, 10);
}

TEST(ParallelFor, CancellingStopsTheLoop) {
    std::atomic<bool> cancelled = false;
    Context context = with_jobs(2);
    context.cancelled = &cancelled;
    std::atomic<int> chunks = 0;
    try {
        parallel_for(context, 1'000'000, 1, [&](std::size_t, std::size_t) {
            context.stop_if_cancelled();
            if (++chunks == 10) cancelled = true;
        });
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::budget);
    }
    EXPECT_LT(chunks, 1000);
}

}
