// SPDX-License-Identifier: GPL-3.0-or-later
// The options of every verb that writes a file of ours.
#pragma once
#include <string>

#include "cli/console.h"
#include "store/hdf5_file.h"

namespace CLI {
class App;
}

namespace crumple::cli {

struct OutputFlags {
    std::string path;
    unsigned jobs = 0;  // 0: one a processor
    store::Layout layout = store::Layout::compressed;
    Format format = Format::text;
};

void add_output_flags(CLI::App& verb, OutputFlags& flags);
void add_format_flag(CLI::App& verb, Format& format);
void add_progress_flag(CLI::App& verb, Console& console);

[[nodiscard]] unsigned thread_count(const OutputFlags& flags);

}
