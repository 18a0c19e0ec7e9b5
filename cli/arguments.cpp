// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "store/read_file.h"

namespace crumple::cli {

namespace {

// The parser would take the sign for the first letter of a name.
void append_word(const std::string& word, std::vector<std::string>& arguments) {
    if (word.starts_with("-o=")) {
        arguments.push_back("-o");
        arguments.push_back(word.substr(3));
    } else {
        arguments.push_back(word);
    }
}

void append_lines(const std::string& path, std::vector<std::string>& arguments) {
    const std::vector<std::byte> bytes = store::read_file(path);
    std::string_view rest(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (!line.empty()) append_word(std::string(line), arguments);
    }
}

}

std::vector<std::string> expand_arguments(int count, const char* const* words) {
    std::vector<std::string> arguments;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word.size() > 1 && word[0] == '@')
            append_lines(word.substr(1), arguments);
        else
            append_word(word, arguments);
    }
    return arguments;
}

bool asks_for_json_lines(const std::vector<std::string>& arguments) {
    constexpr std::string_view words[] = {"--progress", "json"};
    return std::find(arguments.begin(), arguments.end(), "--progress=json") != arguments.end() ||
           std::search(arguments.begin(), arguments.end(), std::begin(words), std::end(words)) != arguments.end();
}

}
