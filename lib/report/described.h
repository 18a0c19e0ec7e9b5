// SPDX-License-Identifier: GPL-3.0-or-later
// A described struct (core/fields.h) seen at run time: what fields it has, of what kind, and a way to read and write
// them. The JSON reader, the JSON writer, the schema, the text view and --set are ordinary functions over this view, so
// the one declaration in a stage's header serves them all and no header needs a JSON package.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/fields.h"
#include "core/finding.h"
#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

inline constexpr EnumName<Severity> severity_names[] = {
    {Severity::info, "info"}, {Severity::warning, "warning"}, {Severity::error, "error"}};
constexpr std::span<const EnumName<Severity>> enum_names(Severity) { return severity_names; }

template <class Visitor, FieldsOf<Place> P>
void describe(Visitor& visit, P& p) {
    visit.field("position", p.position, "metres, in the asset's space");
    visit.field("element", p.element, "vertex, triangle or tet, as the code says; null where there is none");
    visit.field("name", p.name, "component, mesh or material");
}

template <class Visitor, FieldsOf<Finding> F>
void describe(Visitor& visit, F& f) {
    visit.field("code", f.code, "stable name of this kind of finding");
    visit.field("severity", f.severity, "how bad");
    visit.field("message", f.message, "what, and what to try");
    visit.field("count", f.count, "how many of them");
    visit.field("places", f.places, "where the first few are");
}

}

namespace crumple::report {

// JSON kept as text: written by another version of a stage, shown as it is.
struct RawJson {
    std::string text = "null";
};

enum class Kind { boolean, integer, number, text, vector3, choice, object, list, map, raw };

using Scalar = std::variant<bool, std::int64_t, std::uint64_t, double, std::string, Vec3>;

class Described;
struct Field;

// What can be done with a value of one type; the members that do not belong to its kind are null.
struct TypeInfo {
    Kind kind = Kind::object;
    bool is_single = false;  // a float: shortest digits that read back as the same float
    bool is_index = false;   // 32-bit unsigned: 0xffffffff means none, null in JSON
    double lowest = 0;       // of an integer type
    double highest = 0;
    std::size_t fixed_size = 0;  // of a list that cannot be resized
    Scalar (*get)(const void*) = nullptr;
    bool (*set)(void*, const Scalar&) = nullptr;  // false: does not fit
    std::span<const std::string_view> (*choices)() = nullptr;
    std::vector<Field> (*fields)(void*) = nullptr;
    std::size_t (*size)(const void*) = nullptr;
    void (*resize)(void*, std::size_t) = nullptr;
    Described (*item)(void*, std::size_t) = nullptr;
    std::vector<std::string> (*keys)(const void*) = nullptr;
    Described (*entry)(void*, const std::string&) = nullptr;  // made when absent
    void (*clear)(void*) = nullptr;
    Described (*example)() = nullptr;  // a default element of a list or map
};

// A reference to one value; as cheap to copy as a pointer. Valid as long as the value is.
class Described {
public:
    Described(void* data, const TypeInfo* type) : data_(data), type_(type) {}

    template <class T>
    static Described of(T& value);

    [[nodiscard]] Kind kind() const { return type_->kind; }
    [[nodiscard]] const TypeInfo& type() const { return *type_; }
    [[nodiscard]] Scalar get() const { return type_->get(data_); }
    [[nodiscard]] bool set(const Scalar& scalar) const { return type_->set(data_, scalar); }
    [[nodiscard]] std::vector<Field> fields() const;
    [[nodiscard]] std::size_t size() const { return type_->size(data_); }
    void resize(std::size_t count) const { type_->resize(data_, count); }
    [[nodiscard]] Described item(std::size_t i) const { return type_->item(data_, i); }
    [[nodiscard]] std::vector<std::string> keys() const { return type_->keys(data_); }
    [[nodiscard]] Described entry(const std::string& key) const { return type_->entry(data_, key); }
    void clear() const { type_->clear(data_); }
    // The value itself when it is a T, else null.
    template <class T>
    [[nodiscard]] T* get_if() const;
    // What the elements of a list or map are; for kind and fields only.
    [[nodiscard]] Described example() const { return type_->example(); }

private:
    void* data_;
    const TypeInfo* type_;
};

struct Field {
    std::string name;
    std::string help;
    Range range;  // of the number, or of every number in a list, map or vector
    Described value;
    std::string pattern = {};  // of the text; empty: any
};

inline std::vector<Field> Described::fields() const { return type_->fields(data_); }

// The visitor that describe() talks to.
class FieldCollector {
public:
    template <class T>
    void field(std::string_view name, T& member, std::string_view help) {
        field(name, member, Range{}, help);
    }
    template <class T>
    void field(std::string_view name, T& member, Range range, std::string_view help) {
        add(name, Described::of(member), range, help);
    }
    void field(std::string_view name, std::string& member, Pattern pattern, std::string_view help) {
        field(name, member, help);
        fields_.back().pattern = pattern.text;
    }
    void field(std::string_view name, const std::string& member, Pattern, std::string_view help) {
        field(name, member, help);
    }
    // For structs put together at run time, such as a recipe out of its stages.
    void add(std::string_view name, Described value, Range range, std::string_view help) {
        fields_.push_back({std::string(name), std::string(help), range, value});
    }
    [[nodiscard]] std::vector<Field> take() { return std::move(fields_); }

private:
    std::vector<Field> fields_;
};

// A value that owns its struct: the Params or Report of some stage.
class OwnedDescribed {
public:
    OwnedDescribed(OwnedDescribed&&) noexcept = default;
    OwnedDescribed& operator=(OwnedDescribed&&) noexcept = default;

    template <class T>
    static OwnedDescribed make(T value = {}) {
        auto data = std::make_shared<T>(std::move(value));
        const Described view = Described::of(*data);
        return OwnedDescribed(std::move(data), view);
    }
    [[nodiscard]] Described view() const { return view_; }
    // REQUIRES: made with this T.
    template <class T>
    [[nodiscard]] const T& as() const {
        return *view_.get_if<T>();
    }

private:
    OwnedDescribed(std::shared_ptr<void> data, Described view) : data_(std::move(data)), view_(view) {}
    std::shared_ptr<void> data_;
    Described view_;
};

}

#include "report/described_types.h"
