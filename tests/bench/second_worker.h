// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <thread>

#include "solver/jobs.h"

namespace crumple::bench {

// The caller's two threads: the second waits for work without sleeping, as those of a game do within a frame.
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

private:
    void run(std::size_t count, solver::Jobs::Task task, void* context) {
        task_ = task;
        context_ = context;
        count_ = count;
        next_ = 0;
        is_done_ = false;
        round_.fetch_add(1, std::memory_order_release);
        take();
        while (!is_done_.load(std::memory_order_acquire)) {
        }
    }
    void take() {
        for (std::size_t i = next_++; i < count_; i = next_++) task_(context_, i);
    }
    void work() {
        unsigned seen = 0;
        while (!is_over_) {
            const unsigned round = round_.load(std::memory_order_acquire);
            if (round == seen) continue;
            seen = round;
            take();
            is_done_.store(true, std::memory_order_release);
        }
    }
    solver::Jobs::Task task_ = nullptr;
    void* context_ = nullptr;
    std::size_t count_ = 0;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<unsigned> round_ = 0;
    std::atomic<bool> is_done_ = true, is_over_ = false;
    std::thread thread_;
};

}
