// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/mesh_case.h"

#include <cstdlib>
#include <iostream>

#include "core/error.h"
#include "core/random.h"
#include "cull/cull.h"
#include "cull/fidelity.h"
#include "cull/shell_solid.h"
#include "geometry/measures.h"
#include "mesh/boundary.h"
#include "pipeline/recipe.h"
#include "pipeline/runner.h"
#include "quality/cost.h"
#include "quality/quality.h"

namespace crumple::bench {

std::filesystem::path data_folder() {
    const char* folder = std::getenv("CRUMPLE_DATA");
    return folder ? folder : "../shared/data";
}

int run_on_shells(int argc, char** argv, void (*add_all)(bool quick)) {
    if (!std::filesystem::is_directory(data_folder() / "quality")) {
        std::cerr << (data_folder() / "quality").string()
                  << " is not there; set CRUMPLE_DATA to the folder of test shells\n";
        return 2;
    }
    return run(argc, argv, add_all);
}

MeshCase::MeshCase(const std::string& name, const std::string& folder)
    : path_(data_folder() / folder / (name + ".obj")), name_(name) {
    imported_.sources.shell = path_.string();
    const pipeline::Stage& import = pipeline::find_stage("import");
    (void)pipeline::run_stage(import, import.make_params(), imported_, 1);
    interior_ = std::make_unique<ShellInterior>(imported_.asset->shell);
    volume_ = solid_volume();
}

std::optional<Made> MeshCase::cook(const std::vector<std::string>& settings) const {
    try {
        pipeline::Recipe recipe = pipeline::default_recipe();
        for (const std::string& setting : settings) pipeline::apply_setting(recipe, setting);
        pipeline::Workspace work = imported_;
        Made made;
        made.delaunay_relax_cull_s = 0;
        const auto table = pipeline::stage_table();
        for (std::size_t i = 1; i < pipeline::stage_index("bind"); ++i) {
            const pipeline::Stage& stage = table[i];
            const double cpu_s = pipeline::run_stage(stage, recipe.params[i], work, 1).usage.cpu_s;
            made.cpu_s += cpu_s;
            if (stage.name == "finish") made.finish_s = cpu_s;
            if (stage.name == "delaunay" || stage.name == "relax" || stage.name == "cull") {
                *made.delaunay_relax_cull_s += cpu_s;
            }
        }
        made.interior_points = work.points->positions.size() - work.points->shell_vertex_count;
        made.mesh = std::move(*work.tets);
        return made;
    } catch (const Error& error) {
        std::cerr << name_ << ": " << error.what() << '\n';
        return std::nullopt;
    }
}

// Exact for closed shells that do not cross, else by a million samples, stratified over the box.
double MeshCase::solid_volume() const {
    const Shell& shell = imported_.asset->shell;
    const cull::ShellSolid solid = cull::study_solid(shell, *interior_);
    if (solid.is_exact()) return solid.volume;
    constexpr int per_axis = 100;
    const Box box = bounding_box(shell.positions);
    const Vec3 cell = (box.high - box.low) / per_axis;
    Rng rng(1);
    std::size_t inside = 0;
    for (int x = 0; x < per_axis; ++x) {
        for (int y = 0; y < per_axis; ++y) {
            for (int z = 0; z < per_axis; ++z) {
                const double u = rng.next_unit();
                const double v = rng.next_unit();
                const double w = rng.next_unit();
                const Vec3 p = box.low + Vec3{(x + u) * cell.x, (y + v) * cell.y, (z + w) * cell.z};
                inside += interior_->material_at(p) != none ? 1 : 0;
            }
        }
    }
    return static_cast<double>(inside) * cell.x * cell.y * cell.z;
}

std::vector<std::pair<std::string, Row::Value>> MeshCase::figures(const std::optional<Made>& made) const {
    std::vector<std::pair<std::string, Row::Value>> figures;
    const auto add = [&](const char* key, double value) {
        figures.push_back({key, made ? std::optional(value) : std::nullopt});
    };
    const TetMesh empty;
    const TetMesh& mesh = made ? made->mesh : empty;
    const quality::Summary shape = quality::summarize(mesh);
    const quality::Cost cost = quality::measure_cost(mesh.positions, mesh.tets);
    const std::vector<Triangle> faces = boundary_of(mesh).faces;
    const NonManifold touching = non_manifold(faces);
    cull::Fidelity fidelity;
    if (made) {
        fidelity = cull::measure_fidelity(imported_.asset->shell, *interior_, mesh.positions, faces,
                                          cull::Params().hausdorff_samples, {});
    }
    const double diagonal = fidelity.diagonal > 0 ? fidelity.diagonal : 1;
    add("nodes", shape.nodes);
    add("tets", shape.tets);
    add("min_dihedral_deg", shape.min_dihedral_deg);
    add("p5_dihedral_deg", shape.p5_dihedral_deg);
    add("below_10_deg", shape.below_10_deg);
    add("dt_ratio", cost.dt_ratio);
    add("pcg_soft", cost.pcg_soft);
    add("pcg_stiff", cost.pcg_stiff);
    add("volume_error", (shape.volume - volume_) / volume_);
    add("hausdorff_out", fidelity.out.distance / diagonal);
    add("hausdorff_in", fidelity.in.distance / diagonal);
    add("inverted", shape.inverted);
    add("non_manifold", static_cast<double>(touching.edges.size() + touching.vertices.size()));
    add("cpu_s", made ? made->cpu_s : 0);
    figures.push_back({"delaunay_relax_cull_s", made ? made->delaunay_relax_cull_s : std::nullopt});
    figures.push_back({"finish_s", made ? made->finish_s : std::nullopt});
    return figures;
}

}
