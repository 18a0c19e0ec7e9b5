// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/move_nodes.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/parallel_for.h"

namespace crumple::relax {

namespace {

// What part of the way to its target a node tries to go.
constexpr std::array<double, 4> steps = {1, 0.5, 0.25, 0.125};

struct Move {
    Vec3 to;
    bool is_held = false;
};

// The longest step that ends in the node's own material, off the shell.
Move move_towards(Vec3 target, Vec3 from, Index material, const ShellInterior& interior) {
    if (!is_finite(target)) return {from, true};
    for (const double step : steps) {
        const Vec3 place = round_to_float(from + (target - from) * step);
        if (place == from) return {from, step < 1};
        if (interior.material_at(place) == material && !interior.is_on_surface(place)) return {place, step < 1};
    }
    return {from, true};
}

double mean_edge(const Star& star) {
    double sum = 0;
    for (const Index t : star.tets) {
        for (const Index node : star.mesh.tets[t])
            sum += length(star.mesh.positions[node] - star.mesh.positions[star.node]);
    }
    return sum / (3 * static_cast<double>(star.tets.size()));
}

// Which nodes of the mesh would share a place, were the interior ones at these.
std::vector<Index> colliding_nodes(const TetMesh& mesh, const std::vector<Vec3>& places) {
    const auto place_of = [&](Index node) {
        return node < mesh.shell_vertex_count ? mesh.positions[node] : places[node - mesh.shell_vertex_count];
    };
    std::vector<Index> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        const Vec3 at_a = place_of(a);
        const Vec3 at_b = place_of(b);
        return at_a != at_b ? lexicographic_less(at_a, at_b) : a < b;
    });
    std::vector<Index> colliding;
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (place_of(order[i - 1]) != place_of(order[i])) continue;
        colliding.push_back(order[i - 1]);
        colliding.push_back(order[i]);
    }
    return colliding;
}

// All nodes that would meet stay where they are. That may be where another was about to go, so it takes rounds; each
// sends nodes back for good, so they end.
void undo_collisions(const TetMesh& mesh, Moves& moves) {
    for (bool is_settled = false; !is_settled;) {
        is_settled = true;
        for (const Index node : colliding_nodes(mesh, moves.places)) {
            if (node < mesh.shell_vertex_count) continue;
            Vec3& place = moves.places[node - mesh.shell_vertex_count];
            if (place == mesh.positions[node]) continue;
            place = mesh.positions[node];
            ++moves.held;
            is_settled = false;
        }
    }
}

}

Moves choose_moves(const TetMesh& mesh, const Stars& stars, std::span<const Index> materials, TargetFunction target,
                   const ShellInterior& interior, const Context& context) {
    const Index first = mesh.shell_vertex_count;
    Moves moves{{mesh.positions.begin() + first, mesh.positions.end()}, 0, 0};
    std::vector<std::uint8_t> held(moves.places.size());
    std::vector<double> mean_edges(moves.places.size(), 1);
    parallel_for(context, moves.places.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) {
            const Star star{mesh, first + static_cast<Index>(n), stars.of(n), stars.is_whole[n] != 0};
            if (star.tets.empty() || materials[n] == none) continue;
            mean_edges[n] = mean_edge(star);
            const Move move = move_towards(target(star), mesh.positions[star.node], materials[n], interior);
            moves.places[n] = move.to;
            held[n] = move.is_held;
        }
    });
    moves.held = static_cast<std::uint32_t>(std::count(held.begin(), held.end(), std::uint8_t{1}));
    undo_collisions(mesh, moves);
    for (std::size_t n = 0; n < moves.places.size(); ++n) {
        moves.max_move = std::max(moves.max_move, length(moves.places[n] - mesh.positions[first + n]) / mean_edges[n]);
    }
    return moves;
}

}
