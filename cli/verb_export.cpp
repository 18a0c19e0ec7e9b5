// SPDX-License-Identifier: GPL-3.0-or-later
// crumple export
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <span>

#include "cli/output_flags.h"
#include "cli/output_paths.h"
#include "cli/verbs.h"
#include "pipeline/bundle_gates.h"
#include "pipeline/exit_codes.h"
#include "pipeline/export_mesh.h"
#include "pipeline/in_child.h"
#include "pipeline/work_file.h"
#include "report/number_text.h"
#include "report/printable.h"
#include "store/read_file.h"
#include "store/write_file.h"

namespace crumple::cli {

namespace {

using pipeline::ExportFormat;

struct ExportFlags {
    std::string input;
    std::string output;  // format by extension
    std::string vtu;
    std::string msh;
    std::string obj;
    std::string blob;
};

struct Target {
    std::string option;
    std::string path;
    ExportFormat format;
};

ExportFormat format_of(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    for (const auto& entry : pipeline::export_format_names) {
        if (extension == "." + std::string(entry.name)) return entry.value;
    }
    throw Error(ErrorKind::usage,
                path + ": the name must end in .vtu, .msh, .obj or .blob, or say --vtu, --msh, --obj or --blob");
}

std::vector<Target> targets_of(const ExportFlags& flags) {
    std::vector<Target> targets;
    if (!flags.output.empty()) targets.push_back({"-o", flags.output, format_of(flags.output)});
    if (!flags.vtu.empty()) targets.push_back({"--vtu", flags.vtu, ExportFormat::vtu});
    if (!flags.msh.empty()) targets.push_back({"--msh", flags.msh, ExportFormat::msh});
    if (!flags.obj.empty()) targets.push_back({"--obj", flags.obj, ExportFormat::obj});
    if (!flags.blob.empty()) targets.push_back({"--blob", flags.blob, ExportFormat::blob});
    if (targets.empty())
        throw Error(ErrorKind::usage,
                    "export: say where to: -o FILE, --vtu FILE, --msh FILE, --obj FILE or --blob FILE");
    return targets;
}

// A blob carries no record of gates: whoever ships it would not learn that they refused it.
void warn_of_gates(const std::vector<std::byte>& image, const ExportFlags& flags, const Console& console) {
    const std::string gates = pipeline::run_text_in_child(
        [&] { return pipeline::refused_by(pipeline::read_work_image(image, flags.input)); }, flags.input);
    if (gates.empty()) return;
    console.talk("warning: " + report::printable(flags.input) + ": quality gates refused this bundle (" +
                 report::printable(gates) + "); the blob does not say so, see crumple check\n");
}

int run_export(const ExportFlags& flags, const Console& console) {
    const std::vector<Target> targets = targets_of(flags);
    std::vector<OutputPath> outputs;
    for (const Target& target : targets) outputs.push_back({target.option, target.path});
    check_output_paths(outputs, {flags.input});
    const std::vector<std::byte> image = store::read_file(flags.input);
    const auto is_blob = [](const Target& target) { return target.format == ExportFormat::blob; };
    if (std::any_of(targets.begin(), targets.end(), is_blob)) warn_of_gates(image, flags, console);
    for (const Target& target : targets) {
        const std::string text = pipeline::run_text_in_child(
            [&] { return pipeline::export_work(pipeline::read_work_image(image, flags.input), target.format); },
            flags.input);
        store::write_file(target.path, std::as_bytes(std::span(text)));
        console.talk(report::printable(target.path) + ": " + report::size_text(text.size()) + "\n");
    }
    return pipeline::exit_ok;
}

}

void add_export(CLI::App& app, Session& session) {
    CLI::App* verb =
        app.add_subcommand("export", "the tets for other programs: VTU, gmsh, OBJ; the bundle for games: blob");
    const auto flags = std::make_shared<ExportFlags>();
    verb->add_option("FILE", flags->input, "a bundle or a work file")->required();
    verb->add_option("-o,--output", flags->output, "format by extension: .vtu .msh .obj .blob")->type_name("FILE");
    verb->add_option("--vtu", flags->vtu, "VTK unstructured grid with every array, for ParaView")->type_name("FILE");
    verb->add_option("--msh", flags->msh, "gmsh 2.2, regions as physical groups")->type_name("FILE");
    verb->add_option("--obj", flags->obj, "the boundary, locks as vertex colours (red 0 is locked)")->type_name("FILE");
    verb->add_option("--blob", flags->blob, "the whole bundle in one flat file, for games without HDF5")
        ->type_name("FILE");
    verb->footer("Example: crumple export car.hdf --vtu car.vtu --obj car_boundary.obj");
    verb->callback(
        [flags, &session] { session.run = [flags, &session] { return run_export(*flags, session.console); }; });
}

}
