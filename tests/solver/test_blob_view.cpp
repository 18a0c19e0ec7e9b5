// SPDX-License-Identifier: MIT
#include "solver/blob_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <numeric>

#include "bundle/aligned_bytes.h"
#include "bundle/forged_blob.h"
#include "solver/body.h"

namespace crumple::solver::test {
namespace {

using crumple::test::AlignedBytes;

Bundle hung_grid() {
    const Material material = elastic_material();
    Bundle bundle = grid_body({3, 2, 2}, {0.5f, 0.5f, 0.5f}, material, [](Vec3f p) { return p.x == 0; });
    bundle.node_to_mesh.resize(bundle.rest_positions.size());  // a blob has one for every node
    std::iota(bundle.node_to_mesh.begin(), bundle.node_to_mesh.end(), 0u);
    bundle.mesh_to_node = bundle.node_to_mesh;
    return bundle;
}

AlignedBytes memory_for(std::size_t size) { return AlignedBytes(std::vector<std::byte>(size)); }

}

TEST(BlobView, StepsToTheSameBitsAsTheBundleWhenTheBlobIsGone) {
    const Bundle bundle = hung_grid();
    auto bytes = std::make_unique<AlignedBytes>(write_blob(bundle));
    Blob blob;
    ASSERT_EQ(open_blob(bytes->get(), blob), nullptr);
    std::vector<Material> materials(blob.materials.size());
    const BundleView view = view_of(blob, materials);
    ASSERT_EQ(first_problem(view), nullptr);

    const AlignedBytes model_memory = memory_for(model_bytes(view));
    const Model model = build_model(view, model_memory.get());
    std::memset(bytes->get().data(), 0xff, bytes->get().size());
    bytes.reset();
    std::fill(materials.begin(), materials.end(), Material{});
    const AlignedBytes state_memory = memory_for(state_bytes(model, Plasticity::additive));
    const AlignedBytes workspace_memory = memory_for(workspace_bytes(model));
    State state = make_state(model, Plasticity::additive, state_memory.get());
    Workspace workspace = make_workspace(model, workspace_memory.get());
    Body body(bundle);
    StepInput input;
    input.gravity = {0, -9.81f, 0};
    for (int i = 0; i < 10; ++i) {
        step(model, state, workspace, input);
        body.step(input);
    }
    ASSERT_EQ(state_memory.get().size(), body.bytes().size());
    EXPECT_EQ(std::memcmp(state_memory.get().data(), body.bytes().data(), body.bytes().size()), 0);
    EXPECT_LT(position(state, model.node_count - 1).y, bundle.rest_positions.back().y) << "it moved at all";
}

// Right checksums, wrong words in the arrays a step follows: first_problem says so, or the step stays inside
// (sanitizers watch).
TEST(BlobView, NeverReadsOutsideABlobThatLies) {
    const std::vector<std::byte> good = write_blob(hung_grid());
    Rng rng(7);
    int refused = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const AlignedBytes bytes(good);
        const std::uint32_t first_array = 64 + 32 * 32;
        const auto words = static_cast<std::uint32_t>((good.size() - first_array) / 4);
        for (int change = 0; change < 3; ++change) {
            const std::uint32_t value = rng.next_below(2) == 0 ? rng.next_below(60) : rng.next_u32();
            std::memcpy(bytes.get().data() + first_array + 4 * rng.next_below(words), &value, 4);
        }
        crumple::test::write_checksums(bytes.get());
        Blob blob;
        if (open_blob(bytes.get(), blob) != nullptr) continue;
        std::vector<Material> materials(blob.materials.size());
        const BundleView view = view_of(blob, materials);
        if (first_problem(view) != nullptr) {
            ++refused;
            continue;
        }
        const AlignedBytes model_memory = memory_for(model_bytes(view));
        const Model model = build_model(view, model_memory.get());
        const AlignedBytes state_memory = memory_for(state_bytes(model, Plasticity::additive));
        const AlignedBytes workspace_memory = memory_for(workspace_bytes(model));
        State state = make_state(model, Plasticity::additive, state_memory.get());
        Workspace workspace = make_workspace(model, workspace_memory.get());
        for (int i = 0; i < 2; ++i) step(model, state, workspace, {});
    }
    EXPECT_GT(refused, 50);
}

}
