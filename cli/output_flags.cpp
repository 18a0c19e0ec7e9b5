// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "cli/choice_flag.h"

namespace crumple::cli {

namespace {

constexpr EnumName<store::Layout> layout_names[] = {{store::Layout::compressed, "chunked"},
                                                    {store::Layout::contiguous, "contiguous"}};
constexpr EnumName<Format> format_names[] = {{Format::text, "text"}, {Format::json, "json"}};
constexpr EnumName<ProgressStyle> progress_names[] = {{ProgressStyle::automatic, "auto"},
                                                      {ProgressStyle::json, "json"},
                                                      {ProgressStyle::tty, "tty"},
                                                      {ProgressStyle::none, "none"}};

}

void add_output_flags(CLI::App& verb, OutputFlags& flags) {
    verb.add_option("-o,--output", flags.path, "the file to write, .hdf")->type_name("FILE")->required();
    verb.add_option("--jobs", flags.jobs, "threads, 0 for one a processor; the output is the same for any number")
        ->type_name("N")
        ->check(CLI::Range(0, 1024));
    add_choice_flag(verb, "--layout", flags.layout, layout_names, "compressed in chunks, or to be mapped");
    add_format_flag(verb, flags.format);
}

void add_format_flag(CLI::App& verb, Format& format) {
    add_choice_flag(verb, "--format", format, format_names, "of what goes to stdout");
}

void add_progress_flag(CLI::App& verb, Console& console) {
    add_choice_flag(verb, "--progress", console.progress, progress_names,
                    "json: lines of JSON and nothing else on stderr");
}

unsigned thread_count(const OutputFlags& flags) {
    return flags.jobs > 0 ? flags.jobs : std::max(1u, std::thread::hardware_concurrency());
}

}
