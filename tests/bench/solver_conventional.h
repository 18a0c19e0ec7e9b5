// SPDX-License-Identifier: GPL-3.0-or-later
// The solver a good games programmer writes today, as AMD's FEMFX does it: float, a singular value decomposition of
// eight elements at a time, K' = R K R^T of each element scattered through its slots into block rows, conjugate
// gradients with the diagonal blocks as preconditioner. Meant to be as quick as that design gets without new ideas.
#pragma once
#include <memory>
#include <span>

#include "bench/solver_naive.h"

namespace crumple::bench {

class Conventional {
public:
    // The bundle outlives it. Every step runs exactly so many iterations, from the velocities it is given.
    Conventional(const Bundle& bundle, int iterations);
    ~Conventional();
    // Velocities after one step from that motion: N x 4. Locked nodes stand.
    [[nodiscard]] std::span<const float> step(const Motion& from, float dt, float gravity_y);

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}
