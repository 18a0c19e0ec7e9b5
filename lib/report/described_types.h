// SPDX-License-Identifier: GPL-3.0-or-later
// The TypeInfo of every type that describe() may name; included by described.h only.
#pragma once

namespace crumple::report::detail {

template <class T>
T& value(void* data) {
    return *static_cast<T*>(data);
}
template <class T>
const T& value(const void* data) {
    return *static_cast<const T*>(data);
}

template <class T>
concept Integer = std::is_integral_v<T> && !std::same_as<T, bool>;

template <class T>
struct TypeOf;

template <>
struct TypeOf<bool> {
    static TypeInfo make() {
        TypeInfo type{.kind = Kind::boolean};
        type.get = [](const void* p) -> Scalar { return value<bool>(p); };
        type.set = [](void* p, const Scalar& s) {
            if (!std::holds_alternative<bool>(s)) return false;
            value<bool>(p) = std::get<bool>(s);
            return true;
        };
        return type;
    }
};

template <Integer T>
struct TypeOf<T> {
    static Scalar get(const void* p) {
        if constexpr (std::is_signed_v<T>) {
            return static_cast<std::int64_t>(value<T>(p));
        } else {
            return static_cast<std::uint64_t>(value<T>(p));
        }
    }
    static bool set(void* p, const Scalar& s) {
        if (const auto* i = std::get_if<std::int64_t>(&s); i && std::in_range<T>(*i)) {
            value<T>(p) = static_cast<T>(*i);
            return true;
        }
        if (const auto* u = std::get_if<std::uint64_t>(&s); u && std::in_range<T>(*u)) {
            value<T>(p) = static_cast<T>(*u);
            return true;
        }
        return false;
    }
    static TypeInfo make() {
        TypeInfo type{.kind = Kind::integer, .is_index = std::same_as<T, Index>};
        type.lowest = static_cast<double>(std::numeric_limits<T>::lowest());
        type.highest = static_cast<double>(std::numeric_limits<T>::max());
        type.get = get;
        type.set = set;
        return type;
    }
};

template <std::floating_point T>
struct TypeOf<T> {
    static TypeInfo make() {
        TypeInfo type{.kind = Kind::number, .is_single = std::same_as<T, float>};
        type.get = [](const void* p) -> Scalar { return static_cast<double>(value<T>(p)); };
        type.set = [](void* p, const Scalar& s) {
            const auto* number = std::get_if<double>(&s);
            if (!number) return false;
            value<T>(p) = static_cast<T>(*number);
            return true;
        };
        return type;
    }
};

template <>
struct TypeOf<std::string> {
    static TypeInfo make() {
        TypeInfo type{.kind = Kind::text};
        type.get = [](const void* p) -> Scalar { return value<std::string>(p); };
        type.set = [](void* p, const Scalar& s) {
            if (!std::holds_alternative<std::string>(s)) return false;
            value<std::string>(p) = std::get<std::string>(s);
            return true;
        };
        return type;
    }
};

template <>
struct TypeOf<RawJson> {
    static TypeInfo make() {
        TypeInfo type{.kind = Kind::raw};
        type.get = [](const void* p) -> Scalar { return value<RawJson>(p).text; };
        type.set = [](void* p, const Scalar& s) {
            if (!std::holds_alternative<std::string>(s)) return false;
            value<RawJson>(p).text = std::get<std::string>(s);
            return true;
        };
        return type;
    }
};

template <class F>
struct TypeOf<Vec3T<F>> {
    static TypeInfo make() {
        TypeInfo type{.kind = Kind::vector3, .is_single = std::same_as<F, float>};
        type.get = [](const void* p) -> Scalar {
            const auto& v = value<Vec3T<F>>(p);
            return Vec3{v.x, v.y, v.z};
        };
        type.set = [](void* p, const Scalar& s) {
            const auto* v = std::get_if<Vec3>(&s);
            if (!v) return false;
            value<Vec3T<F>>(p) = {static_cast<F>(v->x), static_cast<F>(v->y), static_cast<F>(v->z)};
            return true;
        };
        return type;
    }
};

template <NamedEnum E>
struct TypeOf<E> {
    static std::span<const std::string_view> choices() {
        static const std::vector<std::string_view> names = [] {
            std::vector<std::string_view> list;
            for (const auto& entry : enum_names(E{})) list.push_back(entry.name);
            return list;
        }();
        return names;
    }
    static bool set(void* p, const Scalar& s) {
        const auto* name = std::get_if<std::string>(&s);
        if (!name) return false;
        for (const auto& entry : enum_names(E{})) {
            if (entry.name != *name) continue;
            value<E>(p) = entry.value;
            return true;
        }
        return false;
    }
    static TypeInfo make() {
        TypeInfo type{.kind = Kind::choice};
        type.get = [](const void* p) -> Scalar { return std::string(name_of(value<E>(p))); };
        type.set = set;
        type.choices = choices;
        return type;
    }
};

// An element for kind and fields only, never written to.
template <class T>
Described example_of() {
    static T example{};
    return Described::of(example);
}

template <class T>
struct TypeOf<std::vector<T>> {
    static TypeInfo make() {
        using List = std::vector<T>;
        TypeInfo type{.kind = Kind::list};
        type.size = [](const void* p) { return value<List>(p).size(); };
        type.resize = [](void* p, std::size_t count) { value<List>(p).resize(count); };
        type.item = [](void* p, std::size_t i) { return Described::of(value<List>(p)[i]); };
        type.example = example_of<T>;
        return type;
    }
};

template <class T, std::size_t N>
struct TypeOf<std::array<T, N>> {
    static TypeInfo make() {
        using List = std::array<T, N>;
        TypeInfo type{.kind = Kind::list, .fixed_size = N};
        type.size = [](const void*) { return N; };
        type.resize = [](void*, std::size_t) {};
        type.item = [](void* p, std::size_t i) { return Described::of(value<List>(p)[i]); };
        type.example = example_of<T>;
        return type;
    }
};

template <class T>
struct TypeOf<std::map<std::string, T>> {
    static std::vector<std::string> keys(const void* p) {
        std::vector<std::string> list;
        for (const auto& [key, unused] : value<std::map<std::string, T>>(p)) list.push_back(key);
        return list;
    }
    static TypeInfo make() {
        using Map = std::map<std::string, T>;
        TypeInfo type{.kind = Kind::map};
        type.size = [](const void* p) { return value<Map>(p).size(); };
        type.keys = keys;
        type.entry = [](void* p, const std::string& key) { return Described::of(value<Map>(p)[key]); };
        type.clear = [](void* p) { value<Map>(p).clear(); };
        type.example = example_of<T>;
        return type;
    }
};

// Everything else has a describe() of its own; a struct without members needs none.
template <class T>
struct TypeOf {
    static TypeInfo make() {
        TypeInfo type{.kind = Kind::object};
        type.fields = [](void* p) {
            FieldCollector collector;
            if constexpr (!std::is_empty_v<T>) describe(collector, value<T>(p));
            (void)p;
            return collector.take();
        };
        return type;
    }
};

}

namespace crumple::report {

template <class T>
const TypeInfo* type_info() {
    static const TypeInfo type = detail::TypeOf<T>::make();
    return &type;
}

// A const value may be viewed as well: the writers only read. Whoever sets through a view made it from a non-const
// value.
template <class T>
Described Described::of(T& value) {
    using Plain = std::remove_const_t<T>;
    return Described(const_cast<Plain*>(&value), type_info<Plain>());
}

template <class T>
T* Described::get_if() const {
    return type_ == type_info<T>() ? static_cast<T*>(data_) : nullptr;
}

}
