// SPDX-License-Identifier: GPL-3.0-or-later
// The sample car on its way into a pole at 15 m/s, any number of times, as a game would have it.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "bundle/bundle.h"
#include "solver/instance.h"
#include "study/rigid_body.h"

namespace crumple::bench {

// Cooked with the sample's own recipe from the sample's own files, but for the settings ("finish.mode=none").
[[nodiscard]] Bundle cook_car(const std::vector<std::string>& settings = {});

// Memory on the boundary the solver wants.
class Block {
public:
    explicit Block(std::size_t size);
    [[nodiscard]] std::span<std::byte> get() const { return {memory_.get(), size_}; }

private:
    struct Free {
        void operator()(std::byte* p) const;
    };
    std::unique_ptr<std::byte[], Free> memory_;
    std::size_t size_;
};

// What all cars share.
struct CarModel {
    explicit CarModel(Bundle bundle);
    Bundle bundle;
    Block memory;
    solver::Model model;
};

// What a thread needs for any car.
struct Garage {
    explicit Garage(const CarModel& shared);
    Block memory;
    solver::Workspace workspace;
    std::vector<solver::Constraint> room;
};

struct Car {
    explicit Car(const CarModel& shared);
    // One step: the car's body, and the deformation that rides on it.
    solver::InstanceReport drive(const CarModel& shared, Garage& garage, float dt = 1.0f / 60,
                                 const solver::Settings& settings = {});

    Block memory;
    solver::State state;
    study::RigidBody body;
};

}
