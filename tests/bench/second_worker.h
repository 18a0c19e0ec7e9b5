// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <atomic>
#include <thread>

#include "bench/cpu_time.h"
#include "solver/jobs.h"

namespace crumple::bench {

// The caller's second thread: waits for work without sleeping, as those of a game do within a frame. Each of the two
// does half of a loop, so that what they take does not depend on who else is on the machine.
class SecondWorker {
public:
    SecondWorker() : thread_([this] { work(); }) {}
    ~SecondWorker() {
        is_over_ = true;
        thread_.join();
    }
    [[nodiscard]] solver::Jobs jobs() {
        return {[](void* user, std::size_t count, solver::Jobs::Task task, void* context) {
                    static_cast<SecondWorker*>(user)->run(count, task, context);
                },
                this};
    }
    // Processor time along whichever thread took longer in each loop, and of the caller's between the loops, while
    // `frame` runs: what it takes on a machine that does nothing else.
    template <class Frame>
    double seconds_of(Frame&& frame) {
        added_s_ = 0;
        const double begin = thread_cpu_seconds();
        frame();
        return thread_cpu_seconds() - begin + added_s_;
    }

private:
    void run(std::size_t count, solver::Jobs::Task task, void* context) {
        task_ = task;
        context_ = context;
        count_ = count;
        is_done_ = false;
        round_.fetch_add(1, std::memory_order_release);
        const double begin = thread_cpu_seconds();
        for (std::size_t i = 0; i < count / 2; ++i) task(context, i);
        const double end = thread_cpu_seconds();
        while (!is_done_.load(std::memory_order_acquire)) std::this_thread::yield();
        const double waited = thread_cpu_seconds() - end;
        added_s_ += std::max(0.0, busy_s_ - (end - begin)) - waited;
    }
    void work() {
        unsigned seen = 0;
        while (!is_over_) {
            const unsigned round = round_.load(std::memory_order_acquire);
            if (round == seen) {
                std::this_thread::yield();
                continue;
            }
            seen = round;
            const double begin = thread_cpu_seconds();
            for (std::size_t i = count_ / 2; i < count_; ++i) task_(context_, i);
            busy_s_ = thread_cpu_seconds() - begin;
            is_done_.store(true, std::memory_order_release);
        }
    }
    solver::Jobs::Task task_ = nullptr;
    void* context_ = nullptr;
    std::size_t count_ = 0;
    double busy_s_ = 0;
    double added_s_ = 0;
    std::atomic<unsigned> round_ = 0;
    std::atomic<bool> is_done_ = true, is_over_ = false;
    std::thread thread_;
};

}
