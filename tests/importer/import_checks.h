// SPDX-License-Identifier: GPL-3.0-or-later
// What the import tests ask of a result.
#pragma once
#include <algorithm>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "importer/import.h"
#include "shared_data.h"

namespace crumple::test {

inline importer::Result import_shell(const std::string& path, const importer::Params& params = {}) {
    importer::Sources sources;
    sources.shell = path;
    return importer::import_asset(sources, params);
}

inline const Finding* find(const std::vector<Finding>& findings, const std::string& code) {
    const auto found = std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == code; });
    return found == findings.end() ? nullptr : &*found;
}

inline bool has(const importer::Report& report, const std::string& code) {
    return find(report.findings, code) != nullptr;
}

// The message of the Error that importing throws, and its kind; empty when it throws none.
struct Refusal {
    ErrorKind kind = ErrorKind::internal;
    std::string message;
};

template <class Function>
Refusal refusal_of(Function&& function) {
    try {
        function();
    } catch (const Error& error) {
        return {error.kind(), error.what()};
    }
    return {};
}

// What a refusal of the content says; empty without one.
template <class Function>
std::string bad_input_of(Function&& function) {
    const Refusal refusal = refusal_of(function);
    EXPECT_TRUE(refusal.message.empty() || refusal.kind == ErrorKind::bad_input);
    return refusal.message;
}

inline Refusal refusal_of_file(const std::string& path, const importer::Params& params = {}) {
    return refusal_of([&] { (void)import_shell(path, params); });
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline bool lexicographic(const Vec3& a, const Vec3& b) { return lexicographic_less(a, b); }

inline std::vector<Vec3> sorted(std::vector<Vec3> positions) {
    std::sort(positions.begin(), positions.end(), lexicographic);
    return positions;
}

}
