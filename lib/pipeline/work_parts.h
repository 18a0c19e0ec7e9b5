// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a work file one by one: how each is laid out, and the checks that make what is read safe to work with.
#pragma once
#include "mesh/asset.h"
#include "mesh/bindings.h"
#include "mesh/point_set.h"
#include "mesh/tet_mesh.h"
#include "store/hdf5_file.h"

namespace crumple::pipeline {

void write_asset(store::FileWriter& file, const Asset& asset);
void write_points(store::FileWriter& file, const PointSet& points);
void write_tets(store::FileWriter& file, const TetMesh& mesh);
void write_bindings(store::FileWriter& file, const Bindings& bindings);

// These refuse with Error(bad_input) arrays of sizes that do not fit, indices out of range, positions that are not
// finite and tets that are not positive.
[[nodiscard]] Asset read_asset(const store::FileReader& file);
[[nodiscard]] PointSet read_points(const store::FileReader& file);
[[nodiscard]] TetMesh read_tets(const store::FileReader& file);
[[nodiscard]] Bindings read_bindings(const store::FileReader& file);

}
