// SPDX-License-Identifier: MIT
// Bodies to simulate, made in code, and everything one of them needs to step.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "bundle/bundle.h"
#include "core/random.h"
#include "solver/measure.h"
#include "solver/step.h"

namespace crumple::solver::test {

// E = 1e5, nu = .3, rho = 1000, no damping, no yield.
[[nodiscard]] Material elastic_material(double young_pa = 1e5, double poisson = 0.3);

// The solver's half of what bake does. Tets must be positive.
[[nodiscard]] Bundle bundle_of(std::vector<Vec3f> positions, std::vector<Tet> tets, const Material& material,
                               const std::function<bool(Vec3f)>& is_locked = {});

// cells.x x cells.y x cells.z cubes of the given size, six tets each around the cube's long diagonal, from the origin.
struct Cells {
    int x, y, z;
};
[[nodiscard]] Bundle grid_body(Cells cells, Vec3f cell_size, const Material& material,
                               const std::function<bool(Vec3f)>& is_locked = {});

// The same body with its nodes renumbered at random.
[[nodiscard]] Bundle with_shuffled_nodes(const Bundle& bundle, std::uint64_t seed);

// Owns a bundle, its model, a state and a workspace.
class Body {
public:
    explicit Body(Bundle bundle, const Settings& settings = {});

    StepReport step(const StepInput& input, const Jobs& jobs = {});
    StepReport step(float dt) {
        StepInput input;
        input.dt = dt;
        return step(input);
    }
    // The bytes that save the state.
    [[nodiscard]] std::span<std::byte> bytes() { return {state_memory_.get(), state_size_}; }

    [[nodiscard]] Vec3f x(std::size_t node) const { return position(state, node); }
    [[nodiscard]] Vec3f rest(std::size_t node) const { return bundle.rest_positions[node]; }
    [[nodiscard]] std::size_t node_count() const { return model.node_count; }
    void set_positions(const std::function<Vec3f(Vec3f rest)>& where);
    void set_velocities(const std::function<Vec3f(Vec3f rest)>& how);
    [[nodiscard]] bool is_finite() const;
    [[nodiscard]] double smallest_determinant() const;

    Bundle bundle;
    Settings settings;
    Model model;
    State state;
    Workspace workspace;

private:
    struct Free {
        void operator()(std::byte* p) const;
    };
    using Memory = std::unique_ptr<std::byte[], Free>;
    static Memory allocate(std::size_t bytes);
    Memory model_memory_;
    std::size_t state_size_;
    Memory state_memory_;
    Memory workspace_memory_;
};

// All det F > 0 and |R^T F - I| < .1: every tet is near its rest shape, on its right side.
[[nodiscard]] bool is_whole(const Body& body);

// Uniform in [-1, 1)^3.
[[nodiscard]] Vec3f random_vector(Rng& rng);
[[nodiscard]] Mat3 random_rotation(Rng& rng);
[[nodiscard]] Mat3 turn(Vec3f axis, double angle_rad);

}
