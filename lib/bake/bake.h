// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the tet mesh and its bindings into the float arrays a game loads. The one place where double becomes float.
#pragma once
#include <string>
#include <vector>

#include "bundle/bundle.h"
#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/asset.h"
#include "mesh/bindings.h"
#include "mesh/tet_mesh.h"

namespace crumple::bake {

inline constexpr int version = 1;

struct Params {};
struct Report {};

struct Result {
    Bundle bundle;  // provenance is left to the caller, who knows recipe and inputs
    Report report;
};

[[nodiscard]] Result bake_bundle(const Asset& asset, const TetMesh& mesh, const Bindings& bindings,
                                 const Params& params = {}, const Context& context = {});

}
