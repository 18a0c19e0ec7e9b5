// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/bake_tets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "bundle/exact_volume.h"
#include "core/error.h"
#include "core/short_text.h"

namespace crumple::bake {
namespace {

using Corners = std::array<std::uint8_t, 4>;

// The even permutations of four corners that bring corner k to the front, up to turning the last three.
constexpr Corners to_front[4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};

// The one even permutation that puts the lowest node first and the lowest of the others second.
Corners canonical_corners(const Tet& tet) {
    Corners corners = to_front[std::min_element(tet.begin(), tet.end()) - tet.begin()];
    const auto by_node = [&](std::uint8_t a, std::uint8_t b) { return tet[a] < tet[b]; };
    std::rotate(corners.begin() + 1, std::min_element(corners.begin() + 1, corners.end(), by_node), corners.end());
    return corners;
}

struct PlacedTet {
    bool is_all_locked;
    Tet nodes;
    Index mesh_tet;
    Corners corners;

    friend bool operator<(const PlacedTet& a, const PlacedTet& b) {
        return std::tie(a.is_all_locked, a.nodes, a.mesh_tet) < std::tie(b.is_all_locked, b.nodes, b.mesh_tet);
    }
};

PlacedTet place_tet(const TetMesh& mesh, const Bundle& bundle, Index t) {
    Tet nodes;
    for (std::size_t k = 0; k < 4; ++k) nodes[k] = bundle.mesh_to_node[mesh.tets[t][k]];
    PlacedTet placed{true, {}, t, canonical_corners(nodes)};
    for (std::size_t k = 0; k < 4; ++k) {
        placed.nodes[k] = nodes[placed.corners[k]];
        placed.is_all_locked = placed.is_all_locked && bundle.locked[placed.nodes[k]];
    }
    return placed;
}

double frobenius(const std::array<double, 9>& m) {
    double sum = 0;
    for (const double x : m) sum += x * x;
    return std::sqrt(sum);
}

// |X Dm - I| / (|X| |Dm|) of the rounded X.
double inverse_error(const std::array<float, 9>& inverse, const Vec3f (&corner)[4]) {
    std::array<double, 9> dm{};
    std::array<double, 9> rest{};
    std::array<double, 9> wide{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t column = 0; column < 3; ++column) {
            dm[3 * axis + column] =
                double{corner[column + 1][static_cast<int>(axis)]} - corner[0][static_cast<int>(axis)];
        }
    }
    for (std::size_t i = 0; i < 9; ++i) {
        wide[i] = inverse[i];
        rest[i] = i % 4 == 0 ? -1 : 0;
        for (std::size_t k = 0; k < 3; ++k) rest[i] += double{inverse[i / 3 * 3 + k]} * dm[3 * k + i % 3];
    }
    return frobenius(rest) / (frobenius(wide) * frobenius(dm));
}

[[noreturn]] void refuse_size(Index mesh_tet, Vec3f place, const char* what) {
    throw Error(ErrorKind::bad_input, "bake: the " + std::string(what) + " of tet " + std::to_string(mesh_tet) +
                                          " near " + position_text({place.x, place.y, place.z}) +
                                          " does not fit into a float; check the unit of the shell");
}

float narrow_positive(double value, Index mesh_tet, Vec3f place, const char* what) {
    const auto narrow = static_cast<float>(value);
    if (!std::isnormal(narrow) || narrow < 0) refuse_size(mesh_tet, place, what);
    return narrow;
}

void name_regions(const Shell& shell, Bundle& bundle) {
    for (const Component& component : shell.components) bundle.regions.push_back(component.name);
    if (bundle.regions.empty()) bundle.regions.emplace_back("shell");
}

// Volume and inverse rest matrix of tet t; returns the volume before rounding.
double bake_shape(Index mesh_tet, std::size_t t, Bundle& bundle, Report& report) {
    const Tet& tet = bundle.tets[t];
    const Vec3f corner[4] = {bundle.rest_positions[tet[0]], bundle.rest_positions[tet[1]],
                             bundle.rest_positions[tet[2]], bundle.rest_positions[tet[3]]};
    const double volume = six_volumes(corner[0], corner[1], corner[2], corner[3]) / 6;
    const auto inverse = inverse_rest_matrix(corner[0], corner[1], corner[2], corner[3]);
    bundle.volume.push_back(narrow_positive(volume, mesh_tet, corner[0], "volume"));
    std::array<float, 9> narrow{};
    for (std::size_t i = 0; i < 9; ++i) {
        narrow[i] = static_cast<float>(inverse[i]) + 0.0f;
        if (!std::isfinite(narrow[i])) refuse_size(mesh_tet, corner[0], "inverse rest matrix");
    }
    bundle.inverse_rest.push_back(narrow);
    report.max_inverse_error = std::max(report.max_inverse_error, inverse_error(narrow, corner));
    return volume;
}

}

TetOrder bake_tets(const TetMesh& mesh, Bundle& bundle) {
    std::vector<PlacedTet> placed;
    placed.reserve(mesh.tets.size());
    for (Index t = 0; t < mesh.tets.size(); ++t) placed.push_back(place_tet(mesh, bundle, t));
    std::sort(placed.begin(), placed.end());
    TetOrder order;
    for (const PlacedTet& tet : placed) {
        bundle.tets.push_back(tet.nodes);
        bundle.solver_tet_count += tet.is_all_locked ? 0 : 1;
        order.mesh_tet.push_back(tet.mesh_tet);
        order.corners.push_back(tet.corners);
    }
    return order;
}

void bake_rest_state(const Shell& shell, const TetMesh& mesh, const TetOrder& order, const Params& params,
                     const std::vector<ComponentMaterial>& component_materials, Bundle& bundle, Report& report) {
    bundle.materials = params.materials;
    name_regions(shell, bundle);
    std::vector<double> mass(bundle.rest_positions.size(), 0.0);
    for (std::size_t t = 0; t < bundle.tets.size(); ++t) {
        const Index mesh_tet = order.mesh_tet[t];
        const Index region = mesh.region.empty() ? 0 : mesh.region[mesh_tet];
        const ComponentMaterial& made_of = component_materials[region];
        bundle.region.push_back(region);
        bundle.material.push_back(made_of.material);
        bundle.stiffness_scale.push_back(made_of.stiffness_scale);
        const double volume = bake_shape(mesh_tet, t, bundle, report);
        const double quarter = params.materials[made_of.material].density_kg_m3 * volume / 4;
        for (const Index node : bundle.tets[t]) mass[node] += quarter;
    }
    for (std::size_t node = 0; node < mass.size(); ++node) {
        bundle.mass.push_back(
            mass[node] == 0 ? 0.0f : narrow_positive(mass[node], none, bundle.rest_positions[node], "mass at a node"));
    }
}

}
