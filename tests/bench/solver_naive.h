// SPDX-License-Identifier: GPL-3.0-or-later
// The first solver anyone writes: double, Eigen's JacobiSVD, R K R^T as products of 12 x 12 matrices, triplets, Eigen's
// conjugate gradients.
#pragma once
#include <memory>
#include <span>

#include "bundle/bundle.h"
#include "core/vec3.h"

namespace crumple::bench {

struct Motion {
    std::span<const float> positions;   // N x 4
    std::span<const float> velocities;  // N x 4
};

class Naive {
public:
    // The bundle outlives it. Every step runs exactly so many iterations, from the velocities it is given.
    Naive(const Bundle& bundle, int iterations);
    ~Naive();
    // Velocities after one step from that motion: N x 3.
    [[nodiscard]] std::span<const double> step(const Motion& from, double dt, double gravity_y);

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}
