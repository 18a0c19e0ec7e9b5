// SPDX-License-Identifier: MIT
// One declaration of a struct's fields, from which the strict JSON reader, the JSON writer, the JSON Schema and the
// command-line --set all come. A struct that wants to be described has, in its namespace,
//
//     template <class Visitor, FieldsOf<Params> P>
//     void describe(Visitor& visit, P& p) {
//         visit.field("sweeps", p.sweeps, Range{0, 1000}, "passes of moving nodes and triangulating again");
//         visit.field("method", p.method, "where a node moves to");
//     }
//
// and, for an enum, a function found by argument-dependent lookup:
//
//     inline constexpr EnumName<Method> method_names[] = {{Method::cpt, "cpt"}, {Method::odt, "odt"}};
//     constexpr std::span<const EnumName<Method>> enum_names(Method) { return method_names; }
//
// Text of a form that an enum cannot name has a Pattern in place of the Range. What no single field's range says, such
// as a name that must be in another field's list, a function void check_params(const Params&) beside describe refuses:
// it throws Error(usage), and its message begins with the path of the field.
//
// A visitor must offer field(name, member, help) and field(name, member, Range, help) for bool, integers, double,
// float, std::string, Vec3, enums, described structs, Finding, std::vector and std::map<std::string, T> of these.
#pragma once
#include <concepts>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>

namespace crumple {

struct Range {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
};

// A regular expression (of JSON Schema) that the whole text matches.
struct Pattern {
    std::string_view text;
};

template <class E>
struct EnumName {
    E value;
    std::string_view name;
};

template <class P, class T>
concept FieldsOf = std::same_as<std::remove_const_t<P>, T>;

template <class E>
concept NamedEnum = std::is_enum_v<E> && requires(E e) {
    enum_names(e);
};

template <NamedEnum E>
constexpr std::string_view name_of(E value) {
    for (const auto& entry : enum_names(E{})) {
        if (entry.value == value) return entry.name;
    }
    return "?";
}

}
