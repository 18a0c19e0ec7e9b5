// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dae_document.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "core/error.h"
#include "formats/assimp_number.h"
#include "formats/printable.h"
#include "formats/text.h"

namespace crumple::formats::dae {

namespace {

// As assimp reads it: a comma may stand for the point, and what a double cannot hold is still a number.
bool to_real(std::string_view word, double& value) {
    std::string text(word.starts_with('+') ? word.substr(1) : word);
    std::replace(text.begin(), text.end(), ',', '.');
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range) value = std::numeric_limits<double>::infinity();
    return error != std::errc::invalid_argument && end == text.data() + text.size();
}

}

Document parse(std::string_view text) {
    Document document{xml::parse(text), {}};
    for (std::size_t e = 0; e < document.elements.size(); ++e) {
        if (const auto id = xml::attribute(document.elements[e], "id")) document.by_id[*id] = static_cast<Index>(e);
    }
    return document;
}

Index find(const Document& document, std::string_view url) {
    if (url.starts_with('#')) url.remove_prefix(1);
    const auto found = document.by_id.find(url);
    return found == document.by_id.end() ? none : found->second;
}

std::uint64_t number(const xml::Element& element, std::string_view name, std::uint64_t absent) {
    const auto text = xml::attribute(element, name);
    if (!text) return absent;
    std::string_view rest = *text;
    const auto value = to_number<std::uint32_t>(next_word(rest));
    if (!value || !next_word(rest).empty())
        refuse(element, "has " + in_quotes(*text) + " for its " + std::string(name) + ", which is no size");
    return *value;
}

std::vector<double> reals(const xml::Element& element) {
    std::vector<double> values;
    std::string_view rest = element.text;
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
        if (!to_real(word, values.emplace_back()))
            refuse(element, "holds " + in_quotes(word) + " as number " + std::to_string(values.size()) +
                                ", which is not a number");
        if (is_misread(word, values.back()))
            refuse(element, "holds " + in_quotes(word) + " as number " + std::to_string(values.size()) +
                                ", of which the reader makes something else");
    }
    return values;
}

std::vector<Index> indices(const xml::Element& element) {
    std::vector<Index> values;
    std::string_view rest = element.text;
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
        const auto value = to_number<Index>(word);
        if (!value)
            refuse(element, "holds " + in_quotes(word) + " as number " + std::to_string(values.size() + 1) +
                                ", which is no index");
        values.push_back(*value);
    }
    return values;
}

void refuse(const xml::Element& element, const std::string& what) {
    throw Error(ErrorKind::bad_input, xml::line(element) + xml::tag(element) + " " + what +
                                          "; the file is damaged or was edited: export it again");
}

}
