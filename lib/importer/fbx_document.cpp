// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/fbx_document.h"

#include <algorithm>
#include <charconv>
#include <cstring>

#include "core/error.h"
#include "importer/assimp_number.h"
#include "importer/fbx_values.h"
#include "importer/printable.h"
#include "importer/text.h"

namespace crumple::importer::fbx {

namespace {

constexpr std::string_view binary_mark("Kaydara FBX Binary  \0", 21);

// Files have a handful of levels; assimp calls itself for each.
constexpr std::size_t deepest = 500;

[[noreturn]] void refuse_at(bool is_binary, std::size_t place, const std::string& what) {
    throw Error(ErrorKind::bad_input, (is_binary ? "byte " : "line ") + std::to_string(place) + ": " + what +
                                          "; the file is damaged or cut short: export it again");
}

// Puts nodes under those that are open.
class Tree {
public:
    explicit Tree(bool is_binary) : is_binary_(is_binary), nodes_(1), last_child_(1, none), open_{0} {}

    void add(const Node& node) {
        const auto index = static_cast<Index>(nodes_.size());
        Index& last = last_child_[open_.back()];
        (last == none ? nodes_[open_.back()].first_child : nodes_[last].next_sibling) = index;
        last = index;
        nodes_.push_back(node);
        last_child_.push_back(none);
    }
    // The node added last takes those that follow.
    void open() {
        open_.push_back(static_cast<Index>(nodes_.size() - 1));
        if (open_.size() > deepest)
            refuse_at(is_binary_, nodes_.back().place,
                      "nodes are nested more than " + std::to_string(deepest) + " deep");
    }
    void close() { open_.pop_back(); }
    [[nodiscard]] bool is_open() const { return open_.size() > 1; }
    [[nodiscard]] const Node& innermost() const { return nodes_[open_.back()]; }
    [[nodiscard]] Document take() { return {std::move(nodes_), is_binary_}; }

private:
    bool is_binary_;
    std::vector<Node> nodes_;
    std::vector<Index> last_child_;
    std::vector<Index> open_;
};

class TextParser {
public:
    explicit TextParser(std::string_view text) : text_(text) {}

    Document parse() {
        for (skip_blank(); at_ < text_.size(); skip_blank()) {
            if (text_[at_] == '}') {
                close();
            } else {
                read_node();
            }
        }
        if (tree_.is_open()) {
            refuse_at(false, line_,
                      "the file ends within " + in_quotes(tree_.innermost().name) + ", which begins in line " +
                          std::to_string(tree_.innermost().place));
        }
        return tree_.take();
    }

private:
    void advance() { line_ += text_[at_++] == '\n'; }

    // Blanks, and comments to the end of a line.
    void skip_blank() {
        while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == ';')) {
            if (text_[at_] == ';') {
                while (at_ < text_.size() && text_[at_] != '\n') advance();
            } else {
                advance();
            }
        }
    }

    void close() {
        if (!tree_.is_open()) refuse_at(false, line_, "a brace closes nothing");
        tree_.close();
        advance();
    }

    void read_node() {
        Node node;
        node.place = line_;
        node.name = take_name();
        node.values = take_values();
        tree_.add(node);
        if (at_ >= text_.size() || text_[at_] != '{') return;
        tree_.open();
        advance();
    }

    std::string_view take_name() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && text_[at_] != ':' && !is_space(text_[at_]) && text_[at_] != '{' &&
               text_[at_] != '}' && text_[at_] != '"' && text_[at_] != ',')
            advance();
        const std::string_view name = text_.substr(begin, at_ - begin);
        if (at_ >= text_.size() || text_[at_] != ':')
            refuse_at(
                false, line_,
                in_quotes(name.empty() ? text_.substr(at_, 1) : name) + " stands where a name and a colon should");
        advance();
        return name;
    }

    // Up to a brace, or the end of a line where no comma or brace goes on.
    std::string_view take_values() {
        const std::size_t begin = at_;
        std::size_t end = at_;  // behind the last that is not blank
        while (at_ < text_.size() && text_[at_] != '{' && text_[at_] != '}' && text_[at_] != ';') {
            if (text_[at_] == '\n' && !goes_on(text_.substr(begin, end - begin))) break;
            if (text_[at_] == '"') skip_quoted();
            const bool is_blank = is_space(text_[at_]);
            advance();
            if (!is_blank) end = at_;
        }
        return text_.substr(begin, end - begin);
    }

    // Leaves the closing quote.
    void skip_quoted() {
        const std::size_t first_line = line_;
        advance();
        while (at_ < text_.size() && text_[at_] != '"') advance();
        if (at_ >= text_.size()) refuse_at(false, first_line, "the file ends within quotes");
    }

    [[nodiscard]] bool goes_on(std::string_view values) const {
        std::size_t next = at_;
        while (next < text_.size() && is_space(text_[next])) ++next;
        const char c = next < text_.size() ? text_[next] : '}';
        if (c == ',' || c == '{' || values.ends_with(',')) return true;
        const bool is_blank = std::all_of(values.begin(), values.end(), is_space);
        return is_blank && (c == '-' || c == '+' || c == '.' || c == '"' || c == '*' || (c >= '0' && c <= '9'));
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    Tree tree_{false};
};

class BinaryParser {
public:
    explicit BinaryParser(std::string_view bytes) : bytes_(bytes), at_(binary_mark.size() + 2) {}

    // A footer that nobody needs follows the nodes.
    Document parse() {
        const std::uint64_t version = take(4);
        word_size_ = version >= 7500 ? 8 : 4;
        ends_.push_back(bytes_.size());
        while (read_node()) continue;
        return tree_.take();
    }

private:
    std::uint64_t take(std::size_t size) {
        if (bytes_.size() - std::min(at_, bytes_.size()) < size) refuse_at(true, at_, "the file ends within a node");
        std::uint64_t value = 0;
        std::memcpy(&value, bytes_.data() + at_, size);
        at_ += size;
        return value;
    }

    std::string_view take_bytes(std::uint64_t size) {
        if (size > ends_.back() - std::min<std::uint64_t>(at_, ends_.back()))
            refuse_at(true, at_, "a node reaches beyond its end");
        const std::string_view taken = bytes_.substr(at_, size);
        at_ += size;
        return taken;
    }

    // False behind the last one at the top.
    bool read_node() {
        while (ends_.size() > 1 && at_ >= ends_.back()) close();
        const std::size_t begin = at_;
        const std::uint64_t end = take(word_size_);
        (void)take(word_size_);
        const std::uint64_t size = take(word_size_);
        const std::uint64_t name_size = take(1);
        if (end == 0) {
            if (ends_.size() == 1) return false;
            at_ = ends_.back();
            return true;
        }
        if (end > ends_.back() || end <= begin) refuse_at(true, begin, "a node ends outside of what holds it");
        ends_.push_back(end);
        Node node;
        node.place = begin;
        node.name = take_bytes(name_size);
        node.values = take_bytes(size);
        tree_.add(node);
        tree_.open();
        return true;
    }

    void close() {
        ends_.pop_back();
        tree_.close();
    }

    std::string_view bytes_;
    std::size_t at_;
    std::size_t word_size_ = 4;
    std::vector<std::uint64_t> ends_;
    Tree tree_{true};
};

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
    return bytes.starts_with(binary_mark) ? BinaryParser(bytes).parse() : TextParser(bytes).parse();
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
