// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/depfile.h"

#include <cctype>
#include <string_view>

#include "core/error.h"

namespace crumple::cli {

namespace {

// What stands for itself, in make and in ninja.
bool is_plain(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || std::isalnum(byte) != 0 ||
           std::string_view("+,/_.~(){}%@[]!-\\").find(c) != std::string_view::npos;
}

[[noreturn]] void refuse(const std::string& path, std::string_view what) {
    throw Error(
        ErrorKind::usage,
        "--depfile: " + path + ": a rule that make and ninja both read cannot name a path with " + std::string(what));
}

// What cannot be quoted so that both take it back is refused: a rule that is misread leaves an asset stale, without a
// word.
std::string escaped(const std::string& path) {
    std::string text;
    for (const char c : path) {
        if (c == '\n' || c == '\r') refuse(path, "a line break");
        if (c == '\t') refuse(path, "a tab");
        const bool is_quoted = std::string_view(" #:$").find(c) != std::string_view::npos;
        if (!is_quoted && !is_plain(c)) refuse(path, std::string("'") + c + "'");
        if (is_quoted && text.ends_with('\\')) refuse(path, std::string("'\\") + c + "'");
        if (is_quoted) text += c == '$' ? '$' : '\\';
        text += c;
    }
    return text;
}

}

std::string depfile_text(const std::string& output, const std::vector<std::string>& inputs) {
    if (output.find('%') != std::string::npos) refuse(output, "'%' as what it makes");
    std::string text = escaped(output) + ":";
    for (const std::string& input : inputs) text += " " + escaped(input);
    return text + "\n";
}

}
