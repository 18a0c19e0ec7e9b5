// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/xml_document.h"

#include <algorithm>

#include "core/error.h"
#include "importer/printable.h"
#include "importer/text.h"

namespace crumple::importer::xml {

namespace {

// Readers of the tree call themselves for each level.
constexpr std::size_t deepest = 2000;

bool is_blank(std::string_view text) { return std::all_of(text.begin(), text.end(), is_space); }

bool ends_name(char c) { return is_space(c) || c == '/' || c == '>' || c == '=' || c == '<'; }

// Extensible Markup Language 1.0, as far as it says where elements begin and end.
class Parser {
public:
    explicit Parser(std::string_view text) : text_(text) {}

    Document parse() {
        while (at_ < text_.size()) {
            const std::size_t mark = std::min(text_.find('<', at_), text_.size());
            add_text(take(mark - at_));
            if (at_ < text_.size()) read_markup();
        }
        if (!open_.empty()) refuse("the file ends within " + tag(document_[open_.back()]));
        if (document_.empty()) refuse("it has no XML element");
        return std::move(document_);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw Error(ErrorKind::bad_input, "line " + std::to_string(line_) + ": " + what +
                                              "; the XML is damaged or cut short: export the file again");
    }

    std::string_view take(std::size_t size) {
        const std::string_view taken = text_.substr(at_, size);
        at_ += taken.size();
        line_ += static_cast<std::size_t>(std::count(taken.begin(), taken.end(), '\n'));
        return taken;
    }

    // What stands before the end mark, which is passed.
    std::string_view take_until(std::string_view end, const char* what) {
        const std::size_t found = text_.find(end, at_);
        if (found == std::string_view::npos) refuse(std::string("the file ends within ") + what);
        const std::string_view taken = take(found - at_);
        (void)take(end.size());
        return taken;
    }

    bool passes(std::string_view mark) {
        if (!text_.substr(at_).starts_with(mark)) return false;
        (void)take(mark.size());
        return true;
    }

    void skip_space() {
        while (at_ < text_.size() && is_space(text_[at_])) (void)take(1);
    }

    void add_text(std::string_view piece) {
        if (open_.empty() || !document_[open_.back()].text.empty() || is_blank(piece)) return;
        document_[open_.back()].text = piece;
    }

    void read_markup() {
        if (passes("<!--")) {
            (void)take_until("-->", "a comment");
        } else if (passes("<![CDATA[")) {
            add_text(take_until("]]>", "a CDATA section"));
        } else if (passes("<?")) {
            (void)take_until("?>", "a processing instruction");
        } else if (passes("<!")) {
            skip_declaration();
        } else if (passes("</")) {
            close(take_until(">", "a closing tag"));
        } else {
            (void)take(1);
            open();
        }
    }

    // <!DOCTYPE ...>, whose own declarations stand in brackets.
    void skip_declaration() {
        int depth = 0;
        for (;;) {
            if (at_ >= text_.size()) refuse("the file ends within a declaration");
            const char c = take(1)[0];
            if (c == '"' || c == '\'') (void)take_until(std::string_view(&c, 1), "a declaration");
            if (c == '[') ++depth;
            if (c == ']') --depth;
            if (c == '>' && depth <= 0) return;
        }
    }

    std::string_view take_name() {
        std::size_t size = 0;
        while (at_ + size < text_.size() && !ends_name(text_[at_ + size])) ++size;
        if (size == 0) refuse("a name is missing");
        return take(size);
    }

    void open() {
        Element element;
        element.line = line_;
        element.name = take_name();
        bool is_empty = false;
        for (skip_space(); !passes(">"); skip_space()) {
            is_empty = passes("/>");
            if (is_empty) break;
            element.attributes.push_back(take_attribute());
        }
        if (open_.empty() && !document_.empty()) refuse("a second root, " + tag(element));
        const auto index = static_cast<Index>(document_.size());
        document_.push_back(std::move(element));
        last_child_.push_back(none);
        if (!open_.empty()) attach(index, open_.back());
        if (is_empty) return;
        open_.push_back(index);
        if (open_.size() > deepest) refuse("elements are nested more than " + std::to_string(deepest) + " deep");
    }

    void attach(Index child, Index parent) {
        Index& last = last_child_[parent];
        (last == none ? document_[parent].first_child : document_[last].next_sibling) = child;
        last = child;
    }

    Attribute take_attribute() {
        Attribute attribute;
        attribute.name = take_name();
        skip_space();
        if (!passes("=")) refuse("the attribute " + in_quotes(attribute.name) + " has no value");
        skip_space();
        const char quote = at_ < text_.size() ? take(1)[0] : ' ';
        if (quote != '"' && quote != '\'')
            refuse("the value of the attribute " + in_quotes(attribute.name) + " is not in quotes");
        attribute.value = take_until(std::string_view(&quote, 1), "the value of an attribute");
        return attribute;
    }

    void close(std::string_view name) {
        while (!name.empty() && is_space(name.back())) name.remove_suffix(1);
        if (open_.empty() || document_[open_.back()].name != name) {
            refuse("</" + printable(name) + "> closes " +
                   (open_.empty()
                        ? "nothing"
                        : tag(document_[open_.back()]) + " of line " + std::to_string(document_[open_.back()].line)));
        }
        open_.pop_back();
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    Document document_;
    std::vector<Index> last_child_;
    std::vector<Index> open_;
};

}

Document parse(std::string_view text) { return Parser(text).parse(); }

std::optional<std::string_view> attribute(const Element& element, std::string_view name) {
    for (const Attribute& attribute : element.attributes) {
        if (attribute.name == name) return attribute.value;
    }
    return std::nullopt;
}

std::string line(const Element& element) { return "line " + std::to_string(element.line) + ": "; }

std::string tag(const Element& element) {
    std::string text = "<";
    text.append(printable(element.name)).append(">");
    if (const auto id = attribute(element, "id")) text.append(" ").append(in_quotes(*id));
    return text;
}

Index find_child(const Document& document, Index parent, std::string_view name) {
    for (Index child = document[parent].first_child; child != none; child = document[child].next_sibling) {
        if (document[child].name == name) return child;
    }
    return none;
}

}
