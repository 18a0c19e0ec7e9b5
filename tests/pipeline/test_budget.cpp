// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/budget.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "core/error.h"

using crumple::Error;
using crumple::ErrorKind;
using crumple::pipeline::Budget;
using crumple::pipeline::Permission;
using crumple::pipeline::run_within;

namespace {

template <class Work>
ErrorKind failure(const Budget& budget, const Work& work) {
    try {
        (void)run_within(budget, work);
    } catch (const Error& error) {
        return error.kind();
    }
    ADD_FAILURE() << "no error";
    return ErrorKind::internal;
}

constexpr Budget ample{600, 1e6};

}

TEST(Budget, WithoutLimitsTheWorkRunsHere) {
    const pid_t here = getpid();
    EXPECT_EQ(run_within({}, [&](const Permission&) { return getpid() == here ? 3 : 4; }), 3);
}

TEST(Budget, WithLimitsTheExitCodeComesThrough) {
    const pid_t here = getpid();
    EXPECT_EQ(run_within(ample, [&](const Permission&) { return getpid() == here ? 3 : 4; }), 4);
}

TEST(Budget, WorkThatTakesTooLongIsEnded) {
    const auto sleeps = [](const Permission&) {
        std::this_thread::sleep_for(std::chrono::seconds(100));
        return 0;
    };
    EXPECT_EQ(failure({0.01, 0}, sleeps), ErrorKind::budget);
}

TEST(Budget, WorkThatHoldsTooMuchIsEnded) {
    const auto hoards = [](const Permission&) {
        std::vector<std::vector<char>> blocks;
        for (int i = 0; i < 2000; ++i) {
            blocks.emplace_back(1u << 20, 1);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return 0;
    };
    EXPECT_EQ(failure({0, 300}, hoards), ErrorKind::budget);
}

TEST(Budget, WorkThatMayFinishIsLetFinish) {
    const auto finishes_late = [](const Permission& may_finish) {
        may_finish(1, "relax");
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        return 0;
    };
    EXPECT_EQ(run_within({0.2, 0}, finishes_late), 0);
}

TEST(Budget, APeakTooHighMayNotFinish) {
    const auto asks = [](const Permission& may_finish) {
        try {
            may_finish(2e6, "relax");
        } catch (const Error& error) {
            const bool says_where = std::string(error.what()).ends_with("; the most was in relax");
            return error.kind() == ErrorKind::budget && says_where ? 6 : 1;
        }
        return 0;
    };
    EXPECT_EQ(run_within(ample, asks), 6);
}

TEST(Budget, ACrashIsAnInternalError) {
    const auto crashes = [](const Permission&) {
        std::signal(SIGSEGV, SIG_DFL);
        std::raise(SIGSEGV);
        return 0;
    };
    EXPECT_EQ(failure(ample, crashes), ErrorKind::internal);
}
