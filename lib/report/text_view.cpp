// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/number_text.h"
#include "report/printable.h"

namespace crumple::report {

namespace {

std::string spaces(std::size_t count) { return std::string(count, ' '); }

bool is_nested(Described value) {
    if (value.kind() == Kind::object) return true;
    if (value.kind() == Kind::map) return value.size() > 0;
    return value.kind() == Kind::list && value.size() > 0 && is_nested(value.item(0));
}

std::string vector_text(Vec3 v) {
    std::string text = "(";
    text += number_text(v.x) + ", " + number_text(v.y) + ", " + number_text(v.z) + ")";
    return text;
}

struct ScalarText {
    bool is_index;
    std::string operator()(bool b) const { return b ? "yes" : "no"; }
    std::string operator()(std::int64_t i) const { return std::to_string(i); }
    std::string operator()(std::uint64_t u) const { return is_index && u == none ? "-" : std::to_string(u); }
    std::string operator()(double d) const { return number_text(d); }
    std::string operator()(const std::string& s) const { return printable(s); }
    std::string operator()(Vec3 v) const { return vector_text(v); }
};

// One line for a value that is not nested.
std::string inline_text(Described value) {
    constexpr std::size_t shown = 8;
    if (value.kind() == Kind::map) return "-";
    if (value.kind() != Kind::list) return std::visit(ScalarText{value.type().is_index}, value.get());
    if (value.size() == 0) return "-";
    std::string text;
    for (std::size_t i = 0; i < std::min(value.size(), shown); ++i)
        text += (i ? ", " : "") + inline_text(value.item(i));
    if (value.size() > shown) text += ", ... (" + std::to_string(value.size()) + ")";
    return text;
}

// A list of structs that hold single values reads best in columns.
bool is_table(Described list) {
    if (list.item(0).kind() != Kind::object) return false;
    const std::vector<Field> fields = list.item(0).fields();
    return std::none_of(fields.begin(), fields.end(), [](const Field& field) { return is_nested(field.value); });
}

std::vector<std::vector<std::string>> table_of(Described list) {
    std::vector<std::vector<std::string>> rows(1);
    for (const Field& field : list.item(0).fields()) rows.front().push_back(field.name);
    for (std::size_t i = 0; i < list.size(); ++i) {
        rows.emplace_back();
        for (const Field& field : list.item(i).fields()) rows.back().push_back(inline_text(field.value));
    }
    return rows;
}

void append_value(std::string& text, const std::string& name, Described value, std::size_t width, std::size_t indent);

void append_fields(std::string& text, const std::vector<Field>& fields, std::size_t indent) {
    std::size_t width = 0;
    for (const Field& field : fields) {
        if (!is_nested(field.value)) width = std::max(width, field.name.size());
    }
    for (const Field& field : fields) {
        if (field.value.get_if<std::vector<Finding>>()) continue;
        append_value(text, field.name, field.value, width, indent);
    }
}

void append_value(std::string& text, const std::string& name, Described value, std::size_t width, std::size_t indent) {
    if (!is_nested(value)) {
        text += spaces(indent) + name + spaces(width - std::min(width, name.size()) + 2) + inline_text(value) + "\n";
        return;
    }
    text += spaces(indent) + name + "\n";
    if (value.kind() == Kind::object) return append_fields(text, value.fields(), indent + 2);
    if (value.kind() == Kind::map) {
        for (const std::string& key : value.keys()) append_value(text, printable(key), value.entry(key), 0, indent + 2);
        return;
    }
    if (is_table(value)) {
        text += table_text(table_of(value), {.indent = indent + 2});
        return;
    }
    for (std::size_t i = 0; i < value.size(); ++i) append_value(text, std::to_string(i), value.item(i), 0, indent + 2);
}

std::string colored(const std::string& text, Severity severity, bool has_color) {
    if (!has_color) return text;
    static constexpr std::array<const char*, 3> codes{"\033[36m", "\033[33m", "\033[31m"};
    return codes[static_cast<std::size_t>(severity)] + text + "\033[0m";
}

std::string place_text(const Place& place) {
    std::string text;
    const auto add = [&](const std::string& word) { text += (text.empty() ? "" : " ") + word; };
    if (!std::isnan(place.position.x)) add(vector_text(place.position));
    if (place.element != none) add("#" + std::to_string(place.element));
    if (!place.name.empty()) add("'" + printable(place.name) + "'");
    return text;
}

std::string finding_text(const Finding& finding, const TextStyle& style) {
    std::string text =
        spaces(style.indent) + colored(std::string(name_of(finding.severity)), finding.severity, style.has_color);
    text += " " + finding.code;
    if (finding.count > 1) text += " (" + std::to_string(finding.count) + ")";
    text += ": " + printable(finding.message) + "\n";
    for (std::size_t i = 0; i < std::min(finding.places.size(), style.places); ++i) {
        const std::string place = place_text(finding.places[i]);
        if (!place.empty()) text += spaces(style.indent + 4) + "at " + place + "\n";
    }
    return text;
}

bool is_number(const std::string& cell) {
    return !cell.empty() && cell.find_first_not_of("0123456789+-.e") == std::string::npos;
}

std::size_t count_of(std::span<const Finding> findings, Severity severity) {
    return static_cast<std::size_t>(
        std::count_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.severity == severity; }));
}

}

std::string report_text(Described report, const TextStyle& style) {
    std::string text;
    append_fields(text, report.fields(), style.indent);
    return text;
}

std::string findings_text(std::span<const Finding> findings, const TextStyle& style) {
    std::string text;
    for (const Severity severity : {Severity::error, Severity::warning, Severity::info}) {
        for (const Finding& finding : findings) {
            if (finding.severity == severity) text += finding_text(finding, style);
        }
    }
    return text;
}

std::string findings_summary(std::span<const Finding> findings) {
    static constexpr std::array<const char*, 3> names{"note", "warning", "error"};
    std::string text;
    for (const Severity severity : {Severity::error, Severity::warning, Severity::info}) {
        const std::size_t count = count_of(findings, severity);
        if (count == 0) continue;
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + names[static_cast<std::size_t>(severity)];
        if (count > 1) text += "s";
    }
    return text.empty() ? "no findings" : text;
}

std::string table_text(const std::vector<std::vector<std::string>>& rows, const TextStyle& style) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
    }
    std::vector<bool> is_right(widths.size());
    for (std::size_t c = 0; c < widths.size(); ++c)
        is_right[c] = rows.size() > 1 && c < rows[1].size() && is_number(rows[1][c]);
    std::string text;
    for (const auto& row : rows) {
        std::string line = spaces(style.indent);
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string padding = spaces(widths[c] - row[c].size());
            line += (c > 0 ? "  " : "") + (is_right[c] ? padding + row[c] : row[c] + padding);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::vector<Finding> findings_of(Described report) {
    for (const Field& field : report.fields()) {
        if (const auto* findings = field.value.get_if<std::vector<Finding>>()) return *findings;
    }
    return {};
}

bool has_severity(std::span<const Finding> findings, Severity severity) { return count_of(findings, severity) > 0; }

}
