// SPDX-License-Identifier: GPL-3.0-or-later
// A JSON tree of ours, so that no header needs a package: what parse_json gives and dump_json takes.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.h"

namespace crumple::report {

struct Json {
    using List = std::vector<Json>;
    using Object = std::vector<std::pair<std::string, Json>>;  // in order; parse_json lets no key repeat

    std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, List, Object> value = nullptr;

    Json() = default;
    template <class T>
    requires(!std::same_as<std::remove_cvref_t<T>, Json>) Json(T&& v)
        : value(std::forward<T>(v)) {}  // NOLINT: a value is a tree of one node

    template <class T>
    [[nodiscard]] const T* get_if() const {
        return std::get_if<T>(&value);
    }
    [[nodiscard]] bool is_null() const { return std::holds_alternative<std::nullptr_t>(value); }
    [[nodiscard]] bool is_integer() const { return get_if<std::int64_t>() || get_if<std::uint64_t>(); }
    [[nodiscard]] bool is_number() const { return is_integer() || get_if<double>(); }
    [[nodiscard]] double number() const;                         // 0 when it is none
    [[nodiscard]] const char* type_name() const;                 // "text", "a list", ...
    [[nodiscard]] const Json* find(std::string_view key) const;  // null where absent, or when this is no object

    // Appends to an object, made out of null; the key must be new.
    Json& add(std::string key, Json child);
};

enum class JsonStyle {
    indented,  // for files and people, ends in a newline
    compact,   // one line without spaces: canonical text, lines of progress
};

// The rules for text from outside.
struct ReadRules {
    ErrorKind kind = ErrorKind::usage;  // of the Error thrown
    bool allows_null = false;           // reports: null is none for an index and not-a-number for a number
    std::size_t max_bytes = 1u << 26;
    int max_depth = 64;
};

// Throws Error(rules.kind) for broken text (with line and column), a repeated key (with its path), too much or too
// deep; the limits hold before memory is taken. `source` names the text in messages.
[[nodiscard]] Json parse_json(std::string_view text, std::string_view source, const ReadRules& rules = {});

// Same tree, same bytes. Names come from artists' files in any encoding: what is not UTF-8 is replaced.
[[nodiscard]] std::string dump_json(const Json& json, JsonStyle style);

}
