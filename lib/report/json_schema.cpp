// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_schema.h"

#include <cmath>

#include "report/json_build.h"

namespace crumple::report {

namespace {

Json limit_json(double limit) {
    const bool is_whole = limit == std::floor(limit) && std::fabs(limit) < 0x1p53;
    return is_whole ? Json(static_cast<std::int64_t>(limit)) : Json(limit);
}

void add_limits(Json& schema, double low, double high) {
    if (std::isfinite(low)) schema["minimum"] = limit_json(low);
    if (std::isfinite(high)) schema["maximum"] = limit_json(high);
}

Json type_json(const char* type, bool may_be_null) { return may_be_null ? Json::array({type, "null"}) : Json(type); }

Json number_schema(Range range, SchemaUse use) {
    Json schema;
    schema["type"] = type_json("number", use == SchemaUse::output);
    add_limits(schema, range.min, range.max);
    return schema;
}

Json integer_schema(const TypeInfo& type, Range range, SchemaUse use) {
    Json schema;
    schema["type"] = type_json("integer", use == SchemaUse::output && type.is_index);
    // The limits of the 64-bit types are not doubles; leaving them out says the same.
    const bool is_wide = type.highest > 0x1p53;
    const double lowest = is_wide && type.lowest < 0 ? range.min : std::max(range.min, type.lowest);
    add_limits(schema, lowest, is_wide ? range.max : std::min(range.max, type.highest));
    return schema;
}

Json schema_of(Described value, Range range, SchemaUse use);

Json object_schema(Described value, SchemaUse use) {
    Json schema;
    schema["type"] = "object";
    Json properties = Json::object();
    Json required = Json::array();
    for (const Field& field : value.fields()) {
        Json property = schema_of(field.value, field.range, use);
        if (!field.help.empty()) property["description"] = field.help;
        if (use == SchemaUse::input && field.value.kind() != Kind::object)
            property["default"] = build_json(field.value);
        properties[field.name] = std::move(property);
        required.push_back(field.name);
    }
    schema["properties"] = std::move(properties);
    if (use == SchemaUse::output && !required.empty()) schema["required"] = std::move(required);
    schema["additionalProperties"] = false;
    return schema;
}

Json list_schema(Json item, std::size_t fixed_size) {
    Json schema;
    schema["type"] = "array";
    schema["items"] = std::move(item);
    if (fixed_size > 0) schema["minItems"] = schema["maxItems"] = fixed_size;
    return schema;
}

Json choice_schema(Described value) {
    Json schema;
    schema["type"] = "string";
    schema["enum"] = Json::array();
    for (const std::string_view name : value.type().choices()) schema["enum"].push_back(std::string(name));
    return schema;
}

Json schema_of(Described value, Range range, SchemaUse use) {
    switch (value.kind()) {
        case Kind::boolean:
            return {{"type", "boolean"}};
        case Kind::integer:
            return integer_schema(value.type(), range, use);
        case Kind::number:
            return number_schema(range, use);
        case Kind::text:
            return {{"type", "string"}};
        case Kind::choice:
            return choice_schema(value);
        case Kind::vector3:
            return list_schema(number_schema(range, use), 3);
        case Kind::list:
            return list_schema(schema_of(value.example(), range, use), value.type().fixed_size);
        case Kind::map:
            return {{"type", "object"}, {"additionalProperties", schema_of(value.example(), range, use)}};
        case Kind::object:
            return object_schema(value, use);
        case Kind::raw:
            break;
    }
    return Json::object();  // anything
}

}

std::string write_schema(Described example, const SchemaTitle& title, SchemaUse use) {
    Json schema;
    schema["$schema"] = "http://json-schema.org/draft-07/schema#";
    schema["$id"] = "crumple/" + std::string(title.id) + ".schema.json";
    schema["title"] = std::string(title.title);
    schema["description"] = std::string(title.description);
    Json body = schema_of(example, {}, use);
    if (use == SchemaUse::input) body["properties"]["$schema"] = {{"type", "string"}};
    for (auto& [key, value] : body.items()) schema[key] = std::move(value);
    return dump_json(schema, JsonStyle::indented);
}

}
