// SPDX-License-Identifier: GPL-3.0-or-later
// One test shell: cooked to tets as a recipe says, and any tets measured against it, whoever made them.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "mesh/shell_interior.h"
#include "mesh/tet_mesh.h"
#include "pipeline/workspace.h"

namespace crumple::bench {

// Of test shells: that in the environment variable CRUMPLE_DATA, ../shared/data where it is not set.
[[nodiscard]] std::filesystem::path data_folder();

// run(), or 2 and a word on stderr where quality/ is not there.
int run_on_shells(int argc, char** argv, void (*add_all)(bool quick));

struct Made {
    TetMesh mesh;
    double cpu_s = 0;  // of the stages from the points to the last one that changes tets
    // Of these, of some; nothing for other people's meshes.
    std::optional<double> delaunay_relax_cull_s = {};
    std::optional<double> finish_s = {};
    std::size_t interior_points = 0;
};

class MeshCase {
public:
    // data_folder()/<folder>/<name>.obj
    explicit MeshCase(const std::string& name, const std::string& folder = "quality");

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] const std::string& name() const { return name_; }

    // With the defaults of every stage but for the settings ("finish.mode=peel"). Nothing, and the reason on stderr,
    // when a stage refuses.
    [[nodiscard]] std::optional<Made> cook(const std::vector<std::string>& settings) const;

    // nodes, tets, min_dihedral_deg, p5_dihedral_deg, below_10_deg, dt_ratio, pcg_soft, pcg_stiff, volume_error (signed
    // share), hausdorff_out and hausdorff_in (shares of the diagonal), inverted (tets of no volume or less),
    // non_manifold (edges and nodes of the tets' surface), cpu_s, delaunay_relax_cull_s, finish_s; nulls for no mesh.
    [[nodiscard]] std::vector<std::pair<std::string, Row::Value>> figures(const std::optional<Made>& made) const;

private:
    [[nodiscard]] double solid_volume() const;

    std::filesystem::path path_;
    std::string name_;
    pipeline::Workspace imported_;
    std::unique_ptr<ShellInterior> interior_;
    double volume_ = 0;
};

}
