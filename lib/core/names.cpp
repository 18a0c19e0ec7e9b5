// SPDX-License-Identifier: MIT
#include "core/names.h"

#include <algorithm>
#include <vector>

namespace crumple {

namespace {

char folded(char c) {
    if (c == '-') return '_';
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Words from outside may be long: beyond this the rest cannot change which short name is nearest.
constexpr std::size_t max_word = 64;

// Optimal string alignment distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    a = a.substr(0, max_word);
    b = b.substr(0, max_word);
    std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) cost[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) cost[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replace = cost[i - 1][j - 1] + (folded(a[i - 1]) != folded(b[j - 1]));
            cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, replace});
            if (i > 1 && j > 1 && folded(a[i - 1]) == folded(b[j - 2]) && folded(a[i - 2]) == folded(b[j - 1])) {
                cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
            }
        }
    }
    return cost[a.size()][b.size()];
}

}

std::string nearest_name(std::string_view word, std::span<const std::string> valid) {
    const auto nearest = std::min_element(valid.begin(), valid.end(), [&](const auto& a, const auto& b) {
        return edit_distance(word, a) < edit_distance(word, b);
    });
    return nearest == valid.end() ? std::string() : *nearest;
}

std::string list_names(std::span<const std::string> names) {
    constexpr std::size_t shown = 16;
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < shown; ++i) {
        if (i > 0) text += ", ";
        text += names[i];
    }
    if (names.size() > shown) text += ", ...";
    return text;
}

}
