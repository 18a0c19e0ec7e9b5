// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/xml_document.h"

#include <algorithm>

#include <pugixml.hpp>

#include "core/error.h"
#include "formats/printable.h"
#include "formats/text.h"

namespace crumple::formats::xml {

namespace {

// Readers of the tree call themselves for each level.
constexpr int deepest = 2000;

// Nothing that would change or move what it reads: places in pugixml's copy are places in the text.
constexpr unsigned as_written = pugi::parse_cdata;

[[noreturn]] void refuse(std::size_t line, const std::string& what) {
    throw Error(ErrorKind::bad_input, "line " + std::to_string(line) + ": " + what + ": export the file again");
}

std::size_t lines_in(std::string_view text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

bool is_blank(std::string_view text) { return std::all_of(text.begin(), text.end(), is_space); }

// Takes pugixml's tree over as views into the text.
class Takeover : public pugi::xml_tree_walker {
public:
    explicit Takeover(std::string_view text) : text_(text) {}

    bool for_each(pugi::xml_node& node) override {
        if (node.type() == pugi::node_element) add_element(node);
        if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata) add_text(view(node.value()));
        return true;
    }

    Document document;

private:
    [[nodiscard]] std::string_view view(const char* text) const {
        return text_.substr(static_cast<std::size_t>(text - copy_), std::string_view(text).size());
    }

    void add_element(const pugi::xml_node& node) {
        if (copy_ == nullptr) copy_ = node.name() - node.offset_debug();
        const auto index = static_cast<Index>(document.size());
        const auto level = static_cast<std::size_t>(depth());
        Element& element = document.emplace_back();
        element.name = view(node.name());
        element.line = line_at(element.name.data());
        for (const pugi::xml_attribute& attribute : node.attributes())
            element.attributes.push_back({view(attribute.name()), view(attribute.value())});
        if (level == 0 && index > 0) refuse(element.line, "a second root, " + tag(element));
        if (depth() > deepest)
            refuse(element.line, "elements are nested more than " + std::to_string(deepest) + " deep");
        open_.resize(level);
        if (level > 0) attach(index, open_.back());
        open_.push_back(index);
        last_child_.push_back(none);
    }

    void attach(Index child, Index parent) {
        Index& last = last_child_[parent];
        (last == none ? document[parent].first_child : document[last].next_sibling) = child;
        last = child;
    }

    void add_text(std::string_view piece) {
        std::string_view& text = document[open_[static_cast<std::size_t>(depth()) - 1]].text;
        if (text.empty() && !is_blank(piece)) text = piece;
    }

    // Elements come in the order of the text.
    std::size_t line_at(const char* place) {
        const auto at = static_cast<std::size_t>(place - text_.data());
        line_ += lines_in(text_.substr(counted_, at - counted_));
        counted_ = at;
        return line_;
    }

    std::string_view text_;
    const char* copy_ = nullptr;  // the text as pugixml holds it
    std::vector<Index> open_;     // of each level, the newest
    std::vector<Index> last_child_;
    std::size_t counted_ = 0;  // so far lines were counted
    std::size_t line_ = 1;
};

}

Document parse(std::string_view text) {
    pugi::xml_document tree;
    const pugi::xml_parse_result result = tree.load_buffer(text.data(), text.size(), as_written, pugi::encoding_utf8);
    if (!result)
        refuse(1 + lines_in(text.substr(0, static_cast<std::size_t>(result.offset))),
               std::string("the XML is damaged or cut short: ") + result.description());
    Takeover takeover(text);
    (void)tree.traverse(takeover);
    return std::move(takeover.document);
}

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
