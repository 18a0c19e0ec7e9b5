// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/embedding.h"

#include <gtest/gtest.h>

#include "geometry/measures.h"
#include "mesh/neighbours.h"
#include "mesh/shapes.h"

using namespace crumple;
using namespace crumple::quality;

namespace {

// The grid [0,3]^3 whose middle [1,2]^3 belongs to the inner box.
struct Nest {
    Shell shell = shapes::nested_boxes(Role::rigid);
    TetMesh mesh = shapes::tet_grid(3, {0, 0, 0}, {3, 3, 3});

    Nest() {
        for (const Tet& tet : mesh.tets) {
            Vec3 centre;
            for (const Index v : tet) centre += mesh.positions[v] * 0.25;
            const bool is_inner =
                centre.x > 1 && centre.x < 2 && centre.y > 1 && centre.y < 2 && centre.z > 1 && centre.z < 2;
            mesh.region.push_back(is_inner ? 1 : 0);
        }
    }

    // Hangs p on the tet of that region that is nearest by weights.
    void bind(VisualMesh& visual, VisualBinding& binding, Vec3 p, Index region) const {
        double best = -1e9;
        Index chosen = none;
        std::array<double, 4> weights{};
        for (Index t = 0; t < mesh.tets.size(); ++t) {
            if (mesh.region[t] != region) continue;
            const auto& [a, b, c, d] = mesh.tets[t];
            const auto w = barycentric(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d], p);
            const double least = *std::min_element(w.begin(), w.end());
            if (least <= best) continue;
            best = least;
            chosen = t;
            weights = w;
        }
        visual.positions.push_back(p);
        binding.tet.push_back(chosen);
        binding.barycentric.push_back(weights);
        binding.inside.push_back(best >= -1e-12);
        binding.distance.push_back(best >= -1e-12 ? 0 : -best);  // of unit cubes: near enough
    }
};

Embedding embedding_of(const Nest& nest, const VisualMesh& visual, const VisualBinding& binding) {
    return measure_embedding(nest.shell, nest.mesh, std::vector{visual}, {binding}).total;
}

TEST(Embedding, WithoutVisualMeshesThereIsNone) {
    const Nest nest;
    const EmbeddingResult result = measure_embedding(nest.shell, nest.mesh, {}, {});
    EXPECT_EQ(result.total.vertices, 0u);
    EXPECT_TRUE(result.visuals.empty());
}

TEST(Embedding, VerticesInTheirOwnTetsAreNotWrong) {
    const Nest nest;
    VisualMesh visual;
    VisualBinding binding;
    nest.bind(visual, binding, {0.3, 0.4, 0.6}, 0);
    nest.bind(visual, binding, {1.3, 1.4, 1.6}, 1);
    nest.bind(visual, binding, {1, 1.5, 1.5}, 1);  // on the border: either will do for the one who asks by place
    const Embedding e = embedding_of(nest, visual, binding);
    EXPECT_EQ(e.vertices, 3u);
    EXPECT_EQ(e.outside, 0u);
    EXPECT_EQ(e.bound_wrongly, 0u);
    EXPECT_LE(e.max_weight, 1);
}

TEST(Embedding, AVertexInsideTheEngineHungOnTheBodyIsWrong) {
    const Nest nest;
    VisualMesh visual;
    visual.name = "engine";
    VisualBinding binding;
    nest.bind(visual, binding, {1.3, 1.4, 1.6}, 0);
    const EmbeddingResult result = measure_embedding(nest.shell, nest.mesh, std::vector{visual}, {binding});
    EXPECT_EQ(result.total.bound_wrongly, 1u);
    EXPECT_EQ(result.total.outside, 1u);
    ASSERT_EQ(result.wrong.size(), 1u);
    EXPECT_EQ(result.wrong[0].place.position, (Vec3{1.3, 1.4, 1.6}));
    EXPECT_EQ(result.wrong[0].place.name, "engine");
    EXPECT_EQ(result.wrong[0].tet, 0u);
    EXPECT_EQ(result.visuals[0].bound_wrongly, std::vector<std::uint8_t>{1});
}

TEST(Embedding, TheNamedComponentOwnsItsMeshEvenWhereAnotherContainsIt) {
    const Nest nest;
    VisualMesh visual;
    visual.shell_component = nest.shell.components[1].name;
    VisualBinding binding;
    nest.bind(visual, binding, {1, 1.5, 1.5}, 0);  // the border: a tet of the engine contains it as well
    EXPECT_EQ(embedding_of(nest, visual, binding).bound_wrongly, 1u);
    visual = {};
    binding = {};
    visual.shell_component = nest.shell.components[1].name;
    nest.bind(visual, binding, {0.5, 0.5, 0.5}, 0);  // far from the engine: no tet of it is as near
    EXPECT_EQ(embedding_of(nest, visual, binding).bound_wrongly, 0u);
}

TEST(Embedding, ExtrapolatedVerticesAreTold) {
    const Nest nest;
    VisualMesh visual;
    VisualBinding binding;
    nest.bind(visual, binding, {5, 1.5, 1.5}, 0);
    nest.bind(visual, binding, {3.2, 1.5, 1.5}, 0);
    nest.bind(visual, binding, {0.5, 0.5, 0.6}, 0);
    const EmbeddingResult result = measure_embedding(nest.shell, nest.mesh, std::vector{visual}, {binding});
    EXPECT_EQ(result.total.outside, 2u);
    EXPECT_GT(result.total.max_weight, 2);
    ASSERT_GE(result.heaviest.size(), 1u);
    EXPECT_EQ(result.heaviest[0].place.element, 0u) << "the heaviest comes first";
    EXPECT_GT(result.visuals[0].distance[0], 0);
    EXPECT_EQ(result.visuals[0].distance[2], 0);
}

}
