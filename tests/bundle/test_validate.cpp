// SPDX-License-Identifier: MIT
#include "bundle/validate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "bundle/small_bundle.h"
#include "core/random.h"

using namespace crumple;
using test::small_bundle;

namespace {

std::vector<std::string> codes_of(const Bundle& bundle) {
    std::vector<std::string> codes;
    for (const Finding& finding : validate(bundle)) {
        EXPECT_EQ(finding.severity, Severity::error);
        EXPECT_GE(finding.count, 1u);
        EXPECT_LE(finding.places.size(), max_places);
        codes.push_back(finding.code);
    }
    return codes;
}

struct Damage {
    const char* what;
    const char* code;  // that must be among the complaints
    std::function<void(Bundle&)> apply;
};

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

const std::vector<Damage>& damages() {
    static const std::vector<Damage> all = {
        {"everything gone", "BUNDLE_EMPTY", [](Bundle& b) { b = Bundle{}; }},
        {"mass one short", "BUNDLE_SIZE", [](Bundle& b) { b.mass.pop_back(); }},
        {"locked one long", "BUNDLE_SIZE", [](Bundle& b) { b.locked.push_back(0); }},
        {"no row starts", "BUNDLE_SIZE", [](Bundle& b) { b.row_start.clear(); }},
        {"no edge starts", "BUNDLE_SIZE", [](Bundle& b) { b.edge_start.clear(); }},
        {"more solver tets than tets", "BUNDLE_SIZE", [](Bundle& b) { b.solver_tet_count = none; }},
        {"slots of one tet missing", "BUNDLE_SIZE", [](Bundle& b) { b.element_slots.pop_back(); }},
        {"visual weights missing", "BUNDLE_SIZE", [](Bundle& b) { b.visuals[0].barycentric.pop_back(); }},
        {"visual starts missing", "BUNDLE_SIZE", [](Bundle& b) { b.visuals[0].tet_start.pop_back(); }},
        {"sensor weight missing", "BUNDLE_SIZE", [](Bundle& b) { b.sensors[0].weight.pop_back(); }},
        {"sensor without nodes", "BUNDLE_SENSOR",
         [](Bundle& b) { b.sensors[0].node.clear(), b.sensors[0].weight.clear(); }},
        {"tet of a node that is not there", "BUNDLE_INDEX", [](Bundle& b) { b.tets[3][2] = 12; }},
        {"column past the end", "BUNDLE_INDEX", [](Bundle& b) { b.column[5] = none; }},
        {"row start past the end", "BUNDLE_INDEX", [](Bundle& b) { b.row_start[3] = 1u << 30; }},
        {"first row start not 0", "BUNDLE_INDEX", [](Bundle& b) { b.row_start[0] = 1; }},
        {"slot past the end", "BUNDLE_INDEX", [](Bundle& b) { b.element_slots[0][7] = none; }},
        {"edge corner 4", "BUNDLE_INDEX", [](Bundle& b) { b.edge_corners[0][0] = 4; }},
        {"edge tet among the locked", "BUNDLE_INDEX", [](Bundle& b) { b.edge_tet[0] = b.solver_tet_count; }},
        {"material that is not there", "BUNDLE_INDEX", [](Bundle& b) { b.material[0] = 1; }},
        {"region that is not there", "BUNDLE_INDEX", [](Bundle& b) { b.region[0] = none; }},
        {"bound to a tet that is not there", "BUNDLE_INDEX", [](Bundle& b) { b.visuals[0].tet[0] = 10; }},
        {"visual start past the end", "BUNDLE_INDEX", [](Bundle& b) { b.visuals[0].tet_start[1] = 1000; }},
        {"sensor node that is not there", "BUNDLE_INDEX", [](Bundle& b) { b.sensors[0].node.back() = 12; }},
        {"NaN position", "BUNDLE_NUMBER", [](Bundle& b) { b.rest_positions[0].y = nan; }},
        {"infinite mass", "BUNDLE_NUMBER", [](Bundle& b) { b.mass[0] = std::numeric_limits<float>::infinity(); }},
        {"NaN weight", "BUNDLE_NUMBER", [](Bundle& b) { b.visuals[0].barycentric[0][2] = nan; }},
        {"lock flag of 2", "BUNDLE_NUMBER", [](Bundle& b) { b.locked[0] = 2; }},
        {"negative stiffness of a material", "BUNDLE_MATERIAL", [](Bundle& b) { b.materials[0].young_pa = -1; }},
        {"two materials of one name", "BUNDLE_NAME", [](Bundle& b) { b.materials.push_back(b.materials[0]); }},
        {"region without name", "BUNDLE_NAME", [](Bundle& b) { b.regions[0].clear(); }},
        {"sensor without name", "BUNDLE_NAME", [](Bundle& b) { b.sensors[0].name.clear(); }},
        {"stage twice", "BUNDLE_NAME",
         [](Bundle& b) { b.provenance.stage_versions.push_back(b.provenance.stage_versions[0]); }},
        {"digest cut short", "BUNDLE_PROVENANCE", [](Bundle& b) { b.provenance.input_digests[0].value.pop_back(); }},
        {"digest in capitals", "BUNDLE_PROVENANCE", [](Bundle& b) { b.provenance.input_digests[0].value[3] = 'F'; }},
        {"node order not inverse", "BUNDLE_NODE_ORDER",
         [](Bundle& b) { std::swap(b.node_to_mesh[0], b.node_to_mesh[1]); }},
        {"a dropped node claims a place", "BUNDLE_NODE_ORDER", [](Bundle& b) { b.mesh_to_node[0] = 3; }},
        {"lock flag lost", "BUNDLE_LOCK_MISSING", [](Bundle& b) { b.locked[0] = 0; }},
        {"lock flag gained", "BUNDLE_LOCK_UNLISTED", [](Bundle& b) { b.locked[10] = 1; }},
        {"painted position an ulp off", "BUNDLE_LOCK_MISSING",
         [](Bundle& b) { b.locked_positions.back().z = std::nextafter(1.0f, 2.0f); }},
        {"painted positions unsorted", "BUNDLE_LOCK_ORDER",
         [](Bundle& b) { std::swap(b.locked_positions[0], b.locked_positions[1]); }},
        {"painted position twice", "BUNDLE_LOCK_ORDER",
         [](Bundle& b) { b.locked_positions.insert(b.locked_positions.begin(), b.locked_positions[0]); }},
        {"tet inside out", "BUNDLE_TET_NOT_POSITIVE", [](Bundle& b) { std::swap(b.tets[0][0], b.tets[0][1]); }},
        {"volume off by 1e-5", "BUNDLE_VOLUME", [](Bundle& b) { b.volume[0] *= 1.00001f; }},
        {"inverse rest off by 1e-4", "BUNDLE_INVERSE_REST", [](Bundle& b) { b.inverse_rest[0][0] += 1e-4f; }},
        {"stiffness scale of 0", "BUNDLE_STIFFNESS", [](Bundle& b) { b.stiffness_scale[2] = 0; }},
        {"one solver tet too few", "BUNDLE_TET_ORDER",
         [](Bundle& b) { b.locked = std::vector<std::uint8_t>(b.locked.size(), 1); }},
        {"a tet twice", "BUNDLE_FACE", [](Bundle& b) { b.tets[1] = b.tets[0]; }},
        {"mass off by 1e-5", "BUNDLE_MASS", [](Bundle& b) { b.mass[3] *= 1.00001f; }},
        {"mass of 0 at a used node", "BUNDLE_MASS", [](Bundle& b) { b.mass[3] = 0; }},
        {"columns of a row swapped", "BUNDLE_MATRIX",
         [](Bundle& b) { std::swap(b.column[b.row_start[8]], b.column[b.row_start[8] + 1]); }},
        {"diagonal beside itself", "BUNDLE_MATRIX", [](Bundle& b) { b.diagonal[8] ^= 1; }},
        {"two slots swapped", "BUNDLE_SLOTS",
         [](Bundle& b) { std::swap(b.element_slots[0][1], b.element_slots[0][4]); }},
        {"edge missing", "BUNDLE_EDGES",
         [](Bundle& b) { b.edges.pop_back(), b.edge_slots.pop_back(), b.edge_start.erase(b.edge_start.end() - 2); }},
        {"edge slots swapped", "BUNDLE_EDGES", [](Bundle& b) { std::swap(b.edge_slots[0][0], b.edge_slots[0][1]); }},
        {"edge corners swapped", "BUNDLE_EDGES",
         [](Bundle& b) { std::swap(b.edge_corners[0][0], b.edge_corners[0][1]); }},
        {"edge of another tet", "BUNDLE_EDGES", [](Bundle& b) { b.edge_tet[0] ^= 1; }},
        {"weights sum to 1.001", "BUNDLE_BINDING", [](Bundle& b) { b.visuals[0].barycentric[0][0] += 1e-3f; }},
        {"inside with a negative weight", "BUNDLE_BINDING",
         [](Bundle& b) {
             b.visuals[0].barycentric[0] = {1.1f, -0.1f, 0, 0};
         }},
        {"outside with positive weights", "BUNDLE_BINDING", [](Bundle& b) { b.visuals[0].inside[0] = 0; }},
        {"inside at a distance", "BUNDLE_BINDING", [](Bundle& b) { b.visuals[0].distance[0] = 1; }},
        {"negative distance", "BUNDLE_BINDING", [](Bundle& b) { b.visuals[0].distance.back() = -1; }},
        {"inverse table disagrees", "BUNDLE_BINDING",
         [](Bundle& b) { std::swap(b.visuals[0].vertices_by_tet[0], b.visuals[0].vertices_by_tet[3]); }},
        {"visual without name", "BUNDLE_NAME", [](Bundle& b) { b.visuals[0].name.clear(); }},
        {"two sensors of one name", "BUNDLE_NAME", [](Bundle& b) { b.sensors.push_back(b.sensors[0]); }},
        {"sensor weights sum to 2", "BUNDLE_SENSOR",
         [](Bundle& b) {
             for (float& w : b.sensors[0].weight) w *= 2;
         }},
        {"sensor nodes unsorted", "BUNDLE_SENSOR",
         [](Bundle& b) { std::swap(b.sensors[0].node[0], b.sensors[0].node[1]); }},
        {"sensor origin off", "BUNDLE_SENSOR", [](Bundle& b) { b.sensors[0].rest_origin.x += 0.01f; }},
        {"sensor axes mirrored", "BUNDLE_SENSOR", [](Bundle& b) { b.sensors[0].rest_axes[0] = -1; }},
    };
    return all;
}

}

TEST(Validate, EmptyBundleIsNotOne) { EXPECT_EQ(codes_of(Bundle{})[0], "BUNDLE_EMPTY"); }

TEST(Validate, SmallBundlesPass) {
    EXPECT_TRUE(codes_of(small_bundle(2)).empty());
    EXPECT_TRUE(codes_of(small_bundle(7)).empty());
}

TEST(Validate, NamesEveryKindOfDamage) {
    for (const Damage& damage : damages()) {
        Bundle bundle = small_bundle();
        damage.apply(bundle);
        const std::vector<std::string> codes = codes_of(bundle);
        EXPECT_NE(std::find(codes.begin(), codes.end(), damage.code), codes.end())
            << damage.what << " should give " << damage.code << ", first is " << (codes.empty() ? "nothing" : codes[0]);
    }
}

TEST(Validate, AcceptsALockedNodeThatNoTetUses) {
    Bundle b = small_bundle();
    b.rest_positions.push_back({9, 9, 9});
    b.locked.push_back(1);
    b.mass.push_back(0);
    b.node_to_mesh.push_back(static_cast<Index>(b.mesh_to_node.size()));
    b.mesh_to_node.push_back(static_cast<Index>(b.rest_positions.size() - 1));
    test::fill_locked_positions(b);
    build_matrix_pattern(b);
    EXPECT_TRUE(codes_of(b).empty());
    b.locked.back() = 0;
    test::fill_locked_positions(b);
    EXPECT_EQ(codes_of(b), std::vector<std::string>{"BUNDLE_NODE_UNUSED"});
}

TEST(Validate, AcceptsASliverOfOneUlpWhoseWeightsAreNoise) {
    Bundle b;
    b.rest_positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5f, 0.25f, std::nextafter(0.25f, 1.0f)}};
    b.tets = {{0, 1, 2, 3}};
    b.solver_tet_count = 1;
    b.locked = {0, 0, 0, 0};
    b.node_to_mesh = b.mesh_to_node = {0, 1, 2, 3};
    b.stiffness_scale = {1};
    b.material = {0};
    b.region = {0};
    b.materials = {Material{}};
    b.regions = {"sliver"};
    test::fill_rest_state(b);
    build_matrix_pattern(b);
    EXPECT_TRUE(codes_of(b).empty());
}

// Whatever stands in the arrays: no crash (sanitizers watch), and never a clean bill for an index that is out of range.
TEST(Validate, SurvivesRandomWordsInAnyArray) {
    const Bundle good = small_bundle();
    Rng rng(2024);
    for (int trial = 0; trial < 3000; ++trial) {
        Bundle b = good;
        const std::vector<std::vector<Index>*> lists = {&b.row_start,
                                                        &b.column,
                                                        &b.diagonal,
                                                        &b.edge_start,
                                                        &b.edge_tet,
                                                        &b.node_to_mesh,
                                                        &b.mesh_to_node,
                                                        &b.visuals[0].tet,
                                                        &b.visuals[0].tet_start,
                                                        &b.visuals[0].vertices_by_tet,
                                                        &b.sensors[0].node,
                                                        &b.region};
        auto& list = *lists[rng.next_below(static_cast<std::uint32_t>(lists.size()))];
        const Index before = list[rng.next_below(static_cast<std::uint32_t>(list.size()))];
        const Index after = rng.next_below(4) == 0 ? rng.next_u32() : rng.next_below(64);
        auto& entry = *std::find(list.begin(), list.end(), before);
        entry = after;
        b.tets[rng.next_below(10)][rng.next_below(4)] = rng.next_below(14);
        b.element_slots[rng.next_below(5)][rng.next_below(16)] = rng.next_below(200);
        (void)validate(b);
    }
}
