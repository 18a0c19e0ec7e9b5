// SPDX-License-Identifier: GPL-3.0-or-later
// A scene around a certain body: obstacles in the world, handles with their nodes.
#pragma once
#include "bundle/bundle.h"
#include "study/scene.h"

namespace crumple::study {

struct Box {
    Vec3 low;
    Vec3 high;
    [[nodiscard]] Vec3 middle() const { return (low + high) * 0.5; }
};
[[nodiscard]] Box box_of(const Bundle& bundle);

// Where the obstacle is at the start: see SceneObstacle::gap_m. `velocity` is the body's.
[[nodiscard]] solver::Obstacle place_obstacle(const SceneObstacle& obstacle, const Bundle& bundle, Vec3 velocity);

// A handle's nodes and curves; spans of `handle` point into it, so it stays where it is.
struct PlacedHandle {
    PlacedHandle(const SceneHandle& scene, const Bundle& bundle);
    PlacedHandle(const PlacedHandle&) = delete;
    PlacedHandle& operator=(const PlacedHandle&) = delete;

    std::vector<Index> nodes;
    std::vector<float> times;
    std::vector<Vec3f> shift, shift_slopes, turn, turn_slopes;
    solver::Handle handle;
};

}
