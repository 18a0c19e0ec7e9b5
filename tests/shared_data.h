// SPDX-License-Identifier: GPL-3.0-or-later
// Where the shared input data is: the folder CRUMPLE_DATA, else the one beside the project. A user's clone has none, and
// the tests that need it skip.
#pragma once
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

namespace crumple::test {

inline std::filesystem::path data_folder() {
    const char* wanted = std::getenv("CRUMPLE_DATA");
    return wanted && *wanted ? wanted : CRUMPLE_DATA_DEFAULT;
}

}

#define CRUMPLE_NEEDS_DATA()                                                \
    if (!std::filesystem::exists(::crumple::test::data_folder() / "locks")) \
    GTEST_SKIP() << "no shared data at " << ::crumple::test::data_folder() << " (set CRUMPLE_DATA)"
