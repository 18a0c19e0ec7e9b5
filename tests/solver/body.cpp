// SPDX-License-Identifier: MIT
#include "solver/body.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>

#include "bundle/exact_volume.h"
#include "bundle/matrix_pattern.h"

namespace crumple::solver::test {
namespace {

void fill_tet_numbers(Bundle& b) {
    b.mass.assign(b.rest_positions.size(), 0);
    std::vector<double> mass(b.rest_positions.size(), 0);
    for (const Tet& tet : b.tets) {
        const auto corner = [&](std::size_t i) { return b.rest_positions[tet[i]]; };
        const double volume = six_volumes(corner(0), corner(1), corner(2), corner(3)) / 6;
        const auto inverse = inverse_rest_matrix(corner(0), corner(1), corner(2), corner(3));
        std::array<float, 9> rounded;
        std::transform(inverse.begin(), inverse.end(), rounded.begin(), [](double x) { return static_cast<float>(x); });
        b.inverse_rest.push_back(rounded);
        b.volume.push_back(static_cast<float>(volume));
        for (const Index node : tet) mass[node] += b.materials[0].density_kg_m3 * volume / 4;
    }
    std::transform(mass.begin(), mass.end(), b.mass.begin(), [](double m) { return static_cast<float>(m); });
}

Index grid_node(Cells cells, int x, int y, int z) {
    return static_cast<Index>((x * (cells.y + 1) + y) * (cells.z + 1) + z);
}

void add_cube(std::vector<Tet>& tets, Cells cells, int x, int y, int z) {
    // Paths from corner 000 to corner 111 along the axes, one tet for each order of the axes.
    constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int o = 0; o < 6; ++o) {
        int at[3] = {x, y, z};
        Tet tet;
        tet[0] = grid_node(cells, at[0], at[1], at[2]);
        for (std::size_t i = 0; i < 3; ++i) {
            ++at[orders[o][i]];
            tet[i + 1] = grid_node(cells, at[0], at[1], at[2]);
        }
        if (o >= 3) std::swap(tet[1], tet[2]);  // odd orders are wound the other way
        tets.push_back(tet);
    }
}

}

Material elastic_material(double young_pa, double poisson) {
    Material m;
    m.young_pa = young_pa;
    m.poisson = poisson;
    m.yield_pa = 1e13;
    m.alpha_per_s = 0;
    m.beta_s = 0;
    return m;
}

Bundle bundle_of(std::vector<Vec3f> positions, std::vector<Tet> tets, const Material& material,
                 const std::function<bool(Vec3f)>& is_locked) {
    Bundle b;
    b.rest_positions = std::move(positions);
    b.locked.assign(b.rest_positions.size(), 0);
    for (std::size_t i = 0; is_locked && i < b.locked.size(); ++i) b.locked[i] = is_locked(b.rest_positions[i]);
    const auto fixed = std::stable_partition(tets.begin(), tets.end(), [&](const Tet& tet) {
        return !std::all_of(tet.begin(), tet.end(), [&](Index node) { return b.locked[node]; });
    });
    b.solver_tet_count = static_cast<std::uint32_t>(fixed - tets.begin());
    b.tets = std::move(tets);
    b.materials = {material};
    b.material.assign(b.tets.size(), 0);
    b.stiffness_scale.assign(b.tets.size(), 1);
    b.region.assign(b.tets.size(), 0);
    b.regions = {"body"};
    fill_tet_numbers(b);
    build_matrix_pattern(b);
    return b;
}

Bundle grid_body(Cells cells, Vec3f cell_size, const Material& material, const std::function<bool(Vec3f)>& is_locked) {
    std::vector<Vec3f> positions;
    for (int x = 0; x <= cells.x; ++x) {
        for (int y = 0; y <= cells.y; ++y) {
            for (int z = 0; z <= cells.z; ++z) {
                positions.push_back({static_cast<float>(x) * cell_size.x, static_cast<float>(y) * cell_size.y,
                                     static_cast<float>(z) * cell_size.z});
            }
        }
    }
    std::vector<Tet> tets;
    for (int x = 0; x < cells.x; ++x) {
        for (int y = 0; y < cells.y; ++y) {
            for (int z = 0; z < cells.z; ++z) add_cube(tets, cells, x, y, z);
        }
    }
    return bundle_of(std::move(positions), std::move(tets), material, is_locked);
}

Bundle with_shuffled_nodes(const Bundle& bundle, std::uint64_t seed) {
    std::vector<Index> place(bundle.rest_positions.size());
    std::iota(place.begin(), place.end(), 0u);
    Rng rng(seed);
    for (std::size_t i = place.size(); i > 1; --i) {
        std::swap(place[i - 1], place[rng.next_below(static_cast<std::uint32_t>(i))]);
    }
    std::vector<Vec3f> positions(place.size());
    std::vector<std::uint8_t> locked(place.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
        positions[place[i]] = bundle.rest_positions[i];
        locked[place[i]] = bundle.locked[i];
    }
    std::vector<Tet> tets = bundle.tets;
    for (Tet& tet : tets) {
        for (Index& node : tet) node = place[node];
    }
    Bundle b = bundle_of(std::move(positions), std::move(tets), bundle.materials[0]);
    b.locked = std::move(locked);
    return b;
}

void Body::Free::operator()(std::byte* p) const { ::operator delete[](p, std::align_val_t{64}); }

Body::Memory Body::allocate(std::size_t bytes) {
    return Memory(static_cast<std::byte*>(::operator new[](bytes, std::align_val_t{64})));
}

Body::Body(Bundle made, const Settings& s)
    : bundle(std::move(made)), settings(s), model_memory_(allocate(model_bytes(view_of(bundle)))), state_size_(0) {
    const BundleView view = view_of(bundle);
    if (const char* problem = first_problem(view)) throw std::runtime_error(problem);
    model = build_model(view, {model_memory_.get(), model_bytes(view)});
    state_size_ = state_bytes(model, settings.plasticity);
    state_memory_ = allocate(state_size_);
    workspace_memory_ = allocate(workspace_bytes(model));
    state = make_state(model, settings.plasticity, bytes());
    workspace = make_workspace(model, {workspace_memory_.get(), workspace_bytes(model)});
}

StepReport Body::step(const StepInput& input, const Jobs& jobs) {
    return solver::step(model, state, workspace, input, settings, jobs);
}

void Body::set_positions(const std::function<Vec3f(Vec3f)>& where) {
    std::vector<Vec3f> positions(node_count());
    std::transform(bundle.rest_positions.begin(), bundle.rest_positions.end(), positions.begin(), where);
    move_nodes(model, state, positions, bundle.rest_positions);
}

void Body::set_velocities(const std::function<Vec3f(Vec3f)>& how) {
    for (std::size_t i = 0; i < node_count(); ++i) set_velocity(state, i, how(rest(i)));
}

bool Body::is_finite() const {
    const auto are_finite = [](std::span<const float> values) {
        return std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); });
    };
    bool is_fine = are_finite(state.positions) && are_finite(state.velocities);
    for (const TetState& tet : state.tets) {
        for (const auto& row : tet.rotation) is_fine = is_fine && are_finite(row);
        for (const auto& row : tet.plastic) is_fine = is_fine && are_finite(row);
    }
    return is_fine;
}

double Body::smallest_determinant() const {
    double smallest = 1e30;
    for (std::size_t t = 0; t < model.tet_count; ++t) {
        smallest = std::min(smallest, static_cast<double>(determinant(deformation_gradient(model, state, t))));
    }
    return smallest;
}

bool is_whole(const Body& body) {
    for (std::size_t t = 0; t < body.model.tet_count; ++t) {
        const Mat3 f = deformation_gradient(body.model, body.state, t);
        if (!(determinant(f) > 0)) return false;
        const Mat3 r = rotation_svd_smallest(f, Mat3::identity());
        if (!(norm(transpose(r) * f - Mat3::identity()) < 0.1f)) return false;
    }
    return true;
}

Vec3f random_vector(Rng& rng) {
    const auto next = [&] { return static_cast<float>(2 * rng.next_unit() - 1); };
    const float x = next();
    const float y = next();
    return {x, y, next()};
}

Mat3 random_rotation(Rng& rng) {
    const Vec3f v = random_vector(rng);
    return to_matrix(to_quaternion(turn(v, 6.28 * rng.next_unit())));
}

Mat3 turn(Vec3f axis, double angle_rad) {
    const Vec3f n = axis / length(axis);
    const auto s = static_cast<float>(std::sin(angle_rad / 2));
    return to_matrix({n.x * s, n.y * s, n.z * s, static_cast<float>(std::cos(angle_rad / 2))});
}

}
