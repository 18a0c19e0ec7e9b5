// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output_paths.h"

#include <filesystem>

#include "core/error.h"
#include "store/write_file.h"

namespace crumple::cli {

namespace {

namespace fs = std::filesystem;

bool is_same_file(const std::string& a, const std::string& b) {
    std::error_code error;
    if (fs::equivalent(a, b, error)) return true;
    const fs::path first = fs::weakly_canonical(fs::absolute(a, error), error);
    return !error && first == fs::weakly_canonical(fs::absolute(b, error), error) && !error;
}

}

void check_output_paths(const std::vector<OutputPath>& outputs, const std::vector<std::string>& inputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto& [option, path, is_certain] = outputs[i];
        if (path == "-")
            throw Error(ErrorKind::usage,
                        option + " -: this goes to a file, not to stdout; ./- is a file of that name");
        if (is_certain) store::check_can_write(path);
        for (const std::string& input : inputs) {
            if (!is_same_file(path, input)) continue;
            const std::string what = is_certain ? option + " " + path : path + ", " + option;
            throw Error(ErrorKind::usage, what + ": would replace an input");
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (!is_same_file(path, outputs[j].path)) continue;
            throw Error(ErrorKind::usage, option + " and " + outputs[j].option + " name the same file, " + path +
                                              "; give one another name");
        }
    }
}

}
