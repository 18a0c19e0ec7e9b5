// SPDX-License-Identifier: GPL-3.0-or-later
// crumple check, inspect and compare: what is in a file, and is it true
#include <CLI/CLI.hpp>

#include "cli/output_flags.h"
#include "cli/output_paths.h"
#include "cli/verbs.h"
#include "core/error.h"
#include "pipeline/baseline.h"
#include "pipeline/check.h"
#include "pipeline/compare.h"
#include "pipeline/exit_codes.h"
#include "pipeline/inspect.h"
#include "report/json_writer.h"
#include "report/number_text.h"
#include "report/text_view.h"

namespace crumple::cli {

namespace {

struct FileFlags {
    std::vector<std::string> files;
    Format format = Format::text;
    bool lists_datasets = false;
    std::string baseline;
    bool updates_baseline = false;
};

pipeline::BaselineFile baseline_of(const FileFlags& flags) {
    if (!flags.baseline.empty()) return pipeline::load_baseline(flags.baseline, flags.updates_baseline);
    if (flags.updates_baseline) throw Error(ErrorKind::usage, "--update-baseline: say which: --baseline FILE");
    return {};
}

int run_check(const FileFlags& flags, const Console& console) {
    if (flags.updates_baseline && !flags.baseline.empty())
        check_output_paths({{"--baseline", flags.baseline}}, flags.files);
    const pipeline::BaselineFile baseline = baseline_of(flags);
    if (!flags.baseline.empty()) pipeline::check_asset_names(flags.files);
    const bool compares = !flags.baseline.empty() && !flags.updates_baseline;
    pipeline::CheckReport report;
    for (const std::string& path : flags.files) {
        report.files.push_back(pipeline::check_file(path));
        pipeline::FileCheck& file = report.files.back();
        if (compares) pipeline::compare_with(baseline, file);
        report.exit_code = pipeline::more_important(report.exit_code, file.exit_code);
        if (flags.format == Format::text)
            console.result(pipeline::check_text(file, console.colors_results(), console.is_verbose));
    }
    if (flags.format == Format::json) console.result(report::write_json(report::Described::of(report)));
    if (flags.updates_baseline) pipeline::update_baseline(flags.baseline, baseline, report.files);
    return report.exit_code;
}

int run_inspect(const FileFlags& flags, const Console& console) {
    const pipeline::InspectReport report = pipeline::inspect_file(flags.files.front());
    console.result(flags.format == Format::json
                       ? report::write_json(report::Described::of(report))
                       : pipeline::inspect_text(report, flags.lists_datasets || console.is_verbose));
    return pipeline::exit_ok;
}

int run_compare(const FileFlags& flags, const Console& console) {
    const pipeline::CompareReport report = pipeline::compare_files(flags.files[0], flags.files[1]);
    console.result(flags.format == Format::json ? report::write_json(report::Described::of(report))
                                                : pipeline::compare_text(report));
    return report.is_equal ? pipeline::exit_ok : pipeline::exit_difference;
}

using Run = int (*)(const FileFlags&, const Console&);

CLI::App* add_verb(CLI::App& app, Session& session, const std::string& name, const std::string& help, Run run,
                   const std::shared_ptr<FileFlags>& flags) {
    CLI::App* verb = app.add_subcommand(name, help);
    add_format_flag(*verb, flags->format);
    verb->callback(
        [flags, run, &session] { session.run = [flags, run, &session] { return run(*flags, session.console); }; });
    return verb;
}

}

void add_check(CLI::App& app, Session& session) {
    const auto flags = std::make_shared<FileFlags>();
    CLI::App* verb = add_verb(app, session, "check", "is a bundle whole, and is what it says true", run_check, flags);
    verb->add_option("BUNDLE", flags->files, "bundles or work files")->required();
    verb->add_option("--baseline", flags->baseline, "compare with what the assets were at when last found good")
        ->type_name("FILE");
    verb->add_flag("--update-baseline", flags->updates_baseline, "write what the files that pass are at now there");
    verb->footer(
        "Exit code 7: a file is damaged or breaks a rule; 4: a quality gate of its recipe is not met.\n"
        "Example: crumple check car.hdf bike.hdf --format json");
}

void add_inspect(CLI::App& app, Session& session) {
    const auto flags = std::make_shared<FileFlags>();
    CLI::App* verb = add_verb(app, session, "inspect", "what a file holds and how it came to be", run_inspect, flags);
    verb->add_option_function<std::string>(
            "FILE", [flags](const std::string& file) { flags->files = {file}; }, "a bundle or a work file")
        ->required();
    verb->add_flag("--datasets", flags->lists_datasets, "list every array");
    verb->footer("Example: crumple inspect car.hdf --format json");
}

void add_compare(CLI::App& app, Session& session) {
    const auto flags = std::make_shared<FileFlags>();
    CLI::App* verb =
        add_verb(app, session, "compare", "the first and the largest difference of two files", run_compare, flags);
    verb->add_option("FILE", flags->files, "two bundles or work files")->required()->expected(2);
    verb->footer("Exit code 0: they hold the same, 7: they do not.\nExample: crumple compare before.hdf after.hdf");
}

}
