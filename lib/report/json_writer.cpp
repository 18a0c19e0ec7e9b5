// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_writer.h"

#include <charconv>
#include <cmath>

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

Json build_list(Described value) {
    Json::List list;
    for (std::size_t i = 0; i < value.size(); ++i) list.push_back(build_json(value.item(i)));
    return list;
}

Json build_vector(Vec3 v, bool is_single) {
    return Json::List{number_json(v.x, is_single), number_json(v.y, is_single), number_json(v.z, is_single)};
}

Json build_object(Described value) {
    Json::Object object;
    for (const Field& field : value.fields()) object.emplace_back(field.name, build_json(field.value));
    return object;
}

Json build_map(Described value) {
    Json::Object object;
    for (const std::string& key : value.keys()) object.emplace_back(key, build_json(value.entry(key)));
    return object;
}

}

Json build_json(Described value) {
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
            return parse_json(std::get<std::string>(value.get()), "stored JSON", {.kind = ErrorKind::bad_input});
        case Kind::vector3:
            return build_vector(std::get<Vec3>(value.get()), value.type().is_single);
        case Kind::list:
            return build_list(value);
        case Kind::map:
            return build_map(value);
        case Kind::object:
            return build_object(value);
    }
    return {};
}

std::string write_json(Described value, JsonStyle style) { return dump_json(build_json(value), style); }

}
