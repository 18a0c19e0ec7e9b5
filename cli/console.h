// SPDX-License-Identifier: GPL-3.0-or-later
// Results go to stdout, talk and progress to stderr; with --progress json everything on stderr is a line of JSON.
#pragma once
#include <string>
#include <string_view>

#include "pipeline/runner.h"

namespace crumple::cli {

enum class ProgressStyle { automatic, json, tty, none };
enum class Format { text, json };

class Console {
public:
    bool is_quiet = false;    // -q: errors only
    bool is_verbose = false;  // -v
    ProgressStyle progress = ProgressStyle::automatic;

    // Asks the environment: NO_COLOR, and whether the streams are terminals.
    Console();

    void result(std::string_view text) const;   // stdout, as it is
    void talk(std::string_view text) const;     // stderr unless quiet
    void explain(std::string_view text) const;  // stderr when verbose
    // stderr; the message as one safe line, text from files may be in it. The hint as it is, ends in a newline.
    void error(std::string_view message, std::string_view hint = {}) const;

    [[nodiscard]] bool colors_results() const { return colors_results_; }
    [[nodiscard]] bool colors_talk() const { return colors_talk_; }

    // Shows what stages do: a line that renews itself on a terminal, lines of JSON, or what -v asks for.
    // Valid as long as the console is.
    [[nodiscard]] pipeline::Observer observer() const;

private:
    [[nodiscard]] ProgressStyle shown_progress() const;
    [[nodiscard]] bool is_for_programs() const { return progress == ProgressStyle::json; }

    bool talks_to_terminal_;
    bool colors_results_;
    bool colors_talk_;
};

}
