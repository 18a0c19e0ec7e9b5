// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way from a shell to tets against other mesh generators: how many tets, how good, how near to the shell, at
// what price. One row a shell and tool:
//   crumple          default settings
//   crumple_matched  as many interior points as bring the tets within a tenth of HXT's (TetGen's where HXT fails)
//   crumple_peel     as crumple, finish.mode peel; crumple_none: none
//   tetgen, hxt, gmsh  as packaged by Debian
// Every figure is measured here, on the mesh, in the same way for all tools. A tool that fails is a row of nulls. The
// shells are read from quality/ in the folder CRUMPLE_DATA, which is ../shared/data where the variable is not set.
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "bench/bench.h"
#include "bench/mesh_peers.h"
#include "core/error.h"
#include "core/random.h"
#include "cull/cull.h"
#include "cull/fidelity.h"
#include "cull/shell_solid.h"
#include "geometry/measures.h"
#include "mesh/boundary.h"
#include "mesh/shell_interior.h"
#include "pipeline/recipe.h"
#include "pipeline/runner.h"
#include "quality/figures.h"

namespace crumple {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> all_shells{"bonnet", "boxnest", "carbody", "carhood",
                                          "cow",    "fandisk", "spot",    "suzanne"};
const std::vector<std::string> quick_shells{"spot", "carbody", "bonnet"};

fs::path data_folder() {
    const char* folder = std::getenv("CRUMPLE_DATA");
    return fs::path(folder ? folder : "../shared/data") / "quality";
}

// Tets, and what making them cost; without tets where it failed.
struct Made {
    TetMesh mesh;
    double cpu_s = 0;
    std::size_t interior_points = 0;
};

class Bench {
public:
    explicit Bench(std::string name) : name_(std::move(name)) {
        pipeline::Workspace work;
        work.sources.shell = path().string();
        const pipeline::Stage& import = pipeline::find_stage("import");
        (void)pipeline::run_stage(import, import.make_params(), work, 1);
        imported_ = std::move(work);
        interior_ = std::make_unique<ShellInterior>(shell());
        volume_ = solid_volume();
    }

    std::vector<bench::Row> rows() {
        const std::optional<Made> ours = crumple({});
        const std::optional<bench::PeerMesh> tetgen = peer("tetgen");
        const std::optional<bench::PeerMesh> hxt = peer("hxt");
        const std::optional<bench::PeerMesh> gmsh = peer("gmsh");
        std::vector<bench::Row> rows;
        rows.push_back(row("crumple", ours));
        if (ours && (hxt || tetgen)) rows.push_back(row("crumple_matched", matched(*ours, hxt ? *hxt : *tetgen)));
        rows.push_back(row("crumple_peel", crumple({"finish.mode=peel"})));
        rows.push_back(row("crumple_none", crumple({"finish.mode=none"})));
        rows.push_back(row("tetgen", made_of(tetgen)));
        rows.push_back(row("hxt", made_of(hxt)));
        rows.push_back(row("gmsh", made_of(gmsh)));
        return rows;
    }

private:
    [[nodiscard]] fs::path path() const { return data_folder() / (name_ + ".obj"); }
    [[nodiscard]] const Shell& shell() const { return imported_.asset->shell; }

    // From the points to the last stage that changes tets. Nothing when a stage refuses.
    [[nodiscard]] std::optional<Made> crumple(const std::vector<std::string>& settings) const {
        try {
            pipeline::Recipe recipe = pipeline::default_recipe();
            for (const std::string& setting : settings) pipeline::apply_setting(recipe, setting);
            pipeline::Workspace work = imported_;
            Made made;
            const auto table = pipeline::stage_table();
            for (std::size_t i = 1; i < pipeline::stage_index("bind"); ++i) {
                made.cpu_s += pipeline::run_stage(table[i], recipe.params[i], work, 1).usage.cpu_s;
            }
            made.interior_points = work.points->positions.size() - work.points->shell_vertex_count;
            made.mesh = std::move(*work.tets);
            return made;
        } catch (const Error& error) {
            std::cerr << name_ << ": " << error.what() << '\n';
            return std::nullopt;
        }
    }

    // Tets grow about as fast as points: a secant finds the number, the nearest of its meshes is taken.
    [[nodiscard]] std::optional<Made> matched(const Made& automatic, const bench::PeerMesh& peer) const {
        const auto wanted = static_cast<double>(peer.mesh.tets.size());
        const auto error = [&](const Made& m) { return static_cast<double>(m.mesh.tets.size()) - wanted; };
        std::optional<Made> low = crumple({"sample.count=0"});
        if (!low) return std::nullopt;
        Made best = std::fabs(error(*low)) < std::fabs(error(automatic)) ? *low : automatic;
        Made a = *low;
        Made b = automatic;
        for (int round = 0; round < 6 && std::fabs(error(best)) > 0.03 * wanted; ++round) {
            const double slope = (error(b) - error(a)) /
                                 (static_cast<double>(b.interior_points) - static_cast<double>(a.interior_points));
            if (!(slope > 0)) break;
            const double points = static_cast<double>(b.interior_points) - error(b) / slope;
            if (!(points >= 1) || points > 1e6) break;
            std::optional<Made> next = crumple({"sample.count=" + std::to_string(static_cast<long>(points + 0.5))});
            if (!next || next->interior_points == b.interior_points) break;
            a = std::move(b);
            b = std::move(*next);
            if (std::fabs(error(b)) < std::fabs(error(best))) best = b;
        }
        return best;
    }

    [[nodiscard]] std::optional<bench::PeerMesh> peer(const std::string& tool) const {
        const fs::path folder = fs::temp_directory_path() / "crumple_bench_mesh" / name_ / tool;
        auto result = bench::run_peer(tool, bench::read_raw_shell(path()), folder);
        fs::remove_all(folder);
        return result;
    }

    static std::optional<Made> made_of(const std::optional<bench::PeerMesh>& peer) {
        if (!peer) return std::nullopt;
        return Made{peer->mesh, peer->cpu_s, 0};
    }

    // Exact for closed shells that do not cross, else by a million samples, stratified over the box.
    [[nodiscard]] double solid_volume() const {
        const cull::ShellSolid solid = cull::study_solid(shell(), *interior_);
        if (solid.is_exact()) return solid.volume;
        constexpr int per_axis = 100;
        const Box box = bounding_box(shell().positions);
        const Vec3 cell = (box.high - box.low) / per_axis;
        Rng rng(1);
        std::size_t inside = 0;
        for (int i = 0; i < per_axis * per_axis * per_axis; ++i) {
            Vec3 p{static_cast<double>(i / (per_axis * per_axis)), static_cast<double>(i / per_axis % per_axis),
                   static_cast<double>(i % per_axis)};
            for (int axis = 0; axis < 3; ++axis) p[axis] = box.low[axis] + (p[axis] + rng.next_unit()) * cell[axis];
            inside += interior_->material_at(p) != none ? 1 : 0;
        }
        return static_cast<double>(inside) * cell.x * cell.y * cell.z;
    }

    [[nodiscard]] bench::Row row(const std::string& tool, const std::optional<Made>& made) const {
        bench::Row row{{}, {}, {{"shell", name_}, {"tool", tool}}};
        const auto add = [&](const char* key, double value) {
            row.figures.push_back({key, made ? std::optional(value) : std::nullopt});
        };
        const TetMesh empty;
        const TetMesh& mesh = made ? made->mesh : empty;
        const quality::Summary shape = quality::summarize(mesh);
        const quality::Cost cost = quality::measure_cost(mesh.positions, mesh.tets);
        const cull::Fidelity fidelity =
            made ? cull::measure_fidelity(shell(), *interior_, mesh.positions, boundary_of(mesh).faces,
                                          cull::Params().hausdorff_samples, {})
                 : cull::Fidelity{};
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
        add("cpu_s", made ? made->cpu_s : 0);
        return row;
    }

    std::string name_;
    pipeline::Workspace imported_;
    std::unique_ptr<ShellInterior> interior_;
    double volume_ = 0;
};

void add_all(bool quick) {
    for (const std::string& name : quick ? quick_shells : all_shells) {
        bench::add_once("mesh/" + name, [name] { return Bench(name).rows(); });
    }
}

}
}

int main(int argc, char** argv) {
    if (!std::filesystem::is_directory(crumple::data_folder())) {
        std::cerr << crumple::data_folder().string()
                  << " is not there; set CRUMPLE_DATA to the folder of test shells\n";
        return 2;
    }
    return crumple::bench::run(argc, argv, crumple::add_all);
}
