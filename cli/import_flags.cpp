// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/import_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "pipeline/input_digests.h"

namespace crumple::cli {

namespace {

void add_setting_flag(CLI::App& verb, ImportFlags& flags, const std::string& option, const std::string& field,
                      const std::string& help) {
    verb.add_option_function<std::string>(
            option,
            [&flags, option, field](const std::string& value) {
                flags.settings.push_back({option + " " + value, "import." + field + "=" + value});
            },
            help)
        ->group("Reading");
}

}

std::shared_ptr<ImportFlags> add_import_flags(CLI::App& verb) {
    auto flags = std::make_shared<ImportFlags>();
    verb.add_option("--shell", flags->shell, "the painted control shell")
        ->type_name("FILE")
        ->required()
        ->group("Reading");
    verb.add_option("--visual", flags->visuals, "a detailed mesh that follows it; may be repeated")
        ->type_name("[NAME=]FILE")
        ->allow_extra_args(false)
        ->group("Reading");
    add_setting_flag(verb, *flags, "--color-set", "color_set", "which vertex colour set holds the paint");
    add_setting_flag(verb, *flags, "--color-space", "color_space", "linear or srgb, of the stored colours");
    add_setting_flag(verb, *flags, "--unit", "unit", "metres per unit of the files; 0: what the file says");
    add_setting_flag(verb, *flags, "--up", "up", "x, y or z: the files' upward axis");
    verb.add_flag_callback(
            "--strict",
            [raw = flags.get()] {
                raw->settings.push_back({"--strict", "import.strict=true"});
            },
            "locks that copies of a vertex disagree about are an error")
        ->group("Reading");
    return flags;
}

void apply_settings(pipeline::Recipe& recipe, const std::vector<Setting>& settings) {
    for (const Setting& setting : settings) pipeline::apply_setting(recipe, setting.text, setting.option);
}

importer::Sources sources_of(const ImportFlags& flags) {
    importer::Sources sources;
    sources.shell = flags.shell;
    for (const std::string& visual : flags.visuals) {
        const std::size_t equals = visual.find('=');
        // A path may hold '=' as well; a name holds no slash.
        const bool has_name = equals != std::string::npos && equals > 0 && visual.find('/') > equals;
        sources.visuals.push_back(has_name
                                      ? importer::Sources::Visual{visual.substr(0, equals), visual.substr(equals + 1)}
                                      : importer::Sources::Visual{"", visual});
    }
    return sources;
}

std::vector<std::string> input_paths(const importer::Sources& sources, const pipeline::Recipe& recipe) {
    std::vector<std::string> paths;
    for (const importer::InputFile& file : pipeline::input_files(sources, recipe)) {
        if (std::find(paths.begin(), paths.end(), file.path) == paths.end()) paths.push_back(file.path);
    }
    return paths;
}

}
