// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/solver_car.h"

#include <filesystem>
#include <new>

#include "pipeline/builtin_recipes.h"
#include "pipeline/cook.h"
#include "samples/samples.h"
#include "store/bundle_file.h"

namespace crumple::bench {
namespace {

constexpr Vec3 speed{0, 0, 15};

// A pole of 30 cm a little off the middle, 20 cm before the nose.
solver::Obstacle pole() {
    solver::Obstacle pole;
    pole.shape = solver::ObstacleShape::capsule;
    pole.axis = {0, 5, 0};
    pole.radius = 0.15;
    pole.position = {0.2, 0, 2.6};
    return pole;
}

}

Block::Block(std::size_t size)
    : memory_(static_cast<std::byte*>(::operator new[](size, std::align_val_t{64}))), size_(size) {}

void Block::Free::operator()(std::byte* p) const { ::operator delete[](p, std::align_val_t{64}); }

Bundle cook_car(const std::vector<std::string>& settings) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "crumple_bench_car";
    std::filesystem::create_directories(folder);
    pipeline::CookRequest request;
    for (const std::string& path : samples::write("car", folder.string())) {
        if (path.find("shell.glb") != std::string::npos) request.sources.shell = path;
        if (path.find("visual.glb") != std::string::npos) request.sources.visuals.push_back({"", path});
    }
    request.output = (folder / "car.hdf").string();
    const pipeline::RecipeText text = pipeline::load_recipe_text(CRUMPLE_CAR_RECIPE);
    pipeline::Recipe recipe = pipeline::read_recipe(text.json, text.source);
    for (const std::string& setting : settings) pipeline::apply_setting(recipe, setting);
    pipeline::CookReport report;
    pipeline::cook(recipe, request, report);
    Bundle bundle = store::load_bundle(request.output);
    std::filesystem::remove_all(folder);
    return bundle;
}

CarModel::CarModel(Bundle made)
    : bundle(std::move(made)),
      memory(solver::model_bytes(solver::view_of(bundle))),
      model(solver::build_model(solver::view_of(bundle), memory.get())) {}

Garage::Garage(const CarModel& shared)
    : memory(solver::workspace_bytes(shared.model)),
      workspace(solver::make_workspace(shared.model, memory.get())),
      room(shared.model.node_count) {}

Car::Car(const CarModel& shared)
    : memory(solver::state_bytes(shared.model, solver::Plasticity::additive)),
      state(solver::make_state(shared.model, solver::Plasticity::additive, memory.get())),
      body(shared.bundle, speed, {}) {}

solver::InstanceReport Car::drive(const CarModel& shared, Garage& garage, float dt, const solver::Settings& settings) {
    const solver::Obstacle obstacle = pole();
    solver::InstanceInput input;
    input.dt = dt;
    input.carrier = body.motion();
    input.gravity = {};  // the wheels carry the weight
    input.obstacles = {&obstacle, 1};
    input.room = garage.room;
    input.may_sleep = false;  // what is measured is a car that moves
    const solver::InstanceReport report = step_instance(shared.model, state, garage.workspace, input, settings);
    body.step(report.load, {}, static_cast<double>(dt));
    return report;
}

}
