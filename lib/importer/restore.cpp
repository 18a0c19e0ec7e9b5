// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/restore.h"

#include <bit>
#include <cmath>
#include <unordered_map>

namespace crumple::importer {

namespace {

// assimp multiplies by powf(10, exponent) in float: a few ulp off, never more than this.
constexpr float assimp_error = 1e-5f;

struct PositionHash {
    std::size_t operator()(const Vec3f& p) const {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis) {
            // + 0 turns -0 into 0, which it equals.
            hash = (hash ^ std::bit_cast<std::uint32_t>(p[axis] + 0.0f)) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 32;
        }
        return static_cast<std::size_t>(hash);
    }
};

// Each corner's vertex is found by the position assimp made of it; of equal positions the first serves for all.
void restore_vertex_list(Prescan scan, Scene& scene) {
    std::unordered_map<Vec3f, Index, PositionHash> vertex_at;
    vertex_at.reserve(scan.assimp_positions.size());
    for (std::size_t v = 0; v < scan.assimp_positions.size(); ++v) {
        vertex_at.try_emplace(scan.assimp_positions[v], static_cast<Index>(v));
    }
    std::vector<std::vector<Index>> file_vertex(scene.meshes.size());
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        for (const Vec3f& p : scene.meshes[m].positions) {
            const auto found = vertex_at.find(p);
            if (found == vertex_at.end()) return;
            file_vertex[m].push_back(found->second);
        }
    }
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        SceneMesh& mesh = scene.meshes[m];
        mesh.file_vertex = std::move(file_vertex[m]);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) mesh.positions[v] = scan.positions[mesh.file_vertex[v]];
    }
    scene.file_positions = std::move(scan.positions);
}

bool is_same_number(float exact, float read) {
    return exact == read || std::fabs(exact - read) <= assimp_error * std::fabs(exact);
}

void restore_numbers(const std::vector<Vec3f>& exact, std::vector<Vec3f>& positions) {
    if (exact.size() != positions.size()) return;
    for (std::size_t v = 0; v < exact.size(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!is_same_number(exact[v][axis], positions[v][axis])) return;
        }
    }
    positions = exact;
}

}

void restore(Prescan scan, Scene& scene) {
    if (!scan.assimp_positions.empty()) {
        restore_vertex_list(std::move(scan), scene);
    } else if (!scan.positions.empty() && scene.meshes.size() == 1) {
        restore_numbers(scan.positions, scene.meshes[0].positions);
    }
}

}
