// SPDX-License-Identifier: GPL-3.0-or-later
// crumple simulate
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <span>

#include "cli/exit_codes.h"
#include "cli/output_flags.h"
#include "cli/output_paths.h"
#include "cli/verbs.h"
#include "pipeline/output_file.h"
#include "pipeline/work_file.h"
#include "report/number_text.h"
#include "report/printable.h"
#include "report/text_view.h"
#include "store/bundle_file.h"
#include "store/write_file.h"
#include "study/gltf.h"
#include "study/load_scene.h"

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

std::string frame_name(const std::string& stem, const std::string& mesh, std::size_t frame) {
    std::string digits = std::to_string(frame);
    digits.insert(0, 5 - std::min<std::size_t>(5, digits.size()), '0');
    return stem + "_" + store::encode_name(mesh) + "_" + digits + ".hdf";
}

// run.hdf -> run_series/run_control_00000.hdf ... and run_series/run_control.hdf.series
class Series {
public:
    explicit Series(const std::string& output) {
        const std::filesystem::path path(output);
        stem_ = path.stem().string();
        folder_ = path.parent_path() / (stem_ + "_series");
        std::error_code error;
        std::filesystem::create_directories(folder_, error);
        if (error) throw Error(ErrorKind::file, folder_.string() + ": " + error.message());
    }
    template <class ImageOf>
    void write(const std::string& mesh, const study::Run& run, ImageOf&& image_of) const {
        std::vector<study::SeriesFile> files;
        for (std::size_t i = 0; i < run.frames.size(); ++i) {
            files.push_back({frame_name(stem_, mesh, i), run.frames[i].time_s});
            const std::vector<std::byte> image = image_of(run.frames[i]);
            store::write_file((folder_ / files.back().name).string(), image);
        }
        const std::string index = study::series_index(files);
        store::write_file((folder_ / (stem_ + "_" + store::encode_name(mesh) + ".hdf.series")).string(),
                          std::as_bytes(std::span(index)));
    }
    [[nodiscard]] std::string folder() const { return folder_.string(); }

private:
    std::filesystem::path folder_;
    std::string stem_;
};

void write_series(const std::string& output, const Bundle& bundle, const study::Run& run,
                  const study::VisualTriangles& triangles) {
    const Series series(output);
    series.write("control", run, [&](const study::Frame& f) { return study::control_image(bundle, f); });
    for (std::size_t i = 0; i < bundle.visuals.size(); ++i) {
        series.write(bundle.visuals[i].name, run,
                     [&](const study::Frame& f) { return study::visual_image(f, i, triangles[i]); });
    }
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
}

int run_simulate(const SimulateFlags& flags, const Console& console) {
    const study::Scene scene = study::load_scene(flags.scene);
    check_outputs(flags);
    const pipeline::Workspace work = pipeline::read_work_file(flags.input);
    if (!work.bundle)
        throw Error(ErrorKind::usage, report::printable(flags.input) + ": holds no bundle; run crumple bake");
    Context context;
    context.jobs = flags.jobs;
    const study::Run run = study::simulate(*work.bundle, scene, context);
    const study::VisualTriangles triangles = triangles_of(work);
    store::write_file(flags.output, study::run_image(*work.bundle, scene, run));
    if (flags.has_series) write_series(flags.output, *work.bundle, run, triangles);
    if (!flags.formats.empty()) {
        const std::string glb = study::run_glb(*work.bundle, run, triangles);
        store::write_file(glb_path(flags), std::as_bytes(std::span(glb)));
    }
    console.talk(summary_of(run) + report::findings_text(run.findings, {}));
    return exit_ok;
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
