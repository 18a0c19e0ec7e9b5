// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a function in a limited child process, so that a crash, a hang or a runaway in a reader of untrusted files
// becomes a value here instead of the end of us. POSIX: fork, rlimits, a pipe for the answer.
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/error.h"

namespace crumple::sandbox {

struct Limits {
    std::size_t memory_bytes = std::size_t{8} << 30;  // of the child beyond what we use; resident in sanitizer builds
    double time_s = 120;                              // wall clock
    std::size_t answer_bytes = std::size_t{8} << 30;  // of what it may send back; more ends as out_of_memory
};

// starved: the system itself (ulimit -v) leaves the child less memory than the limit, and that was not enough.
enum class Ending { ok, refused, crashed, out_of_time, out_of_memory, starved };

struct Outcome {
    Ending ending = Ending::ok;
    std::vector<std::byte> answer;          // what the function returned, for ok
    std::string message;                    // what an Error said (refused), the signal's name, the limit met
    ErrorKind kind = ErrorKind::bad_input;  // of a refused Error; any other exception counts as bad_input
};

// The child talks to nobody: its stdin, stdout and stderr are /dev/null, and it ends with us. It runs no destructor of
// ours and flushes no stream. The answer is what it says; whoever reads it must not trust it.
// Throws Error(internal) when no child can be started.
// REQUIRES: no other thread of this process is running (they do not exist in the child).
[[nodiscard]] Outcome run_in_child(const std::function<std::vector<std::byte>()>& function, const Limits& limits);

}
