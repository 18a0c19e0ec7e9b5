// SPDX-License-Identifier: GPL-3.0-or-later
// A bundle and what a scene puts around it, stepped as a game would: obstacles, handles, the rigid body it rides on.
#pragma once
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "bundle/bundle.h"
#include "core/context.h"
#include "solver/instance.h"
#include "solver/sensor.h"
#include "study/place.h"
#include "study/rigid_body.h"
#include "study/scene.h"

namespace crumple::study {

// Memory on the boundary the solver wants.
class Block {
public:
    explicit Block(std::size_t size)
        : memory_(static_cast<std::byte*>(::operator new[](size, std::align_val_t{64}))), size_(size) {}
    [[nodiscard]] std::span<std::byte> get() const { return {memory_.get(), size_}; }

private:
    struct Free {
        void operator()(std::byte* p) const { ::operator delete[](p, std::align_val_t{64}); }
    };
    std::unique_ptr<std::byte[], Free> memory_;
    std::size_t size_;
};

class Player {
public:
    // Keeps references to all three. Throws Error(bad_input) for a bundle that cannot be stepped, Error(usage) for a
    // handle without nodes.
    Player(const Bundle& bundle, const Scene& scene, const Context& context);
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    void step(double time_s, float dt);

    // Advances what the sensor remembers, `since_s` after it was read last.
    [[nodiscard]] solver::SensorReading read_sensor(std::size_t sensor, float since_s);

    // Moves the visual mesh's vertices with the body, in the frame that motion() places.
    [[nodiscard]] std::vector<Vec3f> skinned(const BundleVisual& visual);

    // Of the frame the nodes are given in: the rigid body's, or the world.
    [[nodiscard]] solver::CarrierMotion motion() const;

    [[nodiscard]] const Bundle& bundle() const { return bundle_; }
    [[nodiscard]] const solver::Model& model() const { return model_; }
    [[nodiscard]] const solver::State& state() const { return state_; }
    [[nodiscard]] const std::vector<std::unique_ptr<PlacedHandle>>& handles() const { return handles_; }
    [[nodiscard]] const solver::InstanceReport& report() const { return report_; }  // of the last step
    [[nodiscard]] bool has_locks() const { return has_locks_; }
    [[nodiscard]] bool rides() const { return rides_; }  // on a rigid body that the load moves

private:
    void start_moving();
    void place_handles();
    [[nodiscard]] std::size_t drive_handles(double time_s, float dt);

    const Bundle& bundle_;
    const Scene& scene_;
    const Context& context_;
    solver::Settings settings_;
    solver::BundleView view_;
    Block model_memory_;
    solver::Model model_;
    Block state_memory_;
    Block workspace_memory_;
    solver::State state_;
    solver::Workspace workspace_;
    RigidBody carrier_;
    std::vector<solver::Constraint> room_;   // where the solver puts the constraints of a step
    std::vector<solver::Constraint> given_;  // those of the handles
    std::vector<solver::SensorMemory> sensor_memories_;
    std::vector<solver::Obstacle> obstacles_;
    std::vector<std::unique_ptr<PlacedHandle>> handles_;
    solver::InstanceReport report_;
    bool has_locks_ = false;
    bool rides_ = false;
};

}
