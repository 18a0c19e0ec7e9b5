// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_schema.h"

#include <algorithm>
#include <cmath>

#include "report/json_writer.h"

namespace crumple::report {

namespace {

Json limit_json(double limit) {
    const bool is_whole = limit == std::floor(limit) && std::fabs(limit) < 0x1p53;
    return is_whole ? Json(static_cast<std::int64_t>(limit)) : Json(limit);
}

void add_limits(Json& schema, double low, double high) {
    if (std::isfinite(low)) schema.add("minimum", limit_json(low));
    if (std::isfinite(high)) schema.add("maximum", limit_json(high));
}

Json text(std::string_view words) { return std::string(words); }

Json type_schema(std::string_view type, bool may_be_null = false) {
    return Json().add("type", may_be_null ? Json(Json::List{text(type), text("null")}) : text(type));
}

Json number_schema(Range range, SchemaUse use) {
    Json schema = type_schema("number", use == SchemaUse::output);
    add_limits(schema, range.min, range.max);
    return schema;
}

Json integer_schema(const TypeInfo& type, Range range, SchemaUse use) {
    Json schema = type_schema("integer", use == SchemaUse::output && type.is_index);
    // The limits of the 64-bit types are not doubles; leaving them out says the same.
    const bool is_wide = type.highest > 0x1p53;
    const double lowest = is_wide && type.lowest < 0 ? range.min : std::max(range.min, type.lowest);
    add_limits(schema, lowest, is_wide ? range.max : std::min(range.max, type.highest));
    return schema;
}

Json schema_of(Described value, Range range, SchemaUse use);

Json object_schema(Described value, SchemaUse use, bool is_root) {
    Json::Object properties;
    Json::List required;
    if (is_root && use == SchemaUse::input) properties.emplace_back("$schema", type_schema("string"));
    for (const Field& field : value.fields()) {
        Json property = schema_of(field.value, field.range, use);
        if (!field.pattern.empty()) property.add("pattern", text(field.pattern));
        if (!field.help.empty()) property.add("description", text(field.help));
        if (use == SchemaUse::input && field.value.kind() != Kind::object)
            property.add("default", build_json(field.value));
        properties.emplace_back(field.name, std::move(property));
        required.push_back(text(field.name));
    }
    Json schema = type_schema("object");
    schema.add("properties", std::move(properties));
    if (use == SchemaUse::output && !required.empty()) schema.add("required", std::move(required));
    schema.add("additionalProperties", false);
    return schema;
}

Json list_schema(Json item, std::size_t fixed_size) {
    Json schema = type_schema("array");
    schema.add("items", std::move(item));
    if (fixed_size > 0) schema.add("minItems", std::uint64_t{fixed_size}).add("maxItems", std::uint64_t{fixed_size});
    return schema;
}

Json choice_schema(Described value) {
    Json::List names;
    for (const std::string_view name : value.type().choices()) names.push_back(text(name));
    return type_schema("string").add("enum", std::move(names));
}

Json schema_of(Described value, Range range, SchemaUse use) {
    switch (value.kind()) {
        case Kind::boolean:
            return type_schema("boolean");
        case Kind::integer:
            return integer_schema(value.type(), range, use);
        case Kind::number:
            return number_schema(range, use);
        case Kind::text:
            return type_schema("string");
        case Kind::choice:
            return choice_schema(value);
        case Kind::vector3:
            return list_schema(number_schema(range, use), 3);
        case Kind::list:
            return list_schema(schema_of(value.example(), range, use), value.type().fixed_size);
        case Kind::map:
            return type_schema("object").add("additionalProperties", schema_of(value.example(), range, use));
        case Kind::object:
            return object_schema(value, use, false);
        case Kind::raw:
            break;
    }
    return Json::Object{};  // anything
}

}

std::string write_schema(Described example, const SchemaTitle& title, SchemaUse use) {
    Json schema;
    schema.add("$schema", text("http://json-schema.org/draft-07/schema#"));
    schema.add("$id", text("crumple/" + std::string(title.id) + ".schema.json"));
    schema.add("title", text(title.title));
    schema.add("description", text(title.description));
    Json body = object_schema(example, use, true);
    for (auto& [key, child] : std::get<Json::Object>(body.value)) schema.add(key, std::move(child));
    return dump_json(schema, JsonStyle::indented);
}

}
