// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says with its exit code; reports repeat it.
//
//     0  ok                         4  a quality gate is not met
//     1  usage: option, recipe      5  internal error: a bug
//     2  a path cannot be opened,   6  out of the time or memory allowed
//        read or written            7  a bundle is damaged, or two differ
//     3  the input is refused
#pragma once
#include <array>

#include "core/error.h"

namespace crumple::pipeline {

inline constexpr int exit_ok = 0;
inline constexpr int exit_usage = 1;
inline constexpr int exit_file = 2;
inline constexpr int exit_bad_input = 3;
inline constexpr int exit_quality = 4;
inline constexpr int exit_internal = 5;
inline constexpr int exit_budget = 6;
inline constexpr int exit_difference = 7;

constexpr int exit_code_of(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::usage:
            return exit_usage;
        case ErrorKind::file:
            return exit_file;
        case ErrorKind::bad_input:
            return exit_bad_input;
        case ErrorKind::quality:
            return exit_quality;
        case ErrorKind::internal:
            return exit_internal;
        case ErrorKind::budget:
            return exit_budget;
        case ErrorKind::difference:
            return exit_difference;
    }
    return exit_internal;
}

// Over many files: the first of 5 2 7 3 6 4 0 that occurred.
constexpr int more_important(int a, int b) {
    constexpr std::array order{exit_internal, exit_file,    exit_difference, exit_bad_input,
                               exit_budget,   exit_quality, exit_ok};
    for (const int code : order) {
        if (a == code || b == code) return code;
    }
    return exit_internal;
}

}
