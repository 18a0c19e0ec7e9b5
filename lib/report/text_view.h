// SPDX-License-Identifier: GPL-3.0-or-later
// Reports and findings as text for a terminal. Free text: it may change from version to version, the JSON may not.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/finding.h"
#include "report/described.h"

namespace crumple::report {

struct TextStyle {
    bool has_color = false;
    std::size_t indent = 0;  // spaces before every line
    std::size_t places = 1;  // of a finding, at most
};

// "name  value" lines, nested structs indented below their name. Findings are left out: see findings_text.
[[nodiscard]] std::string report_text(Described report, const TextStyle& style = {});

// Errors first, then warnings, then the rest, each with its count and where the first are; empty when there are none.
[[nodiscard]] std::string findings_text(std::span<const Finding> findings, const TextStyle& style = {});

// "2 errors, 1 warning" or "no findings".
[[nodiscard]] std::string findings_summary(std::span<const Finding> findings);

// Rows of cells in columns; the first row is the heading. Cells that start with a digit or sign are right-aligned.
[[nodiscard]] std::string table_text(const std::vector<std::vector<std::string>>& rows, const TextStyle& style = {});

// The findings a report holds in its field "findings"; empty where it has none.
[[nodiscard]] std::vector<Finding> findings_of(Described report);

[[nodiscard]] bool has_severity(std::span<const Finding> findings, Severity severity);

}
