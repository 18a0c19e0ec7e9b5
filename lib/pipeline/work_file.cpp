// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/work_file.h"

#include "bundle/blob.h"
#include "bundle/validate.h"
#include "geometry/predicates.h"
#include "pipeline/contradictions.h"
#include "pipeline/cook_record.h"
#include "pipeline/quality_view.h"
#include "pipeline/work_parts.h"
#include "sandbox/sandbox.h"
#include "store/bundle_file.h"
#include "store/grid_view.h"
#include "store/read_file.h"

namespace crumple::pipeline {

namespace {

// The view that ParaView opens, for a file that has tets and no bundle yet: a bundle writes its own.
void write_view(store::FileWriter& file, const TetMesh& mesh) {
    store::write_grid(file, store::grid_cells(mesh.tets), "/tets/positions", mesh.positions.size());
    file.make_group("/VTKHDF/PointData");
    file.make_group("/VTKHDF/CellData");
    if (!mesh.region.empty()) file.link("/VTKHDF/CellData/region", "/tets/region");
}

// A stage takes what it reads for its own kind's work.
void require_sound_bundle(const Workspace& work, const std::string& name) {
    if (!work.bundle) return;
    const std::vector<Finding> problems = validate(*work.bundle);
    if (!problems.empty()) {
        throw Error(ErrorKind::bad_input,
                    name + ": damaged: " + problems.front().code + ": " + problems.front().message);
    }
}

}

std::vector<std::byte> work_image(const Workspace& work, const FileContents& contents) {
    store::FileWriter file(contents.layout);
    if (contents.has_work) {
        if (work.asset) write_asset(file, *work.asset);
        if (work.points) write_points(file, *work.points);
        if (work.tets) write_tets(file, *work.tets);
        if (work.bindings) write_bindings(file, *work.bindings);
        if (work.tets && !work.bundle) write_view(file, *work.tets);
    }
    if (work.bundle) store::write_bundle(file, *work.bundle);
    if (contents.has_work) store::write_view_fields(file, quality_view(work));
    file.write_text("/cook/record", cook_record_json(work));
    return file.finish();
}

Workspace read_work_image(std::vector<std::byte> image, const std::string& name) {
    if (is_blob(image)) {
        Workspace work;
        work.bundle = read_blob(image, name);
        return work;
    }
    const store::FileReader file(std::move(image), name);
    Workspace work;
    if (file.has("/asset")) work.asset = read_asset(file);
    if (file.has("/points")) work.points = read_points(file);
    if (file.has("/tets")) work.tets = read_tets(file);
    if (file.has("/bindings")) work.bindings = read_bindings(file);
    if (file.has("/bundle")) work.bundle = store::read_bundle(file);
    if (const auto found = find_contradiction(work)) file.refuse(found->path, found->what);
    if (file.has("/cook/record")) read_cook_record(file.read_text("/cook/record"), name, work);
    return work;
}

Workspace read_work_file(const std::string& path) {
    std::vector<std::byte> image = store::read_file(path);
    const auto outcome = sandbox::run_in_child(
        [&] {
            require_sound_bundle(read_work_image(image, path), path);
            return std::vector<std::byte>();
        },
        {});
    if (outcome.ending == sandbox::Ending::ok) return read_work_image(std::move(image), path);
    if (outcome.ending == sandbox::Ending::starved) throw Error(ErrorKind::budget, path + ": " + outcome.message);
    if (outcome.ending == sandbox::Ending::refused) throw Error(outcome.kind, outcome.message);
    throw Error(ErrorKind::bad_input, path + ": damaged: " + outcome.message);
}

}
