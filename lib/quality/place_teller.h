// SPDX-License-Identifier: GPL-3.0-or-later
// Tells an artist where something is: what it measures, in which component, of which material, by which painted vertex.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/finding.h"
#include "mesh/tet_mesh.h"
#include "quality/embedding.h"
#include "quality/shell_limits.h"

namespace crumple::quality {

// How places are told to the artist; what is empty is left out.
struct PlaceNames {
    std::span<const std::string> components;      // by TetMesh::region
    std::span<const std::string> materials;       // by tet_material
    std::span<const std::uint16_t> tet_material;  // T
    std::span<const Vec3> painted;                // places of the painted vertices
};

// By which measure tets are bad.
enum class Badness { flattest, widest, least_volume, least_radius, least_step, stiffest };

class PlaceTeller {
public:
    PlaceTeller(const TetMesh& mesh, const Surface& surface, const PlaceNames& names)
        : mesh_(mesh), surface_(surface), names_(names) {}

    // The worst tets, worst first, at most max_places; those with `skipped` as their limit are left out.
    struct Worst {
        std::vector<Place> places;
        ShellLimit limit = ShellLimit::none;  // of the first one
        bool is_flat = false;                 // the first one has an angle below 10 degrees
    };
    [[nodiscard]] Worst worst(Badness badness, ShellLimit skipped = ShellLimit::none) const;

    // Tets below 10 degrees for that reason.
    [[nodiscard]] std::uint64_t count(ShellLimit limit) const;

    [[nodiscard]] Place at_tet(Index tet, const std::string& figure) const;
    [[nodiscard]] Place at_node(Index node) const;
    // A place of its own, told by the tet nearest to it.
    [[nodiscard]] Place at(Vec3 position, const std::string& figure) const;
    // Told by the tet it hangs on.
    [[nodiscard]] Place at_vertex(const HungVertex& vertex) const;

    // The middles of the surface's holes, widest first, at most max_places.
    [[nodiscard]] std::vector<Place> holes() const;

private:
    [[nodiscard]] std::string tell(Vec3 position, Index tet, const std::string& figure) const;

    const TetMesh& mesh_;
    Surface surface_;
    const PlaceNames& names_;
};

}
