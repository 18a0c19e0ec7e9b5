// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/move_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/parallel_for.h"

namespace crumple::relax {

namespace {

// What part of the way to its target a node tries to go.
constexpr std::array<double, 4> steps = {1, 0.5, 0.25, 0.125};

struct Move {
    Spot to;
    bool is_held = false;
};

bool is_finite(Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// The longest step that ends in the node's own material, off the shell.
Move move_towards(Vec3 target, const Spot& from, const MaterialSpace& space) {
    if (!is_finite(target)) return {from, true};
    for (const double step : steps) {
        const Vec3 place = round_to_float(from.position + (target - from.position) * step);
        if (place == from.position) return {from, step < 1};
        const Spot to = space.look_at(place, from);
        if (to.material == from.material && to.clear > 0) return {to, step < 1};
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

// Which nodes of the mesh would share a place, were the interior ones at these spots.
std::vector<Index> colliding_nodes(const TetMesh& mesh, const std::vector<Spot>& spots) {
    const auto place_of = [&](Index node) {
        return node < mesh.shell_vertex_count ? mesh.positions[node] : spots[node - mesh.shell_vertex_count].position;
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
void undo_collisions(const TetMesh& mesh, const std::vector<Spot>& from, Moves& moves) {
    for (bool is_settled = false; !is_settled;) {
        is_settled = true;
        for (const Index node : colliding_nodes(mesh, moves.spots)) {
            if (node < mesh.shell_vertex_count) continue;
            const Index interior = node - mesh.shell_vertex_count;
            if (moves.spots[interior].position == from[interior].position) continue;
            moves.spots[interior] = from[interior];
            ++moves.held;
            is_settled = false;
        }
    }
}

}

Moves choose_moves(const TetMesh& mesh, const Stars& stars, const std::vector<Spot>& spots, TargetFunction target,
                   const MaterialSpace& space, const Context& context) {
    Moves moves{spots, 0, 0};
    std::vector<std::uint8_t> held(spots.size());
    std::vector<double> mean_edges(spots.size(), 1);
    parallel_for(context, spots.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) {
            const Star star{mesh, mesh.shell_vertex_count + static_cast<Index>(n), stars.of(n), stars.is_whole[n] != 0};
            if (star.tets.empty() || spots[n].material == none) continue;
            mean_edges[n] = mean_edge(star);
            const Move move = move_towards(target(star), spots[n], space);
            moves.spots[n] = move.to;
            held[n] = move.is_held;
        }
    });
    moves.held = static_cast<std::uint32_t>(std::count(held.begin(), held.end(), std::uint8_t{1}));
    undo_collisions(mesh, spots, moves);
    for (std::size_t n = 0; n < spots.size(); ++n) {
        moves.max_move = std::max(moves.max_move, length(moves.spots[n].position - spots[n].position) / mean_edges[n]);
    }
    return moves;
}

}
