// SPDX-License-Identifier: GPL-3.0-or-later
// crumple simulate
#include <CLI/CLI.hpp>
#include <filesystem>
#include <span>

#include "cli/output_flags.h"
#include "cli/output_paths.h"
#include "cli/run_series.h"
#include "cli/verbs.h"
#include "pipeline/exit_codes.h"
#include "pipeline/output_file.h"
#include "pipeline/work_file.h"
#include "report/number_text.h"
#include "report/printable.h"
#include "report/text_view.h"
#include "store/write_file.h"
#include "study/gltf.h"
#include "study/load_scene.h"
#include "study/simulate.h"

namespace crumple::cli {

namespace {

struct SimulateFlags {
    std::string input;
    std::string scene;
    std::string output;
    std::vector<std::string> formats;
    unsigned jobs = 1;
    bool has_series = true;
};

// Triangles of the visual meshes where the file still holds them (cook --keep-work).
study::VisualTriangles triangles_of(const pipeline::Workspace& work) {
    study::VisualTriangles triangles(work.bundle->visuals.size());
    for (std::size_t i = 0; work.asset && i < triangles.size(); ++i) {
        for (const VisualMesh& mesh : work.asset->visuals) {
            if (mesh.name == work.bundle->visuals[i].name &&
                mesh.positions.size() == work.bundle->visuals[i].tet.size()) {
                triangles[i] = mesh.triangles;
            }
        }
    }
    return triangles;
}

void write_series(RunSeries& series, const Bundle& bundle, const study::Run& run,
                  const study::VisualTriangles& triangles) {
    series.write("control", run, [&](const study::Frame& f) { return study::control_image(bundle, f); });
    for (std::size_t i = 0; i < bundle.visuals.size(); ++i) {
        series.write(bundle.visuals[i].name, run,
                     [&](const study::Frame& f) { return study::visual_image(f, i, triangles[i]); });
    }
    series.remove_stale();
}

std::string summary_of(const study::Run& run) {
    const auto text = [](double number) { return report::number_text(number, 3); };
    const study::Frame& last = run.frames.back();
    return std::to_string(run.steps) + " steps, " + std::to_string(run.frames.size()) + " frames; a step takes " +
           text(run.times.median_ms) + " ms, 99 % under " + text(run.times.p99_ms) + " ms\n" + "deepest dent " +
           text(run.deepest_dent_m) + " m, locked nodes moved by " + text(run.locked_drift) + " of the size, " +
           std::to_string(run.inverted_at_end) + " tets inside out, " +
           (last.is_asleep ? std::string("asleep") : text(last.kinetic_j) + " J of motion left") + "\n";
}

std::string glb_path(const SimulateFlags& flags) {
    return std::filesystem::path(flags.output).replace_extension(".glb").string();
}

void check_outputs(const SimulateFlags& flags) {
    pipeline::check_output_path(flags.output, {flags.input, flags.scene});
    std::vector<OutputPath> outputs{{"-o", flags.output}};
    if (!flags.formats.empty()) outputs.push_back({"--export gltf", glb_path(flags)});
    check_output_paths(outputs, {flags.input, flags.scene});
    if (flags.has_series) RunSeries(flags.output).check({flags.input, flags.scene});
}

// A damaged file is damage here too, as check and export call it; one without a bundle is whole.
pipeline::Workspace read_bundle(const std::string& path) {
    try {
        return pipeline::read_work_file(path);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input) throw;
        throw Error(ErrorKind::difference, error.what());
    }
}

int run_simulate(const SimulateFlags& flags, const Console& console) {
    const study::Scene scene = study::load_scene(flags.scene);
    check_outputs(flags);
    const pipeline::Workspace work = read_bundle(flags.input);
    if (!work.bundle)
        throw Error(ErrorKind::bad_input,
                    report::printable(flags.input) + ": there is no bundle yet; run crumple bake first");
    Context context;
    context.jobs = flags.jobs;
    const study::Run run = study::simulate(*work.bundle, scene, context);
    const study::VisualTriangles triangles = triangles_of(work);
    const std::vector<std::byte> image = study::run_image(*work.bundle, scene, run);
    if (flags.has_series) {
        RunSeries series(flags.output);
        write_series(series, *work.bundle, run, triangles);
    }
    if (!flags.formats.empty()) {
        const std::string glb = study::run_glb(*work.bundle, run, triangles);
        store::write_file(glb_path(flags), std::as_bytes(std::span(glb)));
    }
    store::write_file(flags.output, image);
    console.talk(summary_of(run) + report::findings_text(run.findings, {}));
    return pipeline::exit_ok;
}

}

void add_simulate(CLI::App& app, Session& session) {
    CLI::App* verb = app.add_subcommand("simulate", "play a scene with a bundle");
    const auto flags = std::make_shared<SimulateFlags>();
    verb->add_option("FILE", flags->input, "a bundle; with --keep-work its visual meshes have triangles")->required();
    verb->add_option("--scene", flags->scene, "wall, pole, side_impact, drop, twist, handles, or a .json")->required();
    verb->add_option("-o,--output", flags->output, "numbers of the run; a series for ParaView beside it")
        ->required()
        ->type_name("RUN.hdf");
    verb->add_option("--export", flags->formats, "gltf: the run as an animation, RUN.glb")
        ->check(CLI::IsMember({"gltf"}));
    verb->add_flag("!--no-series", flags->has_series, "no files for ParaView");
    verb->add_option("-j,--jobs", flags->jobs, "threads; the result is the same for any number")
        ->check(CLI::Range(1, 1024));
    verb->footer("Example: crumple simulate car.hdf --scene pole -o pole.hdf --export gltf");
    verb->callback(
        [flags, &session] { session.run = [flags, &session] { return run_simulate(*flags, session.console); }; });
}

}
