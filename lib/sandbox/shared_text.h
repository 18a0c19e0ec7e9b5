// SPDX-License-Identifier: GPL-3.0-or-later
// The last words of a child process: what it wrote last as a whole, its parent can still read when it is gone.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "core/file_descriptor.h"
#include "sandbox/shared_word.h"

namespace crumple::sandbox {

// To be made before the fork. One process writes, the other reads once the writer has ended.
class SharedText {
public:
    // Throws Error(internal) when there is no memory for it.
    SharedText();

    // Takes the place of what was written before, or leaves it when there is no memory.
    void write(std::string_view text);
    [[nodiscard]] std::string read() const;

private:
    FileDescriptor file_;              // texts one after the other, each behind its size
    SharedWord<std::uint64_t> begin_;  // of the last one that is whole
    std::uint64_t end_ = 0;            // of them all, known to the writer
};

}
