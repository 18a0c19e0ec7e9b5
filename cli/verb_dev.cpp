// SPDX-License-Identifier: GPL-3.0-or-later
// crumple dev: for those who work on the tool
#include <CLI/CLI.hpp>
#include <filesystem>
#include <span>

#include "cli/verbs.h"
#include "core/error.h"
#include "core/names.h"
#include "pipeline/exit_codes.h"
#include "pipeline/schemas.h"
#include "report/text_view.h"
#include "samples/samples.h"
#include "store/write_file.h"
#include "study/load_scene.h"

namespace crumple::cli {

namespace {

struct SchemaFlags {
    std::string name;
    std::string folder;
};

std::vector<pipeline::SchemaFile> all_schemas() {
    std::vector<pipeline::SchemaFile> files = pipeline::all_schemas();
    files.push_back({"scene.schema.json", study::scene_schema()});
    return files;
}

void make_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (!std::filesystem::is_directory(path))
        throw Error(ErrorKind::file, path + ": no folder, and none can be made there" +
                                         (error ? ": " + error.message() : std::string()));
}

int run_schema(const SchemaFlags& flags, const Console& console) {
    const std::vector<pipeline::SchemaFile> files = all_schemas();
    std::vector<std::string> names;
    if (!flags.folder.empty()) make_folder(flags.folder);
    for (const pipeline::SchemaFile& file : files) {
        names.push_back(file.name.substr(0, file.name.find('.')));
        if (!flags.folder.empty())
            store::write_file((std::filesystem::path(flags.folder) / file.name).string(),
                              std::as_bytes(std::span(file.text)));
        if (names.back() == flags.name) {
            console.result(file.text);
            return pipeline::exit_ok;
        }
    }
    if (!flags.name.empty()) {
        throw Error(ErrorKind::usage,
                    "no schema '" + flags.name + "'; nearest: '" + nearest_name(flags.name, names) + "'");
    }
    if (flags.folder.empty()) {
        for (const std::string& name : names) console.result(name + "\n");
    }
    return pipeline::exit_ok;
}

void add_schema(CLI::App& dev, Session& session) {
    CLI::App* verb = dev.add_subcommand("schema", "the JSON Schemas of recipes and of everything printed as JSON");
    const auto flags = std::make_shared<SchemaFlags>();
    verb->add_option("NAME", flags->name, "print this one; without it the names are listed");
    verb->add_option("--write", flags->folder, "write all of them into a folder, which is made if need be")
        ->type_name("FOLDER");
    verb->footer("Example: crumple dev schema --write schemas");
    verb->callback(
        [flags, &session] { session.run = [flags, &session] { return run_schema(*flags, session.console); }; });
}

struct SampleFlags {
    std::string name;
    std::string folder;
};

int run_sample(const SampleFlags& flags, const Console& console) {
    if (flags.name.empty()) {
        for (const samples::Sample& sample : samples::list())
            console.result(std::string(sample.name) + "  " + std::string(sample.what) + "\n");
        return pipeline::exit_ok;
    }
    if (flags.folder.empty()) throw Error(ErrorKind::usage, "dev sample: say where to write it: --out FOLDER");
    for (const std::string& path : samples::write(flags.name, flags.folder)) console.result(path + "\n");
    return pipeline::exit_ok;
}

void add_sample(CLI::App& dev, Session& session) {
    CLI::App* verb = dev.add_subcommand("sample", "assets made by our own code, to try the tool on");
    const auto flags = std::make_shared<SampleFlags>();
    verb->add_option("NAME", flags->name, "write this one; without it they are listed");
    verb->add_option("--out", flags->folder, "where to")->type_name("FOLDER");
    verb->footer("Example: crumple dev sample car --out samples/car");
    verb->callback(
        [flags, &session] { session.run = [flags, &session] { return run_sample(*flags, session.console); }; });
}

}

void add_dev(CLI::App& app, Session& session) {
    CLI::App* dev = app.add_subcommand("dev", "for those who work on the tool");
    dev->require_subcommand(1);
    add_schema(*dev, session);
    add_sample(*dev, session);
    dev->footer("Example: crumple dev schema recipe");
}

}
