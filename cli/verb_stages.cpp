// SPDX-License-Identifier: GPL-3.0-or-later
// Each stage as a verb: one entry of the recipe, run on a work file.
#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/import_flags.h"
#include "cli/output_flags.h"
#include "cli/output_paths.h"
#include "cli/stage_flags.h"
#include "cli/verbs.h"
#include "pipeline/builtin_recipes.h"
#include "pipeline/exit_codes.h"
#include "pipeline/input_digests.h"
#include "pipeline/output_file.h"
#include "pipeline/points_file.h"
#include "pipeline/runner.h"
#include "pipeline/work_file.h"
#include "report/json_writer.h"
#include "report/number_text.h"
#include "report/printable.h"
#include "report/text_view.h"

namespace crumple::cli {

namespace {

using pipeline::Recipe;
using pipeline::Stage;
using pipeline::Workspace;

struct StageFlags {
    std::string input;                    // a work file, or points
    std::shared_ptr<ImportFlags> import;  // of the first stage only
    OutputFlags output;
    std::string recipe;
    std::vector<std::string> settings;   // --set
    std::vector<Setting> flag_settings;  // --sweeps and the like
};

Recipe recipe_of(const Stage& stage, const StageFlags& flags) {
    Recipe recipe = pipeline::default_recipe();
    if (!flags.recipe.empty()) {
        const pipeline::RecipeText text = pipeline::load_recipe_text(flags.recipe);
        recipe = pipeline::read_recipe(text.json, text.source);
    }
    if (flags.import) apply_settings(recipe, flags.import->settings);
    apply_settings(recipe, flags.flag_settings);
    for (const std::string& setting : flags.settings) pipeline::apply_setting(recipe, with_stage(stage.name, setting));
    pipeline::check_recipe(recipe, flags.recipe.empty() ? "parameters" : flags.recipe);
    return recipe;
}

std::vector<std::string> inputs_of(const StageFlags& flags, const Recipe& recipe) {
    return flags.import ? input_paths(sources_of(*flags.import), recipe) : std::vector<std::string>{flags.input};
}

Workspace load_input(const Stage& stage, const StageFlags& flags) {
    Workspace work;
    if (flags.import) {
        work.sources = sources_of(*flags.import);
        return work;
    }
    const bool reads_points = stage.reads == std::vector{pipeline::Group::points};
    if (!reads_points || !pipeline::is_points_file(flags.input)) return pipeline::read_work_file(flags.input);
    work.points = pipeline::read_points_file(flags.input);
    work.input_digests.push_back(pipeline::digest_input("points", flags.input));
    return work;
}

// A stage alone is run to see what it does: its report is told without -v.
pipeline::Observer observer_of(const Console& console) {
    pipeline::Observer observer = console.observer();
    if (console.is_verbose) return observer;
    observer.end = [&console, end = observer.end](const Stage& stage, const auto& run, report::Described stage_report) {
        if (end) end(stage, run, stage_report);
        console.talk(report::report_text(stage_report));
    };
    return observer;
}

int run_stage_verb(const Stage& stage, const StageFlags& flags, const Console& console) {
    const Recipe recipe = recipe_of(stage, flags);
    const std::vector<std::string> inputs = inputs_of(flags, recipe);
    pipeline::check_output_path(flags.output.path, inputs);
    check_output_paths(
        {{"-o", flags.output.path},
         {"the place of what a quality gate refuses", pipeline::rejected_path(flags.output.path), false}},
        inputs);
    Workspace work = load_input(stage, flags);
    const auto& params = recipe.params[pipeline::stage_index(stage.name)];
    const pipeline::StageRun run =
        pipeline::run_stage(stage, params, work, thread_count(flags.output), observer_of(console));
    const std::vector<std::byte> image = pipeline::work_image(work, {true, flags.output.layout});
    if (flags.output.format == Format::json) console.result(report::write_json(report::Described::of(run)));
    console.talk(report::findings_text(run.findings, {console.colors_talk(), 0}));
    if (run.is_rejected()) pipeline::reject(run.findings, flags.output.path, image);
    const bool is_changed = pipeline::accept(flags.output.path, image);
    console.talk(report::printable(flags.output.path) + ": " + std::string(stage.name) + " in " +
                 report::number_text(run.usage.wall_s) + " s, " + report::findings_summary(run.findings) +
                 (is_changed ? "\n" : ", unchanged\n"));
    return pipeline::exit_ok;
}

std::string example_of(const Stage& stage) {
    const std::string name(stage.name);
    if (stage.reads.empty()) return "Example: crumple " + name + " --shell car.glb --visual car_detail.glb -o work.hdf";
    return "Example: crumple " + name + " work.hdf -o next.hdf";
}

void add_stage(CLI::App& app, const Stage& stage, Session& session) {
    CLI::App* verb =
        app.add_subcommand(std::string(stage.name), std::string(stage.help))->group("Stages, one at a time");
    const auto flags = std::make_shared<StageFlags>();
    const bool reads_points = stage.reads == std::vector{pipeline::Group::points};
    if (stage.reads.empty()) {
        flags->import = add_import_flags(*verb);
    } else {
        verb->add_option("INPUT", flags->input,
                         reads_points ? "a work file, or points: xyz txt pts csv tsv obj node" : "a work file")
            ->required();
    }
    add_output_flags(*verb, flags->output);
    verb->add_option("--recipe", flags->recipe, "take the parameters from a recipe");
    verb->add_option("--set", flags->settings, "set any parameter of the stage; may be repeated")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
    add_stage_flags(*verb, stage, flags->flag_settings);
    add_progress_flag(*verb, session.console);
    verb->footer(example_of(stage));
    verb->callback([&stage, flags, &session] {
        session.run = [&stage, flags, &session] { return run_stage_verb(stage, *flags, session.console); };
    });
}

}

void add_stages(CLI::App& app, Session& session) {
    for (const Stage& stage : pipeline::stage_table()) add_stage(app, stage, session);
}

}
