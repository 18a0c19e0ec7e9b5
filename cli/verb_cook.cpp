// SPDX-License-Identifier: GPL-3.0-or-later
// crumple cook
#include <CLI/CLI.hpp>
#include <cmath>
#include <span>

#include "cli/depfile.h"
#include "cli/guarded.h"
#include "cli/import_flags.h"
#include "cli/output_flags.h"
#include "cli/output_paths.h"
#include "cli/verbs.h"
#include "pipeline/builtin_recipes.h"
#include "pipeline/cook.h"
#include "pipeline/cook_text.h"
#include "pipeline/exit_codes.h"
#include "pipeline/last_report.h"
#include "pipeline/output_file.h"
#include "report/json_writer.h"
#include "store/write_file.h"

namespace crumple::cli {

namespace {

using pipeline::CookReport;
using pipeline::CookRequest;
using pipeline::Recipe;

struct CookFlags {
    std::string recipe;
    std::shared_ptr<ImportFlags> import;
    OutputFlags output;
    std::vector<std::string> settings;
    pipeline::Budget budget;
    std::string report;
    std::string depfile;
    bool keeps_work = false;
    bool is_dry_run = false;
    bool checks_determinism = false;
};

Recipe load_recipe(const CookFlags& flags) {
    const pipeline::RecipeText text = pipeline::load_recipe_text(flags.recipe);
    Recipe recipe = pipeline::read_recipe(text.json, text.source);
    apply_settings(recipe, flags.import->settings);
    for (const std::string& setting : flags.settings) pipeline::apply_setting(recipe, setting);
    pipeline::check_recipe(recipe, flags.recipe);
    return recipe;
}

CookRequest request_of(const CookFlags& flags) {
    CookRequest request;
    request.sources = sources_of(*flags.import);
    request.output = flags.output.path;
    request.contents = {flags.keeps_work, flags.output.layout};
    request.jobs = thread_count(flags.output);
    request.checks_determinism = flags.checks_determinism;
    return request;
}

std::vector<std::string> inputs_of(const CookFlags& flags, const Recipe& recipe, const CookRequest& request) {
    std::vector<std::string> inputs = input_paths(request.sources, recipe);
    if (pipeline::is_recipe_path(flags.recipe)) inputs.push_back(flags.recipe);
    return inputs;
}

bool is_stdout(const std::string& path) { return path == "-"; }

bool is_file(const std::string& path) { return !path.empty() && !is_stdout(path); }

// A program that reads our stdout wants one thing there.
void check_stdout(const CookFlags& flags) {
    const bool has_json = is_stdout(flags.report) || flags.output.format == Format::json;
    if (is_stdout(flags.depfile) && has_json)
        throw Error(ErrorKind::usage, "--depfile - and the JSON would both go to stdout; give one of them a file");
}

// Everything that can be known to be wrong before hours of work.
void check_paths(const CookFlags& flags, const CookRequest& request, const std::vector<std::string>& inputs) {
    check_stdout(flags);
    pipeline::check_output_path(request.output, inputs);
    std::vector<OutputPath> outputs{{"-o", request.output}};
    if (is_file(flags.report)) outputs.push_back({"--report", flags.report});
    if (is_file(flags.depfile)) outputs.push_back({"--depfile", flags.depfile});
    outputs.push_back({"the place of what a quality gate refuses", pipeline::rejected_path(request.output), false});
    check_output_paths(outputs, inputs);
    if (!flags.depfile.empty()) (void)depfile_text(request.output, inputs);
}

void write_text(const std::string& path, const std::string& text) {
    store::write_file(path, std::as_bytes(std::span(text)));
}

std::string json_of(const CookReport& report) { return report::write_json(report::Described::of(report)); }

void print_report(const CookFlags& flags, const CookReport& report, const Console& console) {
    if (is_stdout(flags.report) || flags.output.format == Format::json) console.result(json_of(report));
}

// What stopped the cook is said first, and stays the reason when the report cannot be written either.
int end_failed(const CookFlags& flags, const CookReport& report, const Console& console) {
    console.error(report.error);
    (void)run_guarded(console, [&] {
        if (is_file(flags.report)) write_text(flags.report, json_of(report));
        print_report(flags, report, console);
        return pipeline::exit_ok;
    });
    return report.exit_code;
}

// What goes beside the output, so that a disk too full for it leaves the old output.
void write_beside(const CookFlags& flags, const CookReport& report, const std::vector<std::string>& inputs) {
    if (is_file(flags.report)) write_text(flags.report, json_of(report));
    if (is_file(flags.depfile)) write_text(flags.depfile, depfile_text(flags.output.path, inputs));
}

struct CookCall {
    const CookFlags& flags;
    const Recipe& recipe;
    CookRequest request;
    std::vector<std::string> inputs;  // paths
};

int cook_now(CookCall call, const Console& console, const pipeline::Permission& may_finish) {
    const CookFlags& flags = call.flags;
    CookRequest& request = call.request;
    CookReport report;
    report.recipe = flags.recipe;
    request.may_finish = may_finish;
    request.before_output = [&](const CookReport& done) { write_beside(flags, done, call.inputs); };
    try {
        pipeline::cook(call.recipe, request, report, console.observer());
    } catch (const Error& error) {
        report.error = error.what();
        report.exit_code = pipeline::exit_code_of(error.kind());
    } catch (const std::bad_alloc&) {
        report.error = "out of memory";
        report.exit_code = pipeline::exit_code_of(ErrorKind::budget);
    }
    if (report.output.is_rejected) console.talk(pipeline::cook_text(report, request.output, console.colors_talk()));
    if (report.exit_code != pipeline::exit_ok) return end_failed(flags, report, console);
    print_report(flags, report, console);
    if (is_stdout(flags.depfile)) console.result(depfile_text(flags.output.path, call.inputs));
    console.talk(pipeline::cook_text(report, request.output, console.colors_talk()));
    return pipeline::exit_ok;
}

int run_dry(const CookFlags& flags, const Recipe& recipe, const CookRequest& request, const Console& console) {
    const pipeline::DryRunReport report = pipeline::dry_run(recipe, request);
    console.result(flags.output.format == Format::json ? report::write_json(report::Described::of(report))
                                                       : pipeline::dry_run_text(report, request.output));
    return pipeline::exit_ok;
}

int cook_within(CookCall call, const Console& console) {
    const CookFlags& flags = call.flags;
    pipeline::LastReport last;
    call.request.keep_report = [&last](const CookReport& report) { last.keep(report); };
    try {
        return pipeline::run_within(flags.budget, [&](const pipeline::Permission& may_finish) {
            return run_guarded(console, [&] { return cook_now(call, console, may_finish); });
        });
    } catch (const Error& error) {
        CookReport report = last.read();
        report.recipe = flags.recipe;
        report.error = error.what();
        if (!report.stopped_in.empty()) report.error += "; it was in " + report.stopped_in;
        report.exit_code = pipeline::exit_code_of(error.kind());
        return end_failed(flags, report, console);
    }
}

int run_cook(const CookFlags& flags, const Console& console) {
    const Recipe recipe = load_recipe(flags);
    const CookRequest request = request_of(flags);
    const std::vector<std::string> inputs = inputs_of(flags, recipe, request);
    check_paths(flags, request, inputs);
    if (flags.is_dry_run) return run_dry(flags, recipe, request, console);
    const CookCall call{flags, recipe, request, inputs};
    return flags.budget.is_limited() ? cook_within(call, console) : cook_now(call, console, {});
}

// CLI11's own lets nan through, which is no limit at all.
CLI::Validator positive_number() {
    return {[](const std::string& text) -> std::string {
                double value = 0;
                if (CLI::detail::lexical_cast(text, value) && value > 0 && std::isfinite(value)) return {};
                return "'" + text + "' is not a number above 0";
            },
            "NUMBER > 0"};
}

// A script's variable that is not set would leave out what was asked for without a word.
CLI::Validator file_name() {
    return {[](const std::string& text) { return text.empty() ? std::string("it names no file") : std::string(); }, ""};
}

}

void add_cook(CLI::App& app, Session& session) {
    CLI::App* verb = app.add_subcommand("cook", "from a painted shell and its visual meshes to a checked bundle");
    const auto flags = std::make_shared<CookFlags>();
    verb->add_option("RECIPE", flags->recipe, "name (car_body, soft_body, preview, smoke) or path of a recipe")
        ->required();
    flags->import = add_import_flags(*verb);
    add_output_flags(*verb, flags->output);
    verb->add_option("--set", flags->settings, "change the recipe, for example relax.sweeps=5; may be repeated")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
    verb->add_flag("--keep-work", flags->keeps_work, "leave what the stages made in the file");
    verb->add_option("--report", flags->report, "write figures and findings as JSON; - for stdout")
        ->type_name("FILE")
        ->check(file_name());
    verb->add_option("--depfile", flags->depfile, "write what the output depends on, for make and ninja; - for stdout")
        ->type_name("FILE")
        ->check(file_name());
    verb->add_flag("--dry-run", flags->is_dry_run, "say what would be cooked and why, and write nothing");
    verb->add_flag("--check-determinism", flags->checks_determinism, "cook twice at different --jobs, compare");
    verb->add_option("--timeout", flags->budget.time_s, "seconds the cook may take")->check(positive_number());
    verb->add_option("--max-memory", flags->budget.memory_mb, "megabytes it may hold")->check(positive_number());
    add_progress_flag(*verb, session.console);
    verb->footer(
        "Example: crumple cook car_body --shell car.glb --visual body=car_detail.glb -o car.hdf --report car.json");
    verb->callback(
        [flags, &session] { session.run = [flags, &session] { return run_cook(*flags, session.console); }; });
}

}
