// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <thread>

#include "core/error.h"
#include "store/write_file.h"

namespace crumple::cli {

void add_output_flags(CLI::App& verb, OutputFlags& flags) {
    static const std::map<std::string, store::Layout> layouts{{"chunked", store::Layout::compressed},
                                                              {"contiguous", store::Layout::contiguous}};
    verb.add_option("-o,--output", flags.path, "the file to write, .hdf")->type_name("FILE")->required();
    verb.add_option("--jobs", flags.jobs, "threads, 0 for one a processor; the output is the same for any number")
        ->type_name("N")
        ->check(CLI::Range(0, 1024));
    verb.add_option("--layout", flags.layout, "chunked (compressed) or contiguous (to be mapped)")
        ->type_name("LAYOUT")
        ->transform(CLI::CheckedTransformer(layouts).description(""));
    add_format_flag(verb, flags.format);
}

void add_format_flag(CLI::App& verb, Format& format) {
    static const std::map<std::string, Format> formats{{"text", Format::text}, {"json", Format::json}};
    verb.add_option("--format", format, "text or json, of what goes to stdout")
        ->type_name("FORMAT")
        ->transform(CLI::CheckedTransformer(formats).description(""));
}

void add_progress_flag(CLI::App& verb, Console& console) {
    static const std::map<std::string, ProgressStyle> styles{{"auto", ProgressStyle::automatic},
                                                             {"json", ProgressStyle::json},
                                                             {"tty", ProgressStyle::tty},
                                                             {"none", ProgressStyle::none}};
    verb.add_option("--progress", console.progress, "json (lines on stderr), tty or none")
        ->type_name("STYLE")
        ->transform(CLI::CheckedTransformer(styles).description(""));
}

unsigned thread_count(const OutputFlags& flags) {
    return flags.jobs > 0 ? flags.jobs : std::max(1u, std::thread::hardware_concurrency());
}

void check_side_path(const std::string& path, const std::vector<std::string>& inputs) {
    store::check_can_write(path);
    for (const std::string& input : inputs) {
        std::error_code ignored;
        if (path == input || std::filesystem::equivalent(path, input, ignored)) {
            throw Error(ErrorKind::usage, path + ": would replace " + input);
        }
    }
}

}
