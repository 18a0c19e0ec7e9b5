// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/color_name.h"

#include <algorithm>
#include <string>
#include <vector>

namespace crumple::formats {

namespace {

bool is_color_word(std::string_view word) {
    for (const char* color : {"red", "rgb", "rgba", "color", "colors", "colour", "colours"}) {
        if (word == color) return true;
    }
    return false;
}

// The words of letters in a name, in lower case.
std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> words(1);
    for (const char c : name) {
        const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        if (lower >= 'a' && lower <= 'z') {
            words.back() += lower;
        } else {
            words.emplace_back();
        }
    }
    return words;
}

}

bool looks_like_color(std::string_view name) {
    const std::vector<std::string> words = words_of(name);
    const bool is_number_of_one = std::any_of(words.begin(), words.end(), [](const std::string& word) {
        return word == "index" || word == "id" || word == "indices";
    });
    return name == "R" || (!is_number_of_one && std::any_of(words.begin(), words.end(), is_color_word));
}

}
