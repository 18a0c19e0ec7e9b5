// SPDX-License-Identifier: GPL-3.0-or-later
// What a person most likely meant by a command line that cannot be read.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}

namespace crumple::cli {

// Names the first word that has no place, in the order written, and the option or verb nearest to it; else what the
// parser says.
[[nodiscard]] std::string explain_parse_error(const CLI::App& app, const CLI::ParseError& error,
                                              const std::vector<std::string>& words);

// "crumple dev schema": as far as the words were understood.
[[nodiscard]] std::string understood_call(const CLI::App& app);

}
