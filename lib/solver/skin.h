// SPDX-License-Identifier: MIT
// Drawn vertices from the nodes: positions by their weights in a tet, normals and tangents turned by the tet's rotation
// [Brinck 2016]. All in the carrier's frame.
#pragma once
#include "solver/step.h"

namespace crumple::solver {

// One visual mesh of a bundle (see bundle.h): V vertices bound to T tets, the ones that are not simulated included.
struct VisualView {
    std::span<const Tet> tets;                          // T
    std::span<const Index> tet;                         // V
    std::span<const std::array<float, 4>> barycentric;  // V
};
[[nodiscard]] VisualView view_of(const Bundle& bundle, const BundleVisual& visual);

// "barycentric: not finite": why skinning could read outside the view, or null.
[[nodiscard]] const char* first_problem(const VisualView& view, std::size_t node_count);

// V each; normals and tangents may be empty in rest and drawn alike. A tangent's fourth float is its handedness and is
// not touched.
struct RestVertices {
    std::span<const Vec3f> normals;
    std::span<const std::array<float, 4>> tangents;
};
struct DrawnVertices {
    std::span<Vec3f> positions;
    std::span<Vec3f> normals;
    std::span<std::array<float, 4>> tangents;
};

// [first, last) in the visual mesh.
struct VertexRange {
    std::size_t first = 0;
    std::size_t last = 0;
    friend bool operator==(const VertexRange&, const VertexRange&) = default;
};

// The smallest range of vertices that hang on a node which has travelled more than `tolerance` metres since
// forget_moves: what must be skinned and sent to the graphics processor.
[[nodiscard]] VertexRange moved_vertices(const Model& model, const State& state, const VisualView& visual,
                                         float tolerance);
void forget_moves(State& state);

// Fills the vertices of the range. REQUIRES: first_problem(visual) is null; drawn spans as long as the visual mesh.
void skin(const Model& model, const State& state, const VisualView& visual, const RestVertices& rest,
          const DrawnVertices& drawn, VertexRange range, const Settings& settings = {}, const Jobs& jobs = {}) noexcept;

}
