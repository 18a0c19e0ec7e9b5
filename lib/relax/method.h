// SPDX-License-Identifier: GPL-3.0-or-later
// A method says where a node would best be, given the tets around it that lie inside.
#pragma once
#include <span>

#include "core/index.h"
#include "core/vec3.h"
#include "mesh/tet_mesh.h"
#include "relax/relax.h"

namespace crumple::relax {

struct Star {
    const TetMesh& mesh;
    Index node;                   // of the mesh
    std::span<const Index> tets;  // inside, at least one, all positive
    bool is_whole;                // no other tet meets the node
};

// May return any place, even one that is not finite: whoever moves the node checks.
using TargetFunction = Vec3 (*)(const Star& star);

[[nodiscard]] Vec3 target_cpt(const Star& star);
[[nodiscard]] Vec3 target_odt(const Star& star);
[[nodiscard]] Vec3 target_lloyd(const Star& star);

struct MethodEntry {
    Method method;
    TargetFunction target;
};
inline constexpr MethodEntry methods[] = {
    {Method::cpt, target_cpt},
    {Method::odt, target_odt},
    {Method::lloyd, target_lloyd},
};

}
