// SPDX-License-Identifier: GPL-3.0-or-later
// What a call would write, looked at before any work.
#pragma once
#include <string>
#include <vector>

namespace crumple::cli {

struct OutputPath {
    std::string option;  // "--report"; what it is, where no option names it
    std::string path;
    bool is_certain = true;  // false: written in some cases only, so that it need not be writable now
};

// Each can be written, none is an input, no two are the same file. Throws Error(usage) or Error(file).
void check_output_paths(const std::vector<OutputPath>& outputs, const std::vector<std::string>& inputs);

}
