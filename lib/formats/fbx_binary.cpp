// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstring>

#include "formats/fbx_tree.h"

namespace crumple::formats::fbx {

namespace {

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

}

Document parse_binary(std::string_view bytes) { return BinaryParser(bytes).parse(); }

}
