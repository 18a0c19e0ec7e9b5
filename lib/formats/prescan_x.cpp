// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/index.h"
#include "formats/assimp_number.h"
#include "formats/prescan.h"
#include "formats/printable.h"
#include "formats/text.h"

namespace crumple::formats {

namespace {

bool is_separator(char c) { return is_space(c) || c == ';' || c == ','; }

// Words and braces of a DirectX X file in text; what separates them says nothing that their order does not.
class Words {
public:
    explicit Words(std::string_view text) : text_(text) {}

    // Empty at the end.
    std::string_view next() {
        skip();
        const std::size_t begin = at_;
        if (at_ >= text_.size()) return {};
        if (text_[at_] == '"' || text_[at_] == '<') return take_until(text_[at_] == '<' ? '>' : '"');
        if (is_brace(text_[at_])) return text_.substr(at_++, 1);
        while (at_ < text_.size() && !is_separator(text_[at_]) && !is_brace(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    [[noreturn]] void refuse(const std::string& what) const {
        throw Error(ErrorKind::bad_input, "line " + std::to_string(line_) + ": " + what +
                                              "; the file is damaged or cut short: export it again");
    }
    [[nodiscard]] std::size_t line() const { return line_; }

private:
    static bool is_brace(char c) { return c == '{' || c == '}'; }

    void skip() {
        while (at_ < text_.size() && (is_separator(text_[at_]) || text_[at_] == '#' || is_slash_comment())) {
            if (is_separator(text_[at_])) {
                line_ += text_[at_++] == '\n';
            } else {
                while (at_ < text_.size() && text_[at_] != '\n') ++at_;
            }
        }
    }
    [[nodiscard]] bool is_slash_comment() const { return text_.substr(at_).starts_with("//"); }

    std::string_view take_until(char end) {
        const std::size_t begin = at_;
        const std::size_t found = text_.find(end, begin + 1);
        if (found == std::string_view::npos) refuse(std::string("the file ends before ") + end);
        for (; at_ <= found; ++at_) line_ += text_[at_] == '\n';
        return text_.substr(begin, at_ - begin);
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

// Direct3D 9, "X file format reference": Mesh { vertex count; vertices; face count; faces; ... } and in it
// MeshVertexColors { count; index; red; green; blue; alpha; ... }, an index for each vertex.
class Reader {
public:
    Reader(std::string_view text, Purpose purpose) : words_(text), purpose_(purpose) {}

    void read() {
        for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
            if (word == "{") {
                open();
            } else if (word == "}") {
                close();
            } else {
                note(word);
            }
        }
        if (!open_lines_.empty())
            words_.refuse("the file ends within what begins in line " + std::to_string(open_lines_.back()));
    }

private:
    // An object is "Type {" or "Type name {", and a name may be a word that is a type elsewhere.
    void note(std::string_view word) {
        const bool is_number = word[0] == '-' || word[0] == '+' || word[0] == '.' || (word[0] >= '0' && word[0] <= '9');
        if (is_number)
            type_ = name_ = {};
        else if (type_.empty())
            type_ = word;
        else if (name_.empty())
            name_ = word;
        else
            type_ = std::exchange(name_, word);
    }

    void open() {
        open_lines_.push_back(words_.line());
        const std::string_view type = type_;
        type_ = name_ = {};
        if (type == "template") skip_template();
        if (type == "Mesh") read_mesh();
        if (type == "MeshVertexColors" && purpose_ == Purpose::shell) read_colors();
    }

    void close() {
        if (open_lines_.empty()) words_.refuse("a brace closes nothing");
        open_lines_.pop_back();
        type_ = name_ = {};
    }

    void skip_template() {
        for (std::string_view word = words_.next(); word != "}"; word = words_.next()) {
            if (word.empty()) words_.refuse("the file ends within a template");
        }
        close();
    }

    Index next_index(const char* what) {
        const std::string_view word = words_.next();
        const auto value = to_number<Index>(word);
        if (word.empty()) words_.refuse(std::string("the file ends where ") + what + " should stand");
        if (!value) words_.refuse(in_quotes(word) + " stands where " + what + " should");
        return *value;
    }

    void skip_reals(std::uint64_t count) {
        for (std::uint64_t i = 0; i < count; ++i) {
            const std::string_view word = words_.next();
            if (word.empty() || word == "{" || word == "}") words_.refuse("a number is missing");
            // "-1.#IND" and its like, of which assimp makes 0: a lock.
            const auto value = to_number<double>(word);
            if (!value) words_.refuse(in_quotes(word) + " stands where a number should");
            if (is_misread(word, *value)) words_.refuse("the reader makes something else of " + in_quotes(word));
        }
    }

    void read_mesh() {
        vertex_count_ = next_index("a mesh's number of vertices");
        skip_reals(std::uint64_t{3} * vertex_count_);
        const Index faces = next_index("a mesh's number of faces");
        for (Index face = 0; face < faces; ++face) {
            const Index corners = next_index("a face's number of corners");
            for (Index corner = 0; corner < corners; ++corner) {
                const Index vertex = next_index("a face's vertex");
                if (vertex >= vertex_count_)
                    words_.refuse("a face names vertex " + std::to_string(vertex) + " of " +
                                  std::to_string(vertex_count_));
            }
        }
    }

    void read_colors() {
        const Index count = next_index("MeshVertexColors' number of colours");
        if (count != vertex_count_)
            words_.refuse("MeshVertexColors announces " + std::to_string(count) + " colours for " +
                          std::to_string(vertex_count_) + " vertices");
        std::vector<bool> has_color(count, false);
        for (Index i = 0; i < count; ++i) {
            const Index vertex = next_index("the index of a coloured vertex");
            if (vertex >= count)
                words_.refuse("MeshVertexColors names vertex " + std::to_string(vertex) + " of " +
                              std::to_string(count));
            if (has_color[vertex])
                words_.refuse("MeshVertexColors gives vertex " + std::to_string(vertex) +
                              " a second colour, so another vertex has none");
            has_color[vertex] = true;
            skip_reals(4);
        }
    }

    Words words_;
    Purpose purpose_;
    std::vector<std::size_t> open_lines_;
    std::string_view type_;  // the words since the last brace or number, two at most
    std::string_view name_;
    Index vertex_count_ = 0;  // of the mesh read last
};

}

Prescan prescan_x(std::string_view bytes, Purpose purpose) {
    // "xof 0303txt 0032"; the other kinds are binary or compressed.
    constexpr std::size_t header_size = 16;
    const bool is_text = bytes.starts_with("xof ") && bytes.substr(8).starts_with("txt ");
    if (is_text) Reader(bytes.substr(header_size), purpose).read();
    return prescan_numbers(bytes);
}

}
