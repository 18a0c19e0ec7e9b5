// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/compare.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

#include "pipeline/in_child.h"
#include "report/number_text.h"
#include "store/hdf5_file.h"
#include "store/read_file.h"

namespace crumple::pipeline {

namespace {

using store::Dataset;
using store::FileReader;
using store::Type;

template <class T>
double number_at(const Dataset& data, std::size_t i) {
    T value{};
    std::memcpy(&value, data.bytes.data() + i * sizeof(T), sizeof(T));
    return static_cast<double>(value);
}

double number_of(const Dataset& data, std::size_t i) {
    switch (data.info.type) {
        case Type::u8:
            return number_at<std::uint8_t>(data, i);
        case Type::u16:
            return number_at<std::uint16_t>(data, i);
        case Type::u32:
            return number_at<std::uint32_t>(data, i);
        case Type::u64:
            return number_at<std::uint64_t>(data, i);
        case Type::i64:
            return number_at<std::int64_t>(data, i);
        case Type::f32:
            return number_at<float>(data, i);
        case Type::f64:
            return number_at<double>(data, i);
        case Type::text:
            break;
    }
    return 0;
}

std::string text_of(const Dataset& data, std::size_t i) {
    if (data.info.type != Type::text) return report::number_text(number_of(data, i));
    const auto* begin = reinterpret_cast<const char*>(data.bytes.data() + i * data.info.element_size);
    const std::string text(begin, strnlen(begin, data.info.element_size));
    return text.size() > 80 ? text.substr(0, 77) + "..." : text;
}

std::string shape_text(const store::DatasetInfo& info) {
    std::string text(store::name_of(info.type));
    for (const std::uint64_t extent : info.shape)
        text += (&extent == info.shape.data() ? " " : " x ") + std::to_string(extent);
    return text;
}

// The same dataset of both files. `first` and `largest` differ only in which value they show.
struct DatasetDifference {
    Difference first;
    Difference largest;
};

DatasetDifference compare_values(const std::string& path, const Dataset& a, const Dataset& b) {
    Difference first{path, "values", 0, 0, 0, "", "", 0};
    Difference largest = first;
    const std::size_t columns = a.info.shape.size() > 1 ? a.info.shape[1] : 1;
    const std::size_t count = a.bytes.size() / a.info.element_size;
    const auto show = [&](Difference& difference, std::size_t i) {
        difference.row = i / columns;
        difference.column = i % columns;
        difference.a = text_of(a, i);
        difference.b = text_of(b, i);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = i * a.info.element_size;
        if (std::memcmp(a.bytes.data() + at, b.bytes.data() + at, a.info.element_size) == 0) continue;
        if (first.count++ == 0) show(first, i);
        const double size = std::fabs(number_of(a, i) - number_of(b, i));
        if (size > largest.size) {
            largest.size = size;
            show(largest, i);
        }
    }
    first.size = largest.size;
    largest.count = first.count;
    return {first, largest};
}

DatasetDifference compare_data(const std::string& path, const Dataset& a, const Dataset& b) {
    if (a.info == b.info) return compare_values(path, a, b);
    const Difference difference{path, "type or shape", 1, 0, 0, shape_text(a.info), shape_text(b.info), 0};
    return {difference, difference};
}

// What a reader wants to hear of first: the bundle, then how it came to be, last the view that repeats it.
int rank_of(const std::string& path) { return path.starts_with("/bundle") ? 0 : path.starts_with("/VTKHDF") ? 2 : 1; }

std::vector<std::string> contents_of(const FileReader& file) {
    std::vector<std::string> paths = file.all_datasets();
    for (const std::string& attribute : file.all_attributes()) paths.push_back(attribute);
    // The digests differ exactly where the data does.
    std::erase_if(paths, [](const std::string& path) { return path.starts_with("/digest"); });
    std::sort(paths.begin(), paths.end(),
              [](const auto& x, const auto& y) { return std::pair(rank_of(x), x) < std::pair(rank_of(y), y); });
    return paths;
}

Dataset read_any(const FileReader& file, const std::string& path) {
    const std::size_t at = path.find('@');
    return at == std::string::npos ? file.read_bytes(path)
                                   : file.read_attribute(path.substr(0, at), path.substr(at + 1));
}

std::vector<std::string> without(const std::vector<std::string>& all, const std::vector<std::string>& other) {
    std::vector<std::string> rest;
    std::copy_if(all.begin(), all.end(), std::back_inserter(rest),
                 [&](const std::string& path) { return std::find(other.begin(), other.end(), path) == other.end(); });
    return rest;
}

void add_difference(const DatasetDifference& difference, CompareReport& report) {
    if (difference.first.count == 0) return;
    report.is_equal = false;
    if (report.differing++ == 0) report.first = difference.first;
    if (difference.largest.size > report.largest.size) report.largest = difference.largest;
}

}

CompareReport compare_images(std::vector<std::byte> a, const std::string& name_a, std::vector<std::byte> b,
                             const std::string& name_b) {
    const FileReader file_a(std::move(a), name_a);
    const FileReader file_b(std::move(b), name_b);
    const std::vector<std::string> paths_a = contents_of(file_a);
    const std::vector<std::string> paths_b = contents_of(file_b);
    CompareReport report;
    report.only_in_a = without(paths_a, paths_b);
    report.only_in_b = without(paths_b, paths_a);
    report.is_equal = report.only_in_a.empty() && report.only_in_b.empty();
    for (const std::string& path : paths_a) {
        if (std::find(paths_b.begin(), paths_b.end(), path) == paths_b.end()) continue;
        ++report.compared;
        add_difference(compare_data(path, read_any(file_a, path), read_any(file_b, path)), report);
    }
    return report;
}

CompareReport compare_files(const std::string& a, const std::string& b) {
    const std::vector<std::byte> image_a = store::read_file(a);
    const std::vector<std::byte> image_b = store::read_file(b);
    return run_described_in_child<CompareReport>([&] { return compare_images(image_a, a, image_b, b); },
                                                 a + " or " + b);
}

}
