// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/simulate.h"

#include <gtest/gtest.h>

#include "report/json.h"
#include "solver/body.h"
#include "store/hdf5_file.h"
#include "study/gltf.h"
#include "study/load_scene.h"
#include "study/rigid_body.h"

namespace crumple::study {
namespace {

// Rear third locked, a drawn vertex in every tet, a sensor at the nose (largest z).
Bundle little_car(bool has_locks = true) {
    Material m = solver::test::elastic_material(2e7);
    m.density_kg_m3 = 180;
    m.yield_pa = 1e5;
    m.creep_per_s = 60;
    m.alpha_per_s = 0.15;
    m.beta_s = 0.002;
    const solver::test::Cells cells{4, 3, 9};
    Bundle b = solver::test::grid_body(cells, {0.4f, 0.4f, 0.4f}, m, [&](Vec3f p) { return has_locks && p.z < 1; });
    BundleVisual visual;
    visual.name = "paint";
    for (Index t = 0; t < b.tets.size(); ++t) {
        visual.tet.push_back(t);
        visual.barycentric.push_back({0.25f, 0.25f, 0.25f, 0.25f});
    }
    b.visuals = {visual};
    BundleSensor sensor;
    sensor.name = "nose";
    for (Index n = 0; n < b.rest_positions.size(); ++n) {
        if (b.rest_positions[n].z > 3.5f) sensor.node.push_back(n);
    }
    sensor.weight.assign(sensor.node.size(), 1.0f / static_cast<float>(sensor.node.size()));
    sensor.rest_axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (const Index n : sensor.node) sensor.rest_origin += b.rest_positions[n] * sensor.weight[0];
    b.sensors = {sensor};
    return b;
}

Scene quick(const std::string& name) {
    Scene scene = load_scene(name);
    scene.seconds = std::min(scene.seconds, 1.0);
    scene.frames_per_s = 10;
    return scene;
}

}

// Dents stay, locked nodes stay, nothing is inside out at the end.
TEST(Simulate, CrashesLeaveDentsAndKeepLocks) {
    const Bundle bundle = little_car();
    for (const std::string name : {"wall", "pole", "side_impact", "drop"}) {
        const study::Run run = simulate(bundle, quick(name));
        EXPECT_EQ(run.locked_drift, 0) << name;
        EXPECT_EQ(run.inverted_at_end, 0u) << name;
        EXPECT_GE(run.frames.size(), 10u) << name;
        if (name != "drop") {
            EXPECT_GT(run.deepest_dent_m, 0.01) << name;
            float most = 0;
            for (const float strain : run.frames.back().plastic_strain) most = std::max(most, strain);
            EXPECT_GT(most, 0.01) << name;
        }
    }
}

TEST(Simulate, ACrashTakesTheSpeedOutOfTheCar) {
    const Bundle bundle = little_car();
    Scene scene = quick("wall");
    scene.frames_per_s = 120;
    const study::Run run = simulate(bundle, scene);
    const auto rear = [&](std::size_t frame) { return run.frames[frame].nodes[0].z; };
    EXPECT_NEAR((rear(1) - rear(0)) / run.frames[1].time_s, 15, 0.1);
    const std::size_t last = run.frames.size() - 1;
    EXPECT_LT(std::abs(rear(last) - rear(last - 1)) / (run.frames[last].time_s - run.frames[last - 1].time_s), 5);
}

TEST(Simulate, HandlesGoWhereTheirKeysSay) {
    const Bundle bundle = little_car(false);
    Scene scene = load_scene("handles");
    scene.seconds = 1;
    const study::Run run = simulate(bundle, scene);
    EXPECT_EQ(run.inverted_at_end, 0u);
    const std::size_t nose = bundle.sensors[0].node[0];
    const Vec3f way = run.frames.back().nodes[nose] - bundle.rest_positions[nose];
    EXPECT_LT(length(way - Vec3f{-0.1f, 0.1f, -0.1f}), 1e-3f);
}

// A handle may go where the body cannot follow; who pulls it is told.
TEST(Simulate, HandlesThatCrossLockedNodesAreSaid) {
    const Bundle bundle = little_car();
    Scene scene;
    scene.seconds = 0.5;
    scene.gravity = {};
    scene.carrier = Carrier::fixed;
    SceneHandle handle;
    handle.box_low = {-1, -1, -0.4};  // all that is not locked
    handle.times_s = {0, 0.5};
    handle.shift_m = {{0, 0, 0}, {0, 0, -1}};
    scene.handles = {handle};
    const study::Run crossed = simulate(bundle, scene);
    EXPECT_GT(crossed.driven_inside_out, 0u);
    EXPECT_EQ(crossed.driven_inside_out, crossed.inverted_at_end);
    EXPECT_EQ(crossed.findings.back().code, "RUN_HANDLES_CROSS");
    scene.handles[0].shift_m[1] = {0, 0, -0.2};
    const study::Run near = simulate(bundle, scene);
    EXPECT_EQ(near.inverted_at_end, 0u);
    EXPECT_EQ(near.driven_inside_out, 0u);
}

TEST(Simulate, ABodyWithoutLocksFliesByItself) {
    const Bundle bundle = little_car(false);
    Scene scene;
    scene.seconds = 0.5;
    scene.velocity = {1, 2, 3};
    const study::Run run = simulate(bundle, scene);
    const Vec3f way = run.frames.back().nodes[5] - bundle.rest_positions[5];
    // The material's alpha is air to it.
    EXPECT_NEAR(way.x, 0.5, 0.03);
    EXPECT_NEAR(way.y, 1 - 0.5 * 9.81 * 0.25, 0.06);
    EXPECT_LT(run.deepest_dent_m, 1e-3);  // to move is no dent
}

TEST(Simulate, MoreThreadsMakeTheSameRun) {
    const Bundle bundle = little_car();
    Scene scene = quick("pole");
    scene.seconds = 0.3;
    Context two;
    two.jobs = 2;
    const study::Run alone = simulate(bundle, scene);
    EXPECT_EQ(run_image(bundle, scene, alone), run_image(bundle, scene, simulate(bundle, scene, two)));
}

// A scene made in code may ask for more than one that is read.
TEST(Simulate, ARunThatLeavesTheFiniteIsRefused) {
    const Bundle bundle = little_car();
    Scene scene = load_scene("wall");
    scene.seconds = 0.1;
    scene.angular_velocity_deg = {any_turning.max, 0, 0};
    for (const double speed : {0.0, any_speed.max, 1e7, 1e17, 1e30}) {
        scene.velocity = {0, 0, speed};
        try {
            for (const Frame& frame : simulate(bundle, scene).frames) {
                for (const Vec3f p : frame.nodes) ASSERT_LT(length(p), 1e18f);
            }
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::bad_input);
            EXPECT_NE(std::string(error.what()).find("steps_per_s"), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW((void)simulate(bundle, scene), Error);
}

TEST(Simulate, AHandleWithoutNodesAndABadBundleAreRefused) {
    Scene scene = load_scene("twist");
    scene.handles[0].box_low = {5, 5, 5};
    scene.handles[0].box_high = {6, 6, 6};
    EXPECT_THROW((void)simulate(little_car(), scene), Error);
    EXPECT_THROW((void)simulate(Bundle{}, Scene{}), Error);
}

TEST(RigidBody, TurnsAboutItsCentreOfMassAndKeepsItsSpin) {
    RigidBody body(little_car(), {0, 0, 0}, {0, 1, 0});
    const Vec3 centre{0.8, 0.6, 1.8};
    for (int i = 0; i < 100; ++i) body.step({}, {}, 0.01);
    const solver::CarrierMotion motion = body.motion();
    EXPECT_LT(length(solver::Frame(motion).point_to_world({0.8f, 0.6f, 1.8f}) - centre), 1e-4);
    EXPECT_NEAR(length(motion.angular_velocity), 1, 0.01);
}

TEST(RunFile, HoldsEveryFrameAndOpensAsAGrid) {
    const Bundle bundle = little_car();
    Scene scene = quick("pole");
    scene.seconds = 0.2;
    const study::Run run = simulate(bundle, scene);
    const store::FileReader file(run_image(bundle, scene, run), "run.hdf");
    const std::size_t frames = run.frames.size();
    EXPECT_EQ(file.read<double>("/run/time_s").size(), frames);
    EXPECT_EQ(file.read<Vec3f>("/run/nodes").size(), frames * bundle.rest_positions.size());
    EXPECT_EQ(file.read<Vec3f>("/run/visual/paint").size(), frames * bundle.tets.size());
    EXPECT_EQ(file.read<float>("/run/sensor/nose/plastic_strain").size(), frames);
    EXPECT_EQ(file.read<Vec3f>("/VTKHDF/Points"), run.frames.back().nodes);
    const store::FileReader visual(visual_image(run.frames[1], 0, {{0, 1, 2}}), "v.hdf");
    EXPECT_EQ(visual.read<std::uint8_t>("/VTKHDF/Types"), std::vector<std::uint8_t>{5});
    const report::Json index = report::parse_json(series_index({{"a.hdf", 0}, {"b.hdf", 0.5}}), "index");
    EXPECT_NE(index.find("files"), nullptr);
}

TEST(Gltf, HasATargetAFrameAndWholeBuffers) {
    const Bundle bundle = little_car();
    Scene scene = quick("wall");
    scene.seconds = 0.3;
    const study::Run run = simulate(bundle, scene);
    for (const bool has_triangles : {false, true}) {
        VisualTriangles triangles(1);
        if (has_triangles) triangles[0] = {{0, 1, 2}, {1, 2, 3}};
        const std::string glb = run_glb(bundle, run, triangles);
        const auto u32 = [&](std::size_t at) {
            std::uint32_t value = 0;
            std::copy_n(glb.data() + at, 4, reinterpret_cast<char*>(&value));
            return value;
        };
        ASSERT_EQ(glb.substr(0, 4), "glTF");
        EXPECT_EQ(u32(8), glb.size());
        const report::Json json = report::parse_json(glb.substr(20, u32(12)), "glb");
        const auto& meshes = *json.find("meshes")->get_if<report::Json::List>();
        ASSERT_EQ(meshes.size(), 1u);
        EXPECT_EQ(meshes[0].find("weights")->get_if<report::Json::List>()->size(), run.frames.size() - 1);
        EXPECT_EQ(u32(20 + u32(12)), glb.size() - 28 - u32(12));
        for (const report::Json& view : *json.find("bufferViews")->get_if<report::Json::List>()) {
            EXPECT_LE(view.find("byteOffset")->number() + view.find("byteLength")->number(), u32(20 + u32(12)));
        }
    }
}

}
