// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the command line.
#pragma once
#include <string>
#include <vector>

namespace crumple::cli {

// Takes "-o=FILE" apart, which is meant as "-o FILE", and replaces each @FILE by the lines of that file, one argument a
// line, blank lines skipped. A file may not name further files. Throws Error(file).
[[nodiscard]] std::vector<std::string> expand_arguments(int count, const char* const* words);

}
