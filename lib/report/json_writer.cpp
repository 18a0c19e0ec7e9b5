// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_writer.h"

#include <charconv>
#include <cmath>

#include "report/json_build.h"
#include "report/json_parse.h"
#include "report/number_text.h"

namespace crumple::report {

namespace {

Json number_json(double number, bool is_single) {
    if (!std::isfinite(number)) return nullptr;
    if (!is_single) return number;
    // A float widened to double would print noise digits: write the double that its own shortest digits name.
    const std::string text = float_text(static_cast<float>(number));
    double shortest = 0;
    std::from_chars(text.data(), text.data() + text.size(), shortest);
    return shortest;
}

Json integer_json(const Scalar& scalar, bool is_index) {
    if (const auto* i = std::get_if<std::int64_t>(&scalar)) return *i;
    const auto u = std::get<std::uint64_t>(scalar);
    return is_index && u == none ? Json(nullptr) : Json(u);
}

Json raw_json(const std::string& text) {
    const ReadRules rules{.kind = ErrorKind::bad_input};
    return parse_json(text, "stored JSON", rules);
}

}

Json build_json(Described value) {
    Json json;
    switch (value.kind()) {
        case Kind::boolean:
            return std::get<bool>(value.get());
        case Kind::integer:
            return integer_json(value.get(), value.type().is_index);
        case Kind::number:
            return number_json(std::get<double>(value.get()), value.type().is_single);
        case Kind::text:
        case Kind::choice:
            return std::get<std::string>(value.get());
        case Kind::raw:
            return raw_json(std::get<std::string>(value.get()));
        case Kind::vector3: {
            const Vec3 v = std::get<Vec3>(value.get());
            for (int axis = 0; axis < 3; ++axis) json.push_back(number_json(v[axis], value.type().is_single));
            return json;
        }
        case Kind::list:
            json = Json::array();
            for (std::size_t i = 0; i < value.size(); ++i) json.push_back(build_json(value.item(i)));
            return json;
        case Kind::map:
            json = Json::object();
            for (const std::string& key : value.keys()) json[key] = build_json(value.entry(key));
            return json;
        case Kind::object:
            json = Json::object();
            for (const Field& field : value.fields()) json[field.name] = build_json(field.value);
            return json;
    }
    return json;
}

// Names come from artists' files, in any encoding: what is not UTF-8 is replaced, never thrown at.
std::string dump_json(const Json& json, JsonStyle style) {
    constexpr auto replace = Json::error_handler_t::replace;
    return style == JsonStyle::compact ? json.dump(-1, ' ', false, replace) : json.dump(2, ' ', false, replace) + "\n";
}

std::string write_json(Described value, JsonStyle style) { return dump_json(build_json(value), style); }

}
