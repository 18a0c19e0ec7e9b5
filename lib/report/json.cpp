// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json.h"

#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "report/printable.h"

namespace crumple::report {

namespace {

using Package = nlohmann::ordered_json;

// Receives the parser's events and builds our tree, so that limits hold before memory is taken and a repeated key is
// seen (the package's own tree would keep the last one without a word).
class Builder : public nlohmann::json_sax<Package> {
public:
    Builder(std::string_view source, const ReadRules& rules) : source_(source), rules_(rules) {}

    bool null() override { return add(nullptr); }
    bool boolean(bool b) override { return add(b); }
    bool number_integer(std::int64_t i) override { return add(i); }
    bool number_unsigned(std::uint64_t u) override { return add(u); }
    bool number_float(double d, const std::string&) override { return add(d); }
    bool string(std::string& s) override { return add(std::move(s)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::Object{}); }
    bool start_array(std::size_t) override { return open(Json::List{}); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(std::string& name) override {
        if (!open_.back().keys.insert(name).second) {
            fail(shortened(path_with(name), 2 * longest_name) + ": the key is there twice");
        }
        open_.back().key = std::move(name);
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
        // "[json.exception.parse_error.101] parse error at line 3, column 7: ..." without the package's code.
        const std::string what = error.what();
        const std::size_t text = what.find("] ");
        fail(shortened(text == std::string::npos ? what : what.substr(text + 2), 4 * longest_name));
    }
    [[nodiscard]] Json take() { return std::move(root_); }

private:
    struct Open {
        Json value;
        std::string key;  // of the value that comes next, in an object
        std::set<std::string> keys;
    };

    bool add(Json value) {
        if (open_.empty()) {
            root_ = std::move(value);
        } else if (auto* list = std::get_if<Json::List>(&open_.back().value.value)) {
            list->push_back(std::move(value));
        } else {
            open_.back().value.add(open_.back().key, std::move(value));
        }
        return true;
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
        return add(std::move(value));
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

Package package_json(const Json& json);

struct ToPackage {
    template <class T>
    Package operator()(const T& value) const {
        return value;
    }
    Package operator()(const Json::List& list) const {
        Package json = Package::array();
        for (const Json& item : list) json.push_back(package_json(item));
        return json;
    }
    Package operator()(const Json::Object& object) const {
        Package json = Package::object();
        for (const auto& [key, child] : object) json[key] = package_json(child);
        return json;
    }
};

Package package_json(const Json& json) { return std::visit(ToPackage{}, json.value); }

}

double Json::number() const {
    if (const auto* i = get_if<std::int64_t>()) return static_cast<double>(*i);
    if (const auto* u = get_if<std::uint64_t>()) return static_cast<double>(*u);
    const auto* d = get_if<double>();
    return d ? *d : 0;
}

const char* Json::type_name() const {
    static constexpr std::array<const char*, 8> names{"null",   "boolean", "number", "number",
                                                      "number", "text",    "a list", "an object"};
    return names[value.index()];
}

const Json* Json::find(std::string_view key) const {
    const auto* object = get_if<Object>();
    if (!object) return nullptr;
    for (const auto& [name, child] : *object) {
        if (name == key) return &child;
    }
    return nullptr;
}

Json& Json::add(std::string key, Json child) {
    if (is_null()) value = Object{};
    std::get<Object>(value).emplace_back(std::move(key), std::move(child));
    return *this;
}

Json parse_json(std::string_view text, std::string_view source, const ReadRules& rules) {
    if (text.size() > rules.max_bytes) {
        throw Error(rules.kind,
                    std::string(source) + ": larger than " + std::to_string(rules.max_bytes) + " bytes of JSON");
    }
    Builder builder(source, rules);
    (void)Package::sax_parse(text.begin(), text.end(), &builder);
    return builder.take();
}

std::string dump_json(const Json& json, JsonStyle style) {
    constexpr auto replace = Package::error_handler_t::replace;
    const Package package = package_json(json);
    return style == JsonStyle::compact ? package.dump(-1, ' ', false, replace)
                                       : package.dump(2, ' ', false, replace) + "\n";
}

}
