// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/compare.h"

#include <algorithm>

#include "bundle/blob.h"
#include "core/counted.h"
#include "core/error.h"
#include "pipeline/in_child.h"
#include "report/number_text.h"
#include "report/printable.h"
#include "store/read_file.h"

namespace crumple::pipeline {

namespace {

// What a reader wants to hear of first: the bundle, then how it came to be, last the view that repeats it.
int rank_of(const std::string& path) { return path.starts_with("/bundle") ? 0 : path.starts_with("/VTKHDF") ? 2 : 1; }

std::string short_text(const std::string& text) {
    return report::printable(text.size() > 80 ? text.substr(0, 77) + "..." : text);
}

std::string difference_text(const store::DatasetDifference& difference) {
    std::string text = "  " + report::printable(difference.path) + ": " + std::string(name_of(difference.kind));
    if (difference.elements > 0) {
        text += ", " + counted(difference.elements, "element", "elements") + " from row " +
                std::to_string(difference.first_row);
    }
    if (!difference.first_value.empty() || !difference.second_value.empty()) {
        text += ": " + short_text(difference.first_value) + " and " + short_text(difference.second_value);
    }
    if (difference.largest > 0) {
        text += "; largest |a - b| " + report::number_text(difference.largest) + " at row " +
                std::to_string(difference.largest_row);
    }
    return text + "\n";
}

std::vector<std::byte> read_comparable(const std::string& path) {
    std::vector<std::byte> image = store::read_file(path);
    if (is_blob(image)) {
        throw Error(ErrorKind::usage,
                    path + ": a blob has no datasets to compare; compare the bundles, or the blobs byte by byte (cmp)");
    }
    return image;
}

}

CompareReport compare_images(std::vector<std::byte> a, const std::string& name_a, std::vector<std::byte> b,
                             const std::string& name_b) {
    const store::FileReader file_a(std::move(a), name_a);
    const store::FileReader file_b(std::move(b), name_b);
    store::Comparison comparison = store::compare_files(file_a, file_b, "/");
    CompareReport report;
    report.compared = comparison.compared;
    report.differing = std::move(comparison.differing);
    report.is_equal = report.differing.empty();
    std::stable_sort(report.differing.begin(), report.differing.end(),
                     [](const auto& x, const auto& y) { return rank_of(x.path) < rank_of(y.path); });
    if (!report.is_equal) report.first = report.differing.front().path;
    for (const auto& difference : report.differing) {
        if (difference.largest <= report.largest_size) continue;
        report.largest = difference.path;
        report.largest_size = difference.largest;
    }
    return report;
}

CompareReport compare_files(const std::string& a, const std::string& b) {
    const std::vector<std::byte> image_a = read_comparable(a);
    const std::vector<std::byte> image_b = read_comparable(b);
    return run_described_in_child<CompareReport>([&] { return compare_images(image_a, a, image_b, b); },
                                                 a + " or " + b);
}

std::string compare_text(const CompareReport& report) {
    if (report.is_equal) return "equal: " + std::to_string(report.compared) + " datasets and attributes\n";
    std::string text = std::to_string(report.differing.size()) + " of " + std::to_string(report.compared) +
                       " datasets and attributes differ; first " + report::printable(report.first) + "\n";
    if (!report.largest.empty()) {
        text += "largest difference: " + report::number_text(report.largest_size) + " in " +
                report::printable(report.largest) + "\n";
    }
    for (const auto& difference : report.differing) text += difference_text(difference);
    return text;
}

}
