// SPDX-License-Identifier: MIT
#include "core/context.h"

#include <gtest/gtest.h>

using namespace crumple;

namespace {

TEST(Context, AnEmptyOneTellsNobodyAndNeverStops) {
    const Context context;
    EXPECT_EQ(context.jobs, 1u);
    context.tell_progress("step", 0.5);
    EXPECT_NO_THROW(context.stop_if_cancelled());
}

TEST(Context, ProgressReachesTheListener) {
    Context context;
    double heard = 0;
    context.progress = [&](std::string_view step, double fraction) {
        EXPECT_EQ(step, "relax");
        heard = fraction;
    };
    context.tell_progress("relax", 0.25);
    EXPECT_EQ(heard, 0.25);
}

TEST(Context, CancellingIsAnErrorOfTheBudgetKind) {
    std::atomic<bool> cancelled = false;
    Context context;
    context.cancelled = &cancelled;
    EXPECT_NO_THROW(context.stop_if_cancelled());
    cancelled = true;
    try {
        context.stop_if_cancelled();
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::budget);
    }
}

TEST(Error, ABrokenPromiseBetweenModulesSaysWhat) {
    const int answer = 41;
    try {
        CRUMPLE_CHECK(answer == 42, "the answer is known");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::internal);
        EXPECT_STREQ(error.what(), "internal: the answer is known (answer == 42)");
    }
}

}
