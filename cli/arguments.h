// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the command line.
#pragma once
#include <string>
#include <vector>

namespace crumple::cli {

// Takes "-o=FILE" apart, which is meant as "-o FILE", and replaces each @FILE by the lines of that file, one argument a
// line, blank lines skipped. A file may not name further files. Throws Error(file).
[[nodiscard]] std::vector<std::string> expand_arguments(int count, const char* const* words);

// `--progress json` is among the arguments. For errors of a parser that did not come that far.
[[nodiscard]] bool asks_for_json_lines(const std::vector<std::string>& arguments);

}
