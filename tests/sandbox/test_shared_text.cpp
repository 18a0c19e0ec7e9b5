// SPDX-License-Identifier: GPL-3.0-or-later
#include "sandbox/shared_text.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <string>

#include "sandbox/process_memory.h"

using crumple::sandbox::memory_of;
using crumple::sandbox::SharedText;

namespace {

// In a child that ends without a word.
void do_in_child(const std::function<void()>& work) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        work();
        kill(getpid(), SIGKILL);
    }
    ASSERT_EQ(waitpid(child, nullptr, 0), child);
}

}

TEST(SharedText, NothingWasWritten) {
    const SharedText text;
    EXPECT_EQ(text.read(), "");
}

TEST(SharedText, TheLastOneOutlivesItsWriter) {
    SharedText text;
    const std::string last(3 << 20, 'x');
    do_in_child([&] {
        text.write("first");
        text.write("");
        text.write(last);
    });
    EXPECT_EQ(text.read(), last);
}

TEST(ProcessMemory, IsThatOfTheProcess) {
    const auto before = memory_of(getpid());
    EXPECT_GT(before.resident, 0u);
    EXPECT_GE(before.address_space, before.resident);
    EXPECT_GE(before.resident, before.shared);
    // Mapped, not allocated: a compiler may leave out an allocation that nobody reads.
    constexpr std::size_t more = 64 << 20;
    void* const pages = mmap(nullptr, more, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
    ASSERT_NE(pages, MAP_FAILED);
    EXPECT_GT(memory_of(getpid()).resident, before.resident + more / 2);
    munmap(pages, more);
}

TEST(ProcessMemory, IsNothingForAProcessThatIsGone) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) _exit(0);
    ASSERT_EQ(waitpid(child, nullptr, 0), child);
    EXPECT_EQ(memory_of(child).resident, 0u);
}
