// SPDX-License-Identifier: MIT
#include "store/compare_files.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <type_traits>

namespace crumple::store {
namespace {

template <class T>
T element_at(const Dataset& dataset, std::uint64_t i) {
    T value;
    std::memcpy(&value, dataset.bytes.data() + i * sizeof(T), sizeof(T));
    return value;
}

template <class T>
std::string to_text(T value) {
    char buffer[64];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

template <class T>
double distance(T a, T b) {
    if constexpr (std::is_integral_v<T>) {
        return a > b ? static_cast<double>(a) - static_cast<double>(b)
                     : static_cast<double>(b) - static_cast<double>(a);
    } else {
        const double difference = std::fabs(static_cast<double>(a) - static_cast<double>(b));
        return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
    }
}

std::uint64_t row_of(const DatasetInfo& info, std::uint64_t element) {
    std::uint64_t columns = 1;
    for (std::size_t axis = 1; axis < info.shape.size(); ++axis) columns *= info.shape[axis];
    return element / std::max<std::uint64_t>(1, columns);
}

// REQUIRES: same type and shape.
template <class T>
void compare_numbers(const Dataset& a, const Dataset& b, DatasetDifference& difference) {
    for (std::uint64_t i = 0; i < a.bytes.size() / sizeof(T); ++i) {
        const T x = element_at<T>(a, i);
        const T y = element_at<T>(b, i);
        if (std::memcmp(&x, &y, sizeof(T)) == 0) continue;
        if (difference.elements++ == 0) {
            difference.first_row = difference.largest_row = row_of(a.info, i);
            difference.first_value = to_text(x);
            difference.second_value = to_text(y);
        }
        if (distance(x, y) > difference.largest) {
            difference.largest = distance(x, y);
            difference.largest_row = row_of(a.info, i);
        }
    }
}

std::string text_at(const Dataset& dataset, std::uint64_t i) {
    std::string text(reinterpret_cast<const char*>(dataset.bytes.data()) + i * dataset.info.element_size,
                     dataset.info.element_size);
    return text.substr(0, text.find('\0'));
}

// Texts may be padded to different lengths.
void compare_texts(const Dataset& a, const Dataset& b, DatasetDifference& difference) {
    std::uint64_t count = 1;
    for (const std::uint64_t extent : a.info.shape) count *= extent;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::string x = text_at(a, i);
        const std::string y = text_at(b, i);
        if (x == y) continue;
        if (difference.elements++ > 0) continue;
        difference.first_row = difference.largest_row = i;
        difference.first_value = x;
        difference.second_value = y;
    }
}

std::string shape_text(const DatasetInfo& info) {
    std::string text(name_of(info.type));
    for (std::size_t axis = 0; axis < info.shape.size(); ++axis)
        text += (axis == 0 ? " " : "x") + to_text(info.shape[axis]);
    return text;
}

void compare_values(const Dataset& a, const Dataset& b, DatasetDifference& difference) {
    switch (a.info.type) {
        case Type::u8:
            return compare_numbers<std::uint8_t>(a, b, difference);
        case Type::u16:
            return compare_numbers<std::uint16_t>(a, b, difference);
        case Type::u32:
            return compare_numbers<std::uint32_t>(a, b, difference);
        case Type::u64:
            return compare_numbers<std::uint64_t>(a, b, difference);
        case Type::i64:
            return compare_numbers<std::int64_t>(a, b, difference);
        case Type::f32:
            return compare_numbers<float>(a, b, difference);
        case Type::f64:
            return compare_numbers<double>(a, b, difference);
        case Type::text:
            return compare_texts(a, b, difference);
    }
}

void compare_datasets(const std::string& path, const Dataset& a, const Dataset& b,
                      std::vector<DatasetDifference>& differing) {
    DatasetDifference difference;
    difference.path = path;
    if (a.info.type != b.info.type || a.info.shape != b.info.shape) {
        difference.kind = a.info.type != b.info.type ? Difference::type : Difference::shape;
        difference.first_value = shape_text(a.info);
        difference.second_value = shape_text(b.info);
        differing.push_back(difference);
        return;
    }
    if (a.info == b.info && a.bytes == b.bytes) return;
    compare_values(a, b, difference);
    if (difference.elements > 0) differing.push_back(difference);
}

struct Listing {
    std::set<std::string> all;
    std::set<std::string> attributes;
};

Listing list_under(const FileReader& file, const std::string& group) {
    Listing listing;
    const auto belongs = [&](const std::string& path) {
        const bool is_under = group == "/" || path.starts_with(group + "/") || path.starts_with(group + "@");
        return is_under && !path.starts_with("/digest/");
    };
    for (const std::string& path : file.all_datasets()) {
        if (belongs(path)) listing.all.insert(path);
    }
    for (const std::string& path : file.all_attributes()) {
        if (!belongs(path)) continue;
        listing.all.insert(path);
        listing.attributes.insert(path);
    }
    return listing;
}

Dataset read_either(const FileReader& file, const std::string& path, const Listing& listing) {
    if (!listing.attributes.contains(path)) return file.read_bytes(path);
    const std::size_t at = path.rfind('@');
    return file.read_attribute(path.substr(0, at), path.substr(at + 1));
}

}

Comparison compare_files(const FileReader& first, const FileReader& second, const std::string& group) {
    const Listing in_first = list_under(first, group);
    const Listing in_second = list_under(second, group);
    std::set<std::string> paths = in_first.all;
    paths.insert(in_second.all.begin(), in_second.all.end());
    Comparison comparison;
    comparison.compared = paths.size();
    for (const std::string& path : paths) {
        const bool has_first = in_first.all.contains(path);
        const bool has_second = in_second.all.contains(path);
        if (has_first && has_second) {
            compare_datasets(path, read_either(first, path, in_first), read_either(second, path, in_second),
                             comparison.differing);
            continue;
        }
        DatasetDifference difference;
        difference.path = path;
        difference.kind = has_first ? Difference::only_in_first : Difference::only_in_second;
        comparison.differing.push_back(difference);
    }
    return comparison;
}

}
