// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/fbx_document.h"

#include <charconv>

#include "core/error.h"
#include "formats/assimp_number.h"
#include "formats/fbx_tree.h"
#include "formats/fbx_values.h"
#include "formats/printable.h"
#include "formats/text.h"

namespace crumple::formats::fbx {

namespace {

// The words of an array of text, and the count it announces.
struct TextArray {
    std::optional<std::uint64_t> announced;
    std::string_view words;
};

TextArray text_array(const Document& document, const Node& node) {
    std::string_view values = node.values;
    const std::string_view first = next_word_of(values);
    if (!first.starts_with('*')) return {std::nullopt, node.values};
    const auto announced = to_number<std::uint64_t>(first.substr(1));
    if (!announced) refuse(document, node, "announces " + in_quotes(first) + " numbers");
    const auto index = static_cast<Index>(&node - document.nodes.data());
    const Index content = find_child(document, index, "a");
    return {announced, content == none ? std::string_view() : document.nodes[content].values};
}

double number_of_word(const Document& document, const Node& node, std::string_view word, std::size_t position) {
    double value = 0;
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const std::string held = "holds " + in_quotes(word) + " as number " + std::to_string(position);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size())
        refuse(document, node, held + ", which is not a number");
    if (error == std::errc() && is_misread(word, value))
        refuse(document, node, held + ", of which the reader makes something else");
    return value;
}

std::vector<double> array_of_text(const Document& document, const Node& node) {
    const TextArray array = text_array(document, node);
    std::vector<double> numbers;
    for (std::string_view rest = array.words; !rest.empty();)
        numbers.push_back(number_of_word(document, node, next_word_of(rest), numbers.size() + 1));
    if (array.announced && *array.announced != numbers.size()) {
        refuse(
            document, node,
            "announces " + std::to_string(*array.announced) + " numbers and holds " + std::to_string(numbers.size()));
    }
    return numbers;
}

std::optional<BinaryValue> binary_value(const Node& node, std::size_t position) {
    std::string_view values = node.values;
    auto value = next_value(values);
    for (std::size_t i = 0; i < position && value; ++i) value = next_value(values);
    return value;
}

std::string_view text_value(const Node& node, std::size_t position) {
    std::string_view values = node.values;
    std::string_view word = next_word_of(values);
    for (std::size_t i = 0; i < position; ++i) word = next_word_of(values);
    return word;
}

}

Document parse(std::string_view bytes) {
    return bytes.starts_with(binary_mark) ? parse_binary(bytes) : parse_text(bytes);
}

std::optional<std::string> text_of(const Document& document, const Node& node, std::size_t position) {
    if (document.is_binary) {
        const auto value = binary_value(node, position);
        return value && value->type == 'S' ? std::optional(std::string(value->bytes)) : std::nullopt;
    }
    const std::string_view word = text_value(node, position);
    if (word.size() < 2 || word.front() != '"' || word.back() != '"') return std::nullopt;
    return std::string(word.substr(1, word.size() - 2));
}

std::optional<double> number_of(const Document& document, const Node& node, std::size_t position) {
    if (!document.is_binary) return to_number<double>(text_value(node, position));
    const auto value = binary_value(node, position);
    return value ? number_in(*value) : std::nullopt;
}

std::uint64_t array_size(const Document& document, const Node& node) {
    if (!document.is_binary) return array_of_text(document, node).size();
    const auto value = binary_value(node, 0);
    if (!value || !is_array(*value)) refuse(document, node, "is no array");
    return value->count;
}

std::vector<double> array_of(const Document& document, const Node& node) {
    if (!document.is_binary) return array_of_text(document, node);
    const auto value = binary_value(node, 0);
    auto numbers = value ? numbers_in(*value) : std::nullopt;
    if (!numbers) refuse(document, node, "is no array of the numbers it announces");
    return std::move(*numbers);
}

Index find_child(const Document& document, Index parent, std::string_view name) {
    for (Index child = document.nodes[parent].first_child; child != none; child = document.nodes[child].next_sibling) {
        if (document.nodes[child].name == name) return child;
    }
    return none;
}

void refuse(const Document& document, const Node& node, const std::string& what) {
    throw Error(ErrorKind::bad_input, (document.is_binary ? "byte " : "line ") + std::to_string(node.place) + ": " +
                                          printable(node.name) + " " + what +
                                          "; the file is damaged or was edited: export it again");
}

}
