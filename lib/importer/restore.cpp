// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/restore.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <unordered_map>

#include "core/error.h"
#include "formats/assimp_number.h"
#include "formats/color.h"
#include "importer/paint.h"

namespace crumple::importer {

namespace {

// Relative errors of a transform in floats: of a number that was only rounded, and of a rotation times a scale.
constexpr double copy_error = 0x1p-23;
constexpr double product_error = 1e-6;

// Every node is compared with every transform: beyond this the floats have to do.
constexpr std::size_t max_nodes_to_match = 2000;

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

[[noreturn]] void disagree(const std::string& about) {
    throw Error(ErrorKind::bad_input, "the reader makes something else of " + about +
                                          " than the file says; export it again with one vertex or face a line and "
                                          "plain numbers, or in another format");
}

// Each corner's vertex is found by the position assimp made of it; of equal positions the first serves for all.
void restore_vertex_list(formats::Prescan scan, Scene& scene) {
    std::unordered_map<Vec3f, Index, PositionHash> vertex_at;
    vertex_at.reserve(scan.assimp_positions.size());
    for (std::size_t v = 0; v < scan.assimp_positions.size(); ++v) {
        vertex_at.try_emplace(scan.assimp_positions[v], static_cast<Index>(v));
    }
    std::vector<std::vector<Index>> file_vertex(scene.meshes.size());
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        for (const Vec3f& p : scene.meshes[m].positions) {
            const auto found = vertex_at.find(p);
            if (found == vertex_at.end()) disagree("the vertices");
            file_vertex[m].push_back(found->second);
        }
    }
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        SceneMesh& mesh = scene.meshes[m];
        mesh.file_vertex = std::move(file_vertex[m]);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) mesh.positions[v] = scan.positions[mesh.file_vertex[v]];
    }
    scene.file_positions = std::move(scan.positions);
    scene.file_reds = std::move(scan.reds);
}

// The first vertex of which assimp delivered something else, or the number of vertices.
std::size_t first_difference(const formats::Prescan& scan, const SceneMesh& mesh) {
    const bool has_reds = !scan.reds.empty() && !mesh.colors.empty() && !mesh.colors[0].empty();
    for (std::size_t v = 0; v < scan.positions.size(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!formats::is_same_number(scan.positions[v][axis], mesh.positions[v][axis])) return v;
        }
        if (has_reds && formats::is_locked(scan.reds[v]) != formats::is_locked(mesh.colors[0][v][0])) return v;
    }
    return scan.positions.size();
}

void restore_numbers(formats::Prescan scan, SceneMesh& mesh) {
    if (scan.positions.size() != mesh.positions.size()) disagree("the number of vertices");
    if (!scan.reds.empty() && mesh.colors.empty()) disagree("the colours");
    const std::size_t vertex = first_difference(scan, mesh);
    if (vertex < scan.positions.size()) disagree("vertex " + std::to_string(vertex));
    mesh.positions = std::move(scan.positions);
}

// The nearest float of the one number of the file that assimp reads as `read`; where several are, one cannot tell.
float exact_of(const std::vector<formats::ReadNumber>& numbers, float read) {
    const auto less = [](const formats::ReadNumber& number, float value) { return number.read < value; };
    const auto first = std::lower_bound(numbers.begin(), numbers.end(), read, less);
    if (first == numbers.end() || first->read != read) return read;
    const auto next = std::next(first);
    const bool is_only = next == numbers.end() || next->read != read;
    return is_only && formats::is_same_number(first->exact, read) ? first->exact : read;
}

void restore_by_value(const std::vector<formats::ReadNumber>& numbers, Scene& scene) {
    for (SceneMesh& mesh : scene.meshes) {
        for (Vec3f& p : mesh.positions) {
            for (int axis = 0; axis < 3; ++axis) p[axis] = exact_of(numbers, p[axis]);
        }
    }
}

// How far b is from a, 1: as far as floats can have taken it. Translations are copied, the rest is a product of a few.
double difference(const formats::Affine& a, const formats::Affine& b) {
    double linear_scale = 0;
    double linear = 0;
    double translation = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double apart = std::fabs(a[i] - b[i]);
        if (i % 4 == 3) {
            translation = std::fmax(translation, apart == 0 ? 0 : apart / (copy_error * std::fabs(a[i])));
        } else {
            linear = std::fmax(linear, apart);
            linear_scale = std::fmax(linear_scale, std::fabs(a[i]));
        }
    }
    return std::fmax(translation, linear == 0 ? 0 : linear / (product_error * linear_scale));
}

// Each node takes the nearest of the file's transforms, if that is what assimp's floats can have come from.
void restore_transforms(const std::vector<formats::Affine>& transforms, Scene& scene) {
    if (transforms.size() > max_nodes_to_match) return;
    for (SceneNode& node : scene.nodes) {
        const formats::Affine read = node.transform;
        double nearest = 1;
        for (const formats::Affine& exact : transforms) {
            if (difference(exact, read) >= nearest) continue;
            nearest = difference(exact, read);
            node.transform = exact;
        }
    }
}

}

void restore(formats::Prescan scan, Scene& scene) {
    restore_by_value(scan.numbers, scene);
    restore_transforms(scan.transforms, scene);
    if (!scan.assimp_positions.empty()) {
        restore_vertex_list(std::move(scan), scene);
    } else if (!scan.positions.empty() && scene.meshes.size() == 1) {
        restore_numbers(std::move(scan), scene.meshes[0]);
    }
}

}
