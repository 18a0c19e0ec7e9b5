// SPDX-License-Identifier: GPL-3.0-or-later
#include "sandbox/sandbox.h"

#include <dirent.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "core/error.h"
#include "sandbox/child_side.h"
#include "sandbox/process_memory.h"

namespace crumple::sandbox {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes_of(const char* text) {
    Bytes bytes(std::strlen(text));
    std::memcpy(bytes.data(), text, bytes.size());
    return bytes;
}

int count_open_files() {
    DIR* folder = opendir("/proc/self/fd");
    int count = 0;
    while (readdir(folder)) ++count;
    closedir(folder);
    return count;
}

void sleep_long() { std::this_thread::sleep_for(std::chrono::seconds(60)); }

TEST(Sandbox, EmptyAnswerIsAnAnswer) {
    const Outcome outcome = run_in_child([] { return Bytes{}; }, {});
    EXPECT_EQ(outcome.ending, Ending::ok);
    EXPECT_TRUE(outcome.answer.empty());
}

TEST(Sandbox, AnswerComesBackByteForByte) {
    Bytes large(10'000'019);
    for (std::size_t i = 0; i < large.size(); ++i) large[i] = static_cast<std::byte>(i * 2654435761u >> 24);
    const Outcome outcome = run_in_child([&] { return large; }, {});
    ASSERT_EQ(outcome.ending, Ending::ok);
    EXPECT_EQ(outcome.answer, large);
}

TEST(Sandbox, ChangesOfTheChildStayThere) {
    int value = 1;
    const Outcome outcome = run_in_child(
        [&] {
            value = 2;
            return Bytes{};
        },
        {});
    EXPECT_EQ(outcome.ending, Ending::ok);
    EXPECT_EQ(value, 1);
}

TEST(Sandbox, ErrorKeepsKindAndMessage) {
    const auto refuse = []() -> Bytes { throw Error(ErrorKind::difference, "damaged at byte 7"); };
    const Outcome outcome = run_in_child(refuse, {});
    EXPECT_EQ(outcome.ending, Ending::refused);
    EXPECT_EQ(outcome.kind, ErrorKind::difference);
    EXPECT_EQ(outcome.message, "damaged at byte 7");
}

TEST(Sandbox, ForeignExceptionIsRefusedAsBadInput) {
    const auto refuse = []() -> Bytes { throw std::runtime_error("odd header"); };
    const Outcome outcome = run_in_child(refuse, {});
    EXPECT_EQ(outcome.ending, Ending::refused);
    EXPECT_EQ(outcome.kind, ErrorKind::bad_input);
    EXPECT_EQ(outcome.message, "odd header");
    const auto oddity = []() -> Bytes { throw 7; };
    EXPECT_EQ(run_in_child(oddity, {}).ending, Ending::refused);
}

TEST(Sandbox, EverySuddenDeathIsACrash) {
    const auto ending_of = [](void (*death)()) {
        return run_in_child(
                   [death] {
                       death();
                       return Bytes{};
                   },
                   {})
            .ending;
    };
    EXPECT_EQ(ending_of([] { std::abort(); }), Ending::crashed);
    EXPECT_EQ(ending_of([] { std::raise(SIGSEGV); }), Ending::crashed);
    EXPECT_EQ(ending_of([] { std::raise(SIGKILL); }), Ending::crashed);
    EXPECT_EQ(ending_of([] { std::raise(SIGFPE); }), Ending::crashed);
    EXPECT_EQ(ending_of([] { _exit(0); }), Ending::crashed);
    EXPECT_EQ(ending_of([] { std::terminate(); }), Ending::crashed);
}

TEST(Sandbox, CrashNamesItsSignal) {
    const Outcome outcome = run_in_child(
        [] {
            std::raise(SIGKILL);
            return Bytes{};
        },
        {});
    EXPECT_EQ(outcome.message, "SIGKILL");
}

TEST(Sandbox, HangEndsAtTheTimeLimit) {
    Limits limits;
    limits.time_s = 0.2;
    const Outcome outcome = run_in_child(
        [] {
            sleep_long();
            return Bytes{};
        },
        limits);
    EXPECT_EQ(outcome.ending, Ending::out_of_time);
    EXPECT_NE(outcome.message.find("0.2 s"), std::string::npos);
}

TEST(Sandbox, BusyLoopEndsAtTheTimeLimit) {
    Limits limits;
    limits.time_s = 0.2;
    std::atomic<bool> forever = true;
    const Outcome outcome = run_in_child(
        [&] {
            while (forever) {
            }
            return Bytes{};
        },
        limits);
    EXPECT_EQ(outcome.ending, Ending::out_of_time);
}

[[noreturn]] Bytes eat_all_memory() {
    std::vector<std::unique_ptr<Bytes>> pieces;
    for (;;) pieces.push_back(std::make_unique<Bytes>(std::size_t{1} << 20, std::byte{1}));
}

TEST(Sandbox, RunawayMemoryEndsAtTheMemoryLimit) {
    Limits limits;
    limits.memory_bytes = std::size_t{64} << 20;
    const Outcome outcome = run_in_child(eat_all_memory, limits);
    EXPECT_EQ(outcome.ending, Ending::out_of_memory);
    EXPECT_NE(outcome.message.find("64 MiB"), std::string::npos);
}

// The limit is for good: in a process of its own.
[[noreturn]] void eat_what_the_system_leaves(std::size_t bytes) {
    const rlim_t most = memory_of(getpid()).address_space + bytes;
    const rlimit limit{most, most};
    setrlimit(RLIMIT_AS, &limit);
    const Outcome outcome = run_in_child(eat_all_memory, {});
    const bool is_told = outcome.message.find("ulimit -v") != std::string::npos;
    _exit(outcome.ending == Ending::starved && is_told ? 0 : 1);
}

TEST(Sandbox, LessMemoryThanTheLimitIsNotTheChildsFault) {
    if (has_sanitizer) GTEST_SKIP() << "AddressSanitizer's own mappings exclude a limit on the address space";
    EXPECT_EXIT(eat_what_the_system_leaves(std::size_t{100} << 20), ::testing::ExitedWithCode(0), "");
}

TEST(Sandbox, OneAbsurdAllocationEndsAtTheMemoryLimit) {
    if (has_sanitizer) GTEST_SKIP() << "AddressSanitizer ends the process itself on an absurd allocation";
    Limits limits;
    limits.memory_bytes = std::size_t{64} << 20;
    volatile std::size_t absurd = std::size_t{1} << 40;  // clang 14 breaks down over a constant of this size
    const auto ask = [&absurd]() -> Bytes { return Bytes(absurd); };
    EXPECT_EQ(run_in_child(ask, limits).ending, Ending::out_of_memory);
}

TEST(Sandbox, MemoryOfTheParentDoesNotCount) {
    const Bytes ours(std::size_t{100} << 20, std::byte{1});
    Limits limits;
    limits.memory_bytes = std::size_t{has_sanitizer ? 400u : 50u} << 20;
    EXPECT_EQ(run_in_child([] { return Bytes(1 << 20); }, limits).ending, Ending::ok);
    EXPECT_EQ(ours.back(), std::byte{1});
}

TEST(Sandbox, AnswerOverItsLimitIsNotRead) {
    Limits limits;
    limits.answer_bytes = 1000;
    EXPECT_EQ(run_in_child([] { return Bytes(1000); }, limits).ending, Ending::ok);
    EXPECT_EQ(run_in_child([] { return Bytes(1001); }, limits).ending, Ending::out_of_memory);
    EXPECT_EQ(run_in_child([] { return Bytes(std::size_t{50} << 20); }, limits).ending, Ending::out_of_memory);
}

TEST(Sandbox, NothingIsLeftBehind) {
    Limits limits;
    limits.time_s = 0.05;
    const int before = count_open_files();
    for (int i = 0; i < 10; ++i) {
        (void)run_in_child([] { return Bytes(100); }, {});
        (void)run_in_child(
            [] {
                std::abort();
                return Bytes{};
            },
            {});
    }
    (void)run_in_child(
        [] {
            sleep_long();
            return Bytes{};
        },
        limits);
    EXPECT_EQ(count_open_files(), before);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child or a zombie is left";
}

TEST(Sandbox, ChatterOfTheChildIsNotHeard) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const auto chatter = [] {
        std::printf("hello\n");
        std::fflush(stdout);
        (void)!write(2, "hello\n", 6);
        return Bytes{};
    };
    EXPECT_EQ(run_in_child(chatter, {}).ending, Ending::ok);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Sandbox, WorksWithoutStandardStreams) {
    // The outer child plays a program started with 0, 1 and 2 closed.
    const auto without_streams = [] {
        for (int fd = 0; fd < 3; ++fd) close(fd);
        const Outcome inner = run_in_child([] { return bytes_of("inner"); }, {});
        return inner.ending == Ending::ok ? inner.answer : bytes_of("no answer");
    };
    const Outcome outcome = run_in_child(without_streams, {});
    ASSERT_EQ(outcome.ending, Ending::ok);
    EXPECT_EQ(outcome.answer, bytes_of("inner"));
}

TEST(Sandbox, WorksWhereChildrenAreReapedByOthers) {
    const auto previous = std::signal(SIGCHLD, SIG_IGN);
    EXPECT_EQ(run_in_child([] { return Bytes(5); }, {}).ending, Ending::ok);
    EXPECT_EQ(run_in_child(
                  [] {
                      std::abort();
                      return Bytes{};
                  },
                  {})
                  .ending,
              Ending::crashed);
    std::signal(SIGCHLD, previous);
}

TEST(Sandbox, InterruptingSignalsDoNotCutTheAnswer) {
    struct sigaction action {};
    struct sigaction previous {};
    action.sa_handler = [](int) {};
    sigaction(SIGUSR1, &action, &previous);
    const pid_t us = getpid();
    const auto disturb = [us] {
        for (int i = 0; i < 100; ++i) kill(us, SIGUSR1);
        Bytes large(5'000'000, std::byte{3});
        kill(us, SIGUSR1);
        return large;
    };
    const Outcome outcome = run_in_child(disturb, {});
    sigaction(SIGUSR1, &previous, nullptr);
    ASSERT_EQ(outcome.ending, Ending::ok);
    EXPECT_EQ(outcome.answer.size(), 5'000'000u);
}

}
}
