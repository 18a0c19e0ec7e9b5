// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_reader.h"

#include <algorithm>
#include <cmath>

#include "core/names.h"
#include "report/number_text.h"
#include "report/printable.h"

namespace crumple::report {

namespace {

// Walks JSON and struct side by side, knowing where it is for the messages.
class Reader {
public:
    Reader(std::string_view source, const ReadRules& rules) : source_(source), rules_(rules) {}

    void read(const Json& json, Described value, Range range, const std::string& path) const;
    [[noreturn]] void fail(const std::string& path, const std::string& what) const {
        throw Error(rules_.kind, shortened(source_, 2 * longest_name) + ": " +
                                     (path.empty() ? "" : shortened(path, 2 * longest_name) + ": ") + what);
    }
    [[noreturn]] void fail_name(const std::string& parent, const std::string& name,
                                const std::vector<std::string>& valid, bool is_key) const;

private:
    void read_object(const Json& json, Described value, const std::string& path) const;
    void read_list(const Json& json, Described value, Range range, const std::string& path) const;
    void read_map(const Json& json, Described value, Range range, const std::string& path) const;
    void read_integer(const Json& json, Described value, Range range, const std::string& path) const;
    void read_number(const Json& json, Described value, Range range, const std::string& path) const;
    void read_vector(const Json& json, Described value, Range range, const std::string& path) const;
    void read_choice(const Json& json, Described value, const std::string& path) const;
    double checked_number(const Json& json, bool is_single, Range range, const std::string& path) const;
    [[noreturn]] void fail_type(const Json& json, const std::string& path, const char* expected) const {
        fail(path, std::string("expected ") + expected + ", found " + json.type_name() + excerpt(json));
    }
    static std::string excerpt(const Json& json) {
        if (json.is_null() || json.get_if<Json::List>() || json.get_if<Json::Object>()) return {};
        const std::string text = dump_json(json, JsonStyle::compact);
        return " " + shortened(text, longest_name / 2);
    }

    std::string source_;
    ReadRules rules_;
};

std::string joined(const std::string& path, const std::string& name) { return path.empty() ? name : path + "." + name; }

std::string range_text(Range range) { return number_text(range.min) + " to " + number_text(range.max); }

std::vector<std::string> names_of(const std::vector<Field>& fields) {
    std::vector<std::string> names;
    for (const Field& field : fields) names.push_back(field.name);
    return names;
}

void Reader::fail_name(const std::string& parent, const std::string& name, const std::vector<std::string>& valid,
                       bool is_key) const {
    const std::string nearest = nearest_name(name, valid);
    if (!is_key) {
        fail(parent, "'" + shortened(name, longest_name) + "' is not one of " + list_names(valid) + "; nearest: '" +
                         nearest + "'");
    }
    fail(joined(parent, name), valid.empty() ? std::string("unknown key; no keys are valid here")
                                             : "unknown key; nearest valid name: '" + joined(parent, nearest) +
                                                   "' (valid here: " + list_names(valid) + ")");
}

void Reader::read(const Json& json, Described value, Range range, const std::string& path) const {
    switch (value.kind()) {
        case Kind::boolean:
            if (!json.get_if<bool>()) fail_type(json, path, "true or false");
            (void)value.set(*json.get_if<bool>());
            return;
        case Kind::integer:
            return read_integer(json, value, range, path);
        case Kind::number:
            return read_number(json, value, range, path);
        case Kind::text:
            if (!json.get_if<std::string>()) fail_type(json, path, "text");
            (void)value.set(*json.get_if<std::string>());
            return;
        case Kind::vector3:
            return read_vector(json, value, range, path);
        case Kind::choice:
            return read_choice(json, value, path);
        case Kind::object:
            return read_object(json, value, path);
        case Kind::list:
            return read_list(json, value, range, path);
        case Kind::map:
            return read_map(json, value, range, path);
        case Kind::raw:
            (void)value.set(dump_json(json, JsonStyle::compact));
            return;
    }
}

void Reader::read_object(const Json& json, Described value, const std::string& path) const {
    const auto* object = json.get_if<Json::Object>();
    if (!object) fail_type(json, path, "an object");
    const std::vector<Field> fields = value.fields();
    for (const auto& member : *object) {
        const std::string& key = member.first;
        const Json& child = member.second;
        if (path.empty() && key == "$schema") {
            if (!child.get_if<std::string>()) fail_type(child, key, "the path of a schema as text");
            continue;
        }
        const auto field = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == key; });
        if (field == fields.end()) fail_name(path, key, names_of(fields), true);
        read(child, field->value, field->range, joined(path, key));
    }
}

void Reader::read_list(const Json& json, Described value, Range range, const std::string& path) const {
    const auto* list = json.get_if<Json::List>();
    if (!list) fail_type(json, path, "a list");
    const std::size_t fixed = value.type().fixed_size;
    if (fixed != 0 && list->size() != fixed) {
        fail(path, "expected " + std::to_string(fixed) + " values, found " + std::to_string(list->size()));
    }
    value.resize(0);  // so that elements start from their defaults
    value.resize(list->size());
    for (std::size_t i = 0; i < list->size(); ++i) {
        read((*list)[i], value.item(i), range, path + "[" + std::to_string(i) + "]");
    }
}

void Reader::read_map(const Json& json, Described value, Range range, const std::string& path) const {
    const auto* object = json.get_if<Json::Object>();
    if (!object) fail_type(json, path, "an object");
    value.clear();
    for (const auto& [key, child] : *object) read(child, value.entry(key), range, joined(path, key));
}

void Reader::read_integer(const Json& json, Described value, Range range, const std::string& path) const {
    if (json.is_null() && rules_.allows_null && value.type().is_index) {
        (void)value.set(std::uint64_t{none});
        return;
    }
    if (!json.is_integer()) fail_type(json, path, "a whole number");
    const auto* i = json.get_if<std::int64_t>();
    const bool fits = value.set(i ? Scalar(*i) : Scalar(*json.get_if<std::uint64_t>()));
    const double number = json.number();
    if (!fits || number < range.min || number > range.max) {
        const Range limits{std::max(range.min, value.type().lowest), std::min(range.max, value.type().highest)};
        fail(path, dump_json(json, JsonStyle::compact) + " is out of range; allowed: " + range_text(limits));
    }
}

double Reader::checked_number(const Json& json, bool is_single, Range range, const std::string& path) const {
    if (json.is_null() && rules_.allows_null) return std::numeric_limits<double>::quiet_NaN();
    if (!json.is_number()) fail_type(json, path, "a number");
    const double number = json.number();
    const bool is_finite = std::isfinite(is_single ? static_cast<double>(static_cast<float>(number)) : number);
    if (!is_finite || number < range.min || number > range.max) {
        fail(path, dump_json(json, JsonStyle::compact) + " is out of range; allowed: " + range_text(range));
    }
    return number;
}

void Reader::read_number(const Json& json, Described value, Range range, const std::string& path) const {
    (void)value.set(checked_number(json, value.type().is_single, range, path));
}

void Reader::read_vector(const Json& json, Described value, Range range, const std::string& path) const {
    const auto* list = json.get_if<Json::List>();
    if (!list || list->size() != 3) fail_type(json, path, "a list of three numbers");
    Vec3 vector;
    for (int axis = 0; axis < 3; ++axis) {
        vector[axis] = checked_number((*list)[static_cast<std::size_t>(axis)], value.type().is_single, range,
                                      path + "[" + std::to_string(axis) + "]");
    }
    (void)value.set(vector);
}

void Reader::read_choice(const Json& json, Described value, const std::string& path) const {
    const auto* name = json.get_if<std::string>();
    if (!name) fail_type(json, path, "text");
    if (value.set(*name)) return;
    const auto choices = value.type().choices();
    fail_name(path, *name, std::vector<std::string>(choices.begin(), choices.end()), false);
}

bool is_leaf(Kind kind) { return kind != Kind::object && kind != Kind::list && kind != Kind::map; }

struct Target {
    Field field;
    std::string path;
};

// Follows "bake.materials.steel.young_pa" from the root to the field it names.
Target find_target(std::string_view path, Described root, const Reader& reader) {
    Target at{{"", "", {}, root}, ""};
    std::size_t begin = 0;
    while (begin <= path.size()) {
        const bool takes_rest = at.field.value.kind() == Kind::map && is_leaf(at.field.value.example().kind());
        const std::size_t end = takes_rest ? path.size() : std::min(path.find('.', begin), path.size());
        const std::string name(path.substr(begin, end - begin));
        if (at.field.value.kind() == Kind::map) {
            at = {{name, at.field.help, at.field.range, at.field.value.entry(name)}, joined(at.path, name)};
        } else if (at.field.value.kind() == Kind::object) {
            const std::vector<Field> fields = at.field.value.fields();
            const auto field =
                std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
            if (field == fields.end()) reader.fail_name(at.path, name, names_of(fields), true);
            at = {*field, joined(at.path, name)};
        } else {
            reader.fail(at.path, "has no fields; write " + at.path + "=VALUE");
        }
        begin = end + 1;
    }
    return at;
}

const char* name_of_kind(Kind kind) {
    switch (kind) {
        case Kind::boolean:
            return "true or false";
        case Kind::integer:
            return "a whole number";
        case Kind::number:
            return "a number";
        default:
            return "JSON";
    }
}

// Text needs no quotes; with quotes it is read as JSON reads it.
Json setting_json(std::string_view text, const Target& target, const Reader& reader) {
    const Kind kind = target.field.value.kind();
    const bool is_quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    if ((kind == Kind::text || kind == Kind::choice) && !is_quoted) return Json(std::string(text));
    try {
        return parse_json(text, "");
    } catch (const Error&) {
        const std::string found = text.empty() ? "nothing" : shortened(text, longest_name / 2);
        reader.fail(target.path, std::string("expected ") + name_of_kind(kind) + ", found " + found);
    }
}

}

void read_json(std::string_view text, std::string_view source, Described value, const ReadRules& rules) {
    const Json json = parse_json(text, source, rules);
    Reader(source, rules).read(json, value, {}, "");
}

void apply_setting(std::string_view setting, Described root, std::string_view option) {
    const Reader reader(option.empty() ? "--set " + std::string(setting) : std::string(option), {});
    const std::size_t equals = setting.find('=');
    if (equals == std::string_view::npos || equals == 0)
        reader.fail("", "write it as path=value, for example relax.sweeps=5");
    const Target target = find_target(setting.substr(0, equals), root, reader);
    const Json json = setting_json(setting.substr(equals + 1), target, reader);
    reader.read(json, target.field.value, target.field.range, target.path);
}

}
