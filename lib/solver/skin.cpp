// SPDX-License-Identifier: MIT
#include "solver/skin.h"

#include <algorithm>
#include <cmath>

namespace crumple::solver {
namespace {

constexpr std::size_t vertices_per_piece = 4096;

}

VisualView view_of(const Bundle& bundle, const BundleVisual& visual) {
    return {bundle.tets, visual.tet, visual.barycentric};
}

const char* first_problem(const VisualView& v, std::size_t node_count) {
    if (v.tet.size() != v.barycentric.size()) return "visual: tet and barycentric differ in length";
    for (const Tet& tet : v.tets) {
        if (std::any_of(tet.begin(), tet.end(), [&](Index node) { return node >= node_count; })) {
            return "tets: a corner is not a node";
        }
    }
    if (std::any_of(v.tet.begin(), v.tet.end(), [&](Index tet) { return tet >= v.tets.size(); })) {
        return "visual: a vertex hangs on no tet";
    }
    for (const auto& weights : v.barycentric) {
        if (!std::all_of(weights.begin(), weights.end(), [](float w) { return std::isfinite(w); })) {
            return "barycentric: not finite";
        }
    }
    return nullptr;
}

VertexRange moved_vertices(const Model&, const State& state, const VisualView& visual, float tolerance) {
    const auto has_moved = [&](std::size_t vertex) {
        const Tet& tet = visual.tets[visual.tet[vertex]];
        return std::any_of(tet.begin(), tet.end(), [&](Index node) { return state.moved[node] > tolerance; });
    };
    VertexRange range{0, visual.tet.size()};
    while (range.first < range.last && !has_moved(range.first)) ++range.first;
    while (range.last > range.first && !has_moved(range.last - 1)) --range.last;
    return range.first < range.last ? range : VertexRange{};
}

void forget_moves(State& state) { std::fill(state.moved.begin(), state.moved.end(), 0.0f); }

void skin(const Model& model, const State& state, const VisualView& visual, const RestVertices& rest,
          const DrawnVertices& drawn, VertexRange range, const Settings& settings, const Jobs& jobs) noexcept {
    range.last = std::min(range.last, visual.tet.size());
    if (range.first >= range.last) return;
    const bool has_normals = !rest.normals.empty() && !drawn.normals.empty();
    const bool has_tangents = !rest.tangents.empty() && !drawn.tangents.empty();
    const SkinJob job{visual.tets.data(),
                      visual.tet.data(),
                      visual.barycentric.data(),
                      state.positions.data(),
                      state.tets.data(),
                      model.tet_count,
                      has_normals ? rest.normals.data() : nullptr,
                      has_tangents ? rest.tangents.data() : nullptr,
                      drawn.positions.data(),
                      has_normals ? drawn.normals.data() : nullptr,
                      has_tangents ? drawn.tangents.data() : nullptr};
    const Kernels& wide = kernels(best_isa(settings.isa));
    for_pieces(jobs, range.last - range.first, vertices_per_piece,
               [&](std::size_t, std::size_t b, std::size_t e) { wide.skin(job, range.first + b, range.first + e); });
}

}
