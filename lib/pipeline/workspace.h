// SPDX-License-Identifier: GPL-3.0-or-later
// What the stages hand on to each other, and what is known about how it came to be. The counterpart in a file is a work
// file (work_file.h).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "bundle/bundle.h"
#include "core/finding.h"
#include "importer/import.h"
#include "mesh/asset.h"
#include "mesh/bindings.h"
#include "mesh/point_set.h"
#include "mesh/tet_mesh.h"
#include "report/described.h"

namespace crumple::pipeline {

// The parts of a workspace, in the order the stages fill them; each is one group of a work file.
enum class Group : unsigned { asset, points, tets, bindings, bundle };
inline constexpr EnumName<Group> group_names[] = {{Group::asset, "asset"},
                                                  {Group::points, "points"},
                                                  {Group::tets, "tets"},
                                                  {Group::bindings, "bindings"},
                                                  {Group::bundle, "bundle"}};
constexpr std::span<const EnumName<Group>> enum_names(Group) { return group_names; }

// That a stage ran, with which parameters, and what it said. Only what the same input and recipe always give: no times.
struct StageRecord {
    std::string name;
    int version = 0;
    report::RawJson params;
    report::RawJson report;
};

template <class Visitor, FieldsOf<StageRecord> R>
void describe(Visitor& visit, R& r) {
    visit.field("name", r.name, "stage");
    visit.field("version", r.version, "of the stage's method");
    visit.field("params", r.params, "the parameters it ran with");
    visit.field("report", r.report, "what it said; schemas/stage_<name>.schema.json");
}

struct Workspace {
    importer::Sources sources;  // what import reads
    std::optional<Asset> asset;
    std::optional<PointSet> points;
    std::optional<TetMesh> tets;
    std::optional<Bindings> bindings;
    std::optional<Bundle> bundle;
    std::vector<BundleProvenance::Entry> input_digests;  // by name as in InputRecord -> SHA-256
    std::vector<StageRecord> records;                    // in the order of the stage table
};

[[nodiscard]] bool has_group(const Workspace& workspace, Group group);

// Forgets every group after `group`: they were made from what it held before.
void drop_after(Workspace& workspace, Group group);

}
