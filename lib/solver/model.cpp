// SPDX-License-Identifier: MIT
#include "solver/model.h"

#include <algorithm>
#include <cmath>

#include "solver/arena.h"

namespace crumple::solver {
namespace {

struct Copies {
    std::span<Vec3f> rest_positions;
    std::span<float> mass;
    std::span<std::uint8_t> locked;
    std::span<Tet> tets;
    std::span<Index> edge_start;
};

struct Derived {
    Copies copies;
    std::span<TetPacket> packets;
    SliceArrays slices;
    std::span<Index> incidence;
    std::span<Index> node_start;
    std::span<Index> node_corner;
    std::span<float> alpha_mass;
    std::span<Index> locked_nodes;
    std::span<ModelMaterial> materials;
};

std::size_t count_locked(const BundleView& view) {
    return static_cast<std::size_t>(
        std::count_if(view.locked.begin(), view.locked.end(), [](std::uint8_t is_locked) { return is_locked != 0; }));
}

Derived take_arrays(const BundleView& view, Arena& arena) {
    const std::size_t tet_count = view.tets.size();
    const std::size_t node_count = view.rest_positions.size();
    const SliceCounts slices = count_slices(view);
    Derived d;
    d.slices.lane = arena.take<Index>(node_count);
    d.slices.node = arena.take<Index>(slice_rows * slices.slices);
    d.slices.start = arena.take<Index>(slices.slices + 1);
    d.slices.column = arena.take<Index>(slice_rows * slices.groups);
    d.slices.edge_block = arena.take<std::array<Index, 2>>(view.edges.size());
    d.packets = arena.take<TetPacket>((tet_count + packet_size - 1) / packet_size);
    d.incidence = arena.take<Index>(6 * tet_count);
    d.node_start = arena.take<Index>(node_count + 1);
    d.node_corner = arena.take<Index>(4 * tet_count);
    d.alpha_mass = arena.take<float>(node_count);
    d.locked_nodes = arena.take<Index>(count_locked(view));
    d.materials = arena.take<ModelMaterial>(view.materials.size());
    d.copies.rest_positions = arena.take<Vec3f>(node_count);
    d.copies.mass = arena.take<float>(node_count);
    d.copies.locked = arena.take<std::uint8_t>(node_count);
    d.copies.tets = arena.take<Tet>(tet_count);
    d.copies.edge_start = arena.take<Index>(view.edge_start.size());
    return d;
}

ModelArrays copy_arrays(const BundleView& view, const Copies& copies) {
    const auto copy = [](const auto& from, const auto& to) { std::copy(from.begin(), from.end(), to.begin()); };
    copy(view.rest_positions, copies.rest_positions);
    copy(view.mass, copies.mass);
    copy(view.locked, copies.locked);
    copy(view.tets, copies.tets);
    copy(view.edge_start, copies.edge_start);
    return {copies.rest_positions, copies.mass, copies.locked, copies.tets, copies.edge_start};
}

struct Lame {
    double mu;
    double ratio;  // lambda / mu
};

Lame lame_of(const Material& material, double scale) {
    return {material.young_pa * scale / (2 * (1 + material.poisson)),
            2 * material.poisson / (1 - 2 * material.poisson)};
}

void fill_lane(TetPacket& packet, std::size_t lane, const BundleView& view, std::size_t t, bool is_padding) {
    const Material& material = view.materials[view.material[t]];
    const Lame lame = lame_of(material, view.stiffness_scale[t]);
    for (std::size_t i = 0; i < 9; ++i) packet.gradient[i][lane] = view.inverse_rest[t][i];
    for (std::size_t i = 0; i < 4; ++i) packet.node[i][lane] = view.tets[t][i];
    packet.volume[lane] = view.volume[t];
    packet.stiffness[lane] = is_padding ? 0 : static_cast<float>(view.volume[t] * lame.mu);
    packet.ratio[lane] = static_cast<float>(lame.ratio);
    packet.beta_s[lane] = static_cast<float>(material.beta_s);
    // Padding never yields, or it would be counted.
    packet.yield_strain[lane] =
        is_padding ? 1e30f : static_cast<float>(std::sqrt(2.0 / 3) * material.yield_pa / (2 * lame.mu));
    packet.material[lane] = view.material[t];
}

void fill_packets(const BundleView& view, std::span<TetPacket> packets) {
    std::fill(packets.begin(), packets.end(), TetPacket{});
    for (std::size_t i = 0; i < packets.size() * packet_size; ++i) {
        const std::size_t t = std::min(i, view.tets.size() - 1);
        fill_lane(packets[i / packet_size], i % packet_size, view, t, i != t);
    }
}

void fill_node_corners(const BundleView& view, std::span<Index> start, std::span<Index> corners) {
    std::fill(start.begin(), start.end(), 0u);
    for (const Tet& tet : view.tets) {
        for (const Index node : tet) ++start[node + 1];
    }
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    // Filling moves each start to the next one's place; shifting back restores them.
    for (std::size_t t = 0; t < view.tets.size(); ++t) {
        for (std::size_t c = 0; c < 4; ++c) corners[start[view.tets[t][c]]++] = static_cast<Index>(4 * t + c);
    }
    for (std::size_t i = start.size() - 1; i > 0; --i) start[i] = start[i - 1];
    start[0] = 0;
}

// Whether some other tet around node `a` has all of a, b, c.
bool is_shared(const BundleView& view, const Derived& d, std::size_t tet, Index a, Index b, Index c) {
    for (Index k = d.node_start[a]; k < d.node_start[a + 1]; ++k) {
        const std::size_t other = d.node_corner[k] / 4;
        const Tet& nodes = view.tets[other];
        const auto has = [&](Index node) { return std::find(nodes.begin(), nodes.end(), node) != nodes.end(); };
        if (other != tet && has(b) && has(c)) return true;
    }
    return false;
}

void mark_boundary(const BundleView& view, const Derived& d) {
    for (std::size_t t = 0; t < view.tets.size(); ++t) {
        unsigned bits = 0;
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const Index face[3] = {view.tets[t][(corner + 1) % 4], view.tets[t][(corner + 2) % 4],
                                   view.tets[t][(corner + 3) % 4]};
            // Behind locked faces may be tets that are not simulated.
            if (std::all_of(face, face + 3, [&](Index node) { return view.locked[node]; })) continue;
            if (!is_shared(view, d, t, face[0], face[1], face[2])) bits |= 1u << corner;
        }
        d.packets[t / packet_size].boundary[t % packet_size] = static_cast<std::uint8_t>(bits);
    }
}

// Each node's mass comes in quarters from its tets; alpha is averaged in the same shares. Tets that are not simulated
// have no say: their nodes are locked.
void fill_alpha_mass(const BundleView& view, const Derived& d) {
    for (std::size_t node = 0; node < view.mass.size(); ++node) {
        double mass = 0;
        double damping = 0;
        for (Index k = d.node_start[node]; k < d.node_start[node + 1]; ++k) {
            const std::size_t t = d.node_corner[k] / 4;
            const Material& material = view.materials[view.material[t]];
            const double share = material.density_kg_m3 * view.volume[t];
            mass += share;
            damping += share * material.alpha_per_s;
        }
        d.alpha_mass[node] = mass > 0 ? static_cast<float>(damping / mass * view.mass[node]) : 0;
    }
}

void fill_locked_nodes(const BundleView& view, std::span<Index> nodes) {
    std::size_t count = 0;
    for (std::size_t node = 0; node < view.locked.size(); ++node) {
        if (view.locked[node]) nodes[count++] = static_cast<Index>(node);
    }
}

PointMasses rest_mass_of(const BundleView& view) {
    PointMasses masses;
    for (std::size_t node = 0; node < view.mass.size(); ++node) {
        masses.add(static_cast<double>(view.mass[node]), widen(view.rest_positions[node]));
    }
    return masses;
}

}

BundleView view_of(const Bundle& b) {
    const std::size_t count = b.solver_tet_count <= b.tets.size() ? b.solver_tet_count : 0;
    const auto first = [&](const auto& array) {
        return std::span(array.data(), std::min<std::size_t>(count, array.size()));
    };
    return {b.rest_positions,
            b.mass,
            b.locked,
            first(b.tets),
            first(b.inverse_rest),
            first(b.volume),
            first(b.stiffness_scale),
            first(b.material),
            b.materials,
            b.row_start,
            b.column,
            b.diagonal,
            b.edges,
            b.edge_slots,
            b.edge_start,
            b.edge_tet,
            b.edge_corners};
}

std::size_t model_bytes(const BundleView& view) {
    Arena arena;
    (void)take_arrays(view, arena);
    return arena.used();
}

Model build_model(const BundleView& view, std::span<std::byte> memory) {
    Arena arena(memory);
    const Derived d = take_arrays(view, arena);
    fill_slices(view, d.slices);
    fill_packets(view, d.packets);
    for (std::size_t k = 0; k < d.incidence.size(); ++k) {
        d.incidence[k] = 16 * view.edge_tet[k] + 4u * view.edge_corners[k][0] + view.edge_corners[k][1];
    }
    fill_node_corners(view, d.node_start, d.node_corner);
    mark_boundary(view, d);
    fill_alpha_mass(view, d);
    fill_locked_nodes(view, d.locked_nodes);
    std::transform(view.materials.begin(), view.materials.end(), d.materials.begin(), [](const Material& m) {
        return ModelMaterial{static_cast<float>(m.creep_per_s), static_cast<float>(m.hardening_pa),
                             static_cast<float>(m.max_plastic_strain)};
    });
    Model model;
    model.node_count = view.rest_positions.size();
    model.tet_count = view.tets.size();
    model.edge_count = view.edges.size();
    model.group_count = d.slices.column.size() / slice_rows;
    model.slices = {d.slices.lane, d.slices.node, d.slices.start, d.slices.column};
    model.edge_block = d.slices.edge_block;
    model.bundle = copy_arrays(view, d.copies);
    model.ratio = d.packets[0].ratio[0];
    model.is_uniform = std::all_of(d.packets.begin(), d.packets.end(), [&](const TetPacket& packet) {
        return std::all_of(std::begin(packet.ratio), std::end(packet.ratio), [&](float r) { return r == model.ratio; });
    });
    for (std::size_t t = 0; t < view.tets.size(); ++t) {
        const Lame lame = lame_of(view.materials[view.material[t]], view.stiffness_scale[t]);
        model.stiffness_volume += lame.mu * (lame.ratio + 2) * view.volume[t];
    }
    model.rest_mass = rest_mass_of(view);
    model.packets = d.packets;
    model.incidence = d.incidence;
    model.node_start = d.node_start;
    model.node_corner = d.node_corner;
    model.alpha_mass = d.alpha_mass;
    model.locked_nodes = d.locked_nodes;
    model.materials = d.materials;
    return model;
}

}
