// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness and mass of a whole mesh at rest: what an explicit step is bounded by and an implicit one solves.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple::quality {

using Block = std::array<double, 9>;  // 3 x 3 by rows

// Of isotropic linear elasticity with Young's modulus 1, Poisson's ratio 0.3 and density 1, so that a time is a length:
// multiplied by the speed of sound sqrt(young / density), metres. N nodes that some tet uses, B blocks.
struct ElasticSystem {
    std::vector<Index> node;       // N: in the mesh, ascending
    std::vector<double> mass;      // N: a quarter of the volume of each of its tets
    std::vector<Index> row_start;  // N + 1
    std::vector<Index> column;     // B: ascending in a row
    std::vector<Block> stiffness;  // B

    [[nodiscard]] std::size_t size() const { return node.size(); }
};

// REQUIRES: every tet has a positive volume.
[[nodiscard]] ElasticSystem assemble(std::span<const Vec3> positions, std::span<const Tet> tets);

// y = K x. REQUIRES: x and y of N.
void multiply(const ElasticSystem& system, std::span<const Vec3> x, std::span<Vec3> y);

}
