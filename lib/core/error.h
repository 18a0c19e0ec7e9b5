// SPDX-License-Identifier: MIT
// What stops a stage. Expected outcomes are data in a Report; an Error is thrown once, where the reason is known,
// and says what, where and what to try. Each kind is one exit code (pipeline/exit_codes.h).
#pragma once
#include <stdexcept>
#include <string>

namespace crumple {

enum class ErrorKind {
    usage,       // 1: a wrong recipe, option or call
    file,        // 2: a path cannot be opened, read or written
    bad_input,   // 3: the content of an input is refused
    quality,     // 4: a quality gate is not met
    internal,    // 5: a bug of ours
    budget,      // 6: out of the time or memory allowed
    difference,  // 7: check or compare found damage or a difference
};

class Error : public std::runtime_error {
public:
    Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }

private:
    ErrorKind kind_;
};

// Guards data that crosses a module border; always on, unlike assert.
#define CRUMPLE_CHECK(condition, what)                                                                              \
    do {                                                                                                            \
        if (!(condition))                                                                                           \
            throw ::crumple::Error(::crumple::ErrorKind::internal, std::string("internal: ") + (what) + " (" #condition ")"); \
    } while (false)

}
