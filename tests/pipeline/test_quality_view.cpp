// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/quality_view.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/small_work.h"
#include "pipeline/work_file.h"
#include "quality/quality.h"
#include "store/check_file.h"

using namespace crumple;
using namespace crumple::pipeline;

namespace {

template <class T>
const std::vector<T>& field(const std::vector<store::ViewField>& fields, const std::string& name) {
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.name == name; });
    if (found == fields.end()) throw std::runtime_error("no field " + name);
    return std::get<std::vector<T>>(found->values);
}

}

TEST(QualityView, OfNothingIsNothing) {
    const store::ViewFields fields = quality_view({});
    EXPECT_TRUE(fields.cells.empty() && fields.points.empty() && fields.loose.empty());
}

TEST(QualityView, TellsEveryTetOfTheBundleInItsOrder) {
    const Workspace work = small_work::cooked();
    const store::ViewFields fields = quality_view(work);
    const auto& angles = field<float>(fields.cells, "min_dihedral_deg");
    ASSERT_EQ(angles.size(), work.bundle->tets.size());
    std::vector<Vec3> positions;
    for (const Vec3f p : work.bundle->rest_positions) positions.push_back({p.x, p.y, p.z});
    for (std::size_t t = 0; t < angles.size(); ++t) {
        const auto& [a, b, c, d] = work.bundle->tets[t];
        EXPECT_FLOAT_EQ(angles[t], static_cast<float>(quality::degrees_of(quality::min_dihedral_key(
                                       positions[a], positions[b], positions[c], positions[d]))));
    }
    const quality::Summary summary = quality::summarize(positions, work.bundle->tets);
    EXPECT_FLOAT_EQ(*std::min_element(angles.begin(), angles.end()), static_cast<float>(summary.min_dihedral_deg));
    const auto& steps = field<float>(fields.cells, "element_step_ratio");
    EXPECT_FLOAT_EQ(*std::min_element(steps.begin(), steps.end()), static_cast<float>(summary.element_step_ratio));
    EXPECT_EQ(field<Index>(fields.points, "component"), std::vector<Index>(positions.size(), 0));
}

TEST(QualityView, ANodeIsAsGoodAsItsWorstTet) {
    const Workspace work = small_work::cooked();
    const store::ViewFields fields = quality_view(work);
    for (const char* name : {"min_dihedral_deg", "element_step_ratio"}) {
        const auto& of_nodes = field<float>(fields.points, name);
        const auto& of_tets = field<float>(fields.cells, name);
        ASSERT_EQ(of_nodes.size(), work.bundle->rest_positions.size());
        for (Index v = 0; v < of_nodes.size(); ++v) {
            float worst = 1e9f;
            for (std::size_t t = 0; t < of_tets.size(); ++t) {
                const Tet& tet = work.bundle->tets[t];
                if (std::find(tet.begin(), tet.end(), v) != tet.end()) worst = std::min(worst, of_tets[t]);
            }
            EXPECT_EQ(of_nodes[v], worst);
        }
    }
}

TEST(QualityView, TellsEveryVisualVertexAndWhatHangsOnATet) {
    Workspace work = small_work::imported();
    work.asset->visuals[0].positions.push_back({1.5, 0, 0});  // outside the ball
    for (const char* stage : {"sample", "delaunay", "relax", "cull", "bind", "bake"}) {
        (void)small_work::run(stage, work);
    }
    const store::ViewFields fields = quality_view(work);
    const auto& distance = field<float>(fields.loose, "body.distance");
    ASSERT_EQ(distance.size(), 4u);
    EXPECT_EQ(distance[0], 0);
    EXPECT_GT(distance[3], 0.4);
    EXPECT_GT(field<float>(fields.loose, "body.weight")[3], 1);
    EXPECT_EQ(field<Vec3f>(fields.loose, "body.position")[1], (Vec3f{0.25f, 0, 0}));
    const auto& hung = field<std::uint32_t>(fields.cells, "visual_vertices");
    const Index tet = work.bundle->visuals[0].tet[3];
    EXPECT_GE(hung[tet], 1u);
    EXPECT_EQ(field<float>(fields.cells, "visual_distance")[tet], distance[3]);
}

TEST(QualityView, IsInFilesWithWorkAndPassesTheirCheck) {
    const Workspace work = small_work::cooked();
    const auto has_fields = [](const std::vector<std::byte>& image) {
        return store::FileReader(image, "x").has("/VTKHDF/CellData/min_dihedral_deg");
    };
    const std::vector<std::byte> with = work_image(work, {});
    const std::vector<std::byte> without = work_image(work, {.has_work = false});
    EXPECT_TRUE(has_fields(with));
    EXPECT_FALSE(has_fields(without));
    EXPECT_TRUE(store::check_file(with, "x").findings.empty());
    Workspace tets = work;
    tets.bundle.reset();
    EXPECT_TRUE(has_fields(work_image(tets, {})));
}

TEST(QualityView, OfFlawedTetsIsLeftOut) {
    Workspace work = small_work::cooked();
    work.bundle.reset();
    work.tets->tets[0][2] = 1000000;
    EXPECT_TRUE(quality_view(work).cells.empty());
    work = small_work::cooked();
    work.bundle.reset();
    (*work.bindings)[0].tet[0] = 1000000;
    EXPECT_TRUE(quality_view(work).loose.empty());
}
