// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "formats/fbx_tree.h"
#include "formats/printable.h"
#include "formats/text.h"

namespace crumple::formats::fbx {

namespace {

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

}

Document parse_text(std::string_view text) { return TextParser(text).parse(); }

}
