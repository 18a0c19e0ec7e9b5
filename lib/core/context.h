// SPDX-License-Identifier: MIT
// What a stage is given besides data: how many threads, whom to tell, whether to stop. Nothing here changes a result.
#pragma once
#include <atomic>
#include <functional>
#include <string_view>

#include "core/error.h"

namespace crumple {

struct Context {
    unsigned jobs = 1;  // threads; the bytes of every result are the same for any number
    std::function<void(std::string_view step, double fraction)> progress;
    std::function<void(std::string_view message)> log;
    const std::atomic<bool>* cancelled = nullptr;

    void tell_progress(std::string_view step, double fraction) const {
        if (progress) progress(step, fraction);
    }
    // Call once a sweep or a chunk: cheap, and a cancelled run stops soon.
    void stop_if_cancelled() const {
        if (cancelled && cancelled->load(std::memory_order_relaxed)) throw Error(ErrorKind::budget, "cancelled");
    }
};

}
