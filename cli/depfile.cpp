// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/depfile.h"

#include <string_view>

#include "core/error.h"

namespace crumple::cli {

namespace {

// As compilers do: a backslash is itself, unless it stands before what one would quote; then it is doubled.
std::string escaped(const std::string& path) {
    std::string text;
    std::size_t backslashes = 0;
    for (const char c : path) {
        if (c == '\n' || c == '\r')
            throw Error(ErrorKind::usage,
                        "--depfile: " + path + ": a rule of make cannot name a path with a line break");
        if (std::string_view(" \t#:").find(c) != std::string_view::npos) text += std::string(backslashes + 1, '\\');
        if (c == '$') text += '$';
        text += c;
        backslashes = c == '\\' ? backslashes + 1 : 0;
    }
    return text;
}

}

std::string depfile_text(const std::string& output, const std::vector<std::string>& inputs) {
    std::string text = escaped(output) + ":";
    for (const std::string& input : inputs) text += " " + escaped(input);
    return text + "\n";
}

}
