// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_parse.h"

#include <set>
#include <vector>

namespace crumple::report {

namespace {

// Receives the parser's events and builds the tree, so that limits hold before memory is taken and a repeated key is
// seen (the package's own tree would keep the last one without a word).
class Builder : public nlohmann::json_sax<Json> {
public:
    Builder(std::string_view source, const ReadRules& rules) : source_(source), rules_(rules) {}

    bool null() override { return add(nullptr); }
    bool boolean(bool b) override { return add(b); }
    bool number_integer(std::int64_t i) override { return add(i); }
    bool number_unsigned(std::uint64_t u) override { return add(u); }
    bool number_float(double d, const std::string&) override { return add(d); }
    bool string(std::string& s) override { return add(std::move(s)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(std::string& name) override {
        if (!open_.back().keys.insert(name).second) fail(path_with(name) + ": the key is there twice");
        open_.back().key = std::move(name);
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
        // "[json.exception.parse_error.101] parse error at line 3, column 7: ..." without the package's code.
        const std::string what = error.what();
        const std::size_t text = what.find("] ");
        fail(text == std::string::npos ? what : what.substr(text + 2));
    }
    [[nodiscard]] Json take() { return std::move(root_); }

private:
    struct Open {
        Json value;
        std::string key;  // of the value that comes next, in an object
        std::set<std::string> keys;
    };

    template <class T>
    bool add(T&& value) {
        attach(Json(std::forward<T>(value)));
        return true;
    }
    void attach(Json value) {
        if (open_.empty()) {
            root_ = std::move(value);
        } else if (open_.back().value.is_array()) {
            open_.back().value.push_back(std::move(value));
        } else {
            // Keys are known to differ, and ordered_json's own insertion searches all earlier keys.
            auto& object = open_.back().value.get_ref<Json::object_t&>();
            object.Container::emplace_back(open_.back().key, std::move(value));
        }
    }
    bool open(Json value) {
        if (open_.size() >= static_cast<std::size_t>(rules_.max_depth)) {
            fail("nested deeper than " + std::to_string(rules_.max_depth) + " levels");
        }
        open_.push_back({std::move(value), {}, {}});
        return true;
    }
    bool close() {
        Json value = std::move(open_.back().value);
        open_.pop_back();
        attach(std::move(value));
        return true;
    }
    [[nodiscard]] std::string path_with(const std::string& name) const {
        std::string path;
        for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
            if (!open_[i].key.empty()) path += open_[i].key + ".";
        }
        return path + name;
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(rules_.kind, std::string(source_) + ": " + what);
    }

    std::string_view source_;
    const ReadRules& rules_;
    std::vector<Open> open_;
    Json root_;
};

}

Json parse_json(std::string_view text, std::string_view source, const ReadRules& rules) {
    if (text.size() > rules.max_bytes) {
        throw Error(rules.kind,
                    std::string(source) + ": larger than " + std::to_string(rules.max_bytes) + " bytes of JSON");
    }
    Builder builder(source, rules);
    (void)Json::sax_parse(text.begin(), text.end(), &builder);
    return builder.take();
}

}
