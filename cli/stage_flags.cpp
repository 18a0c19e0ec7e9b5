// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/stage_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "pipeline/stage_table.h"
#include "report/json_writer.h"

namespace crumple::cli {

namespace {

bool is_single(report::Kind kind) {
    using enum report::Kind;
    return kind == boolean || kind == integer || kind == number || kind == text || kind == choice;
}

std::string type_of(const report::Field& field) {
    switch (field.value.kind()) {
        case report::Kind::choice: {
            std::string names;
            for (const std::string_view name : field.value.type().choices())
                names += (names.empty() ? "" : "|") + std::string(name);
            return names;
        }
        case report::Kind::boolean:
            return "true|false";
        case report::Kind::text:
            return "TEXT";
        default:
            return "N";
    }
}

// Long help goes on below itself, so that a line fits a terminal.
std::string wrapped(const std::string& text) {
    constexpr std::size_t width = 84;
    std::string lines;
    std::size_t line_begin = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        if (!lines.empty()) {
            const bool fits = lines.size() - line_begin + 1 + end - begin <= width;
            lines += fits ? ' ' : '\n';
            if (!fits) line_begin = lines.size();
        }
        lines += text.substr(begin, end - begin);
        begin = end + 1;
    }
    return lines;
}

}

void add_stage_flags(CLI::App& verb, const pipeline::Stage& stage, std::vector<Setting>& settings) {
    const report::OwnedDescribed params = stage.make_params();
    for (const report::Field& field : params.view().fields()) {
        std::string option = "--" + field.name;
        std::replace(option.begin(), option.end(), '_', '-');
        if (!is_single(field.value.kind()) || verb.get_option_no_throw(option)) continue;
        const std::string path = std::string(stage.name) + "." + field.name;
        const std::string value = report::write_json(field.value, report::JsonStyle::compact);
        verb.add_option_function<std::string>(
                option,
                [&settings, option, path](const std::string& text) {
                    settings.push_back({option + " " + text, path + "=" + text});
                },
                wrapped(field.help + " [" + value + "]"))
            ->type_name(type_of(field))
            ->group("Parameters");
    }
}

std::string with_stage(std::string_view stage, const std::string& setting) {
    const std::string prefix = std::string(stage) + ".";
    return setting.starts_with(prefix) ? setting : prefix + setting;
}

}
