// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace crumple::importer {

namespace {

formats::Affine compose(const formats::Affine& outer, const formats::Affine& inner) {
    formats::Affine result{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            double sum = column == 3 ? outer[4 * row + 3] : 0;
            for (std::size_t k = 0; k < 3; ++k) sum += outer[4 * row + k] * inner[4 * k + column];
            result[4 * row + column] = sum;
        }
    }
    return result;
}

double determinant(const formats::Affine& m) {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
           m[2] * (m[4] * m[9] - m[5] * m[8]);
}

formats::Affine affine_of(const Placement& placement) {
    formats::Affine result{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            result[4 * row + column] = placement.axes[3 * row + column] * placement.unit;
        }
    }
    return result;
}

Vec3 apply(const formats::Affine& m, Vec3f p) {
    return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
            m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
}

Vec3 place(const formats::Affine& transform, Vec3f p) {
    const Vec3 placed = apply(transform, p);
    constexpr double most = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::fabs(placed[axis]) <= most)) {
            throw Error(ErrorKind::bad_input,
                        "a vertex is too far away for a float once the unit and transforms are applied");
        }
    }
    const Vec3 rounded = round_to_float(placed);
    return {rounded.x + 0.0, rounded.y + 0.0, rounded.z + 0.0};  // -0 becomes 0
}

// Names assimp makes up where the file has none.
bool is_made_up(const std::string& name) {
    for (const char* made_up :
         {"", "defaultobject", "ROOT", "RootNode", "DXCC_ROOT", "<STL_BINARY>", "<STL_ASCII>", "<OFFRoot>"}) {
        if (name == made_up) return true;
    }
    return name.starts_with("nodes[") || name.starts_with("meshes[");
}

std::string object_name(const SceneNode& node, const Scene& scene, const std::string& fallback) {
    if (!is_made_up(node.name)) return node.name;
    const std::string& mesh = scene.meshes[node.meshes.front()].name;
    return is_made_up(mesh) ? fallback : mesh;
}

// Roughly what a vertex or triangle costs from here to the finished shell.
constexpr std::uint64_t bytes_an_element = 256;

void check_size(const Scene& scene, const Params& params) {
    const std::uint64_t most =
        std::min<std::uint64_t>(none - 1, (std::uint64_t{params.memory_mb} << 20) / bytes_an_element);
    std::uint64_t elements = scene.file_positions.size();
    for (const SceneNode& node : scene.nodes) {
        for (const Index m : node.meshes) {
            elements += 1 + scene.meshes[m].positions.size() + scene.meshes[m].triangles.size();
            if (elements <= most) continue;
            throw Error(ErrorKind::bad_input, "its instances come to more than " + std::to_string(most) +
                                                  " vertices and triangles (import.memory_mb raises the limit)");
        }
    }
}

std::vector<Index> first_vertices(const Scene& scene) {
    std::vector<Index> first;
    Index next = 0;
    for (const SceneMesh& mesh : scene.meshes) {
        first.push_back(next);
        next += static_cast<Index>(mesh.positions.size());
    }
    first.push_back(next);
    return first;
}

bool has_color(const SceneMesh& mesh, std::uint32_t set) {
    return set < mesh.colors.size() && !mesh.colors[set].empty();
}

void add_instance(const SceneMesh& mesh, Index first_source, const formats::Affine& transform, std::uint32_t color_set,
                  Surface& surface) {
    const auto base = static_cast<Index>(surface.positions.size());
    const auto part = static_cast<Index>(surface.parts.size() - 1);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        surface.positions.push_back(place(transform, mesh.positions[v]));
        surface.source_vertex.push_back(surface.has_vertex_list ? mesh.file_vertex[v]
                                                                : first_source + static_cast<Index>(v));
    }
    if (has_color(mesh, color_set)) {
        surface.colors.resize(base, {1, 1, 1, 1});
        surface.colors.insert(surface.colors.end(), mesh.colors[color_set].begin(), mesh.colors[color_set].end());
    }
    surface.vertex_part.resize(surface.positions.size(), part);
    const bool is_mirrored = determinant(transform) < 0;
    for (const Triangle& t : mesh.triangles) {
        surface.triangles.push_back(is_mirrored ? Triangle{base + t[0], base + t[2], base + t[1]}
                                                : Triangle{base + t[0], base + t[1], base + t[2]});
    }
    surface.part.resize(surface.triangles.size(), part);
}

}

Placement placement_of(const Scene& scene, const Params& params) {
    Placement placement;
    placement.unit = params.unit > 0 ? params.unit : scene.unit > 0 ? scene.unit : 1;
    placement.up = params.up != Up::automatic ? params.up : scene.up != Up::automatic ? scene.up : Up::y;
    placement.axes = params.up != Up::automatic ? axes_of(params.up) : scene.axes;
    return placement;
}

Surface flatten(const Scene& scene, const Placement& placement, const Params& params,
                const std::string& fallback_name) {
    check_size(scene, params);
    const std::vector<Index> first_source = first_vertices(scene);
    const formats::Affine file_to_ours = affine_of(placement);
    Surface surface;
    surface.has_vertex_list = !scene.file_positions.empty();
    surface.source_vertex_count = surface.has_vertex_list ? scene.file_positions.size() : first_source.back();
    std::vector<formats::Affine> to_file(scene.nodes.size());
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        const SceneNode& node = scene.nodes[n];
        to_file[n] = node.parent == none ? node.transform : compose(to_file[node.parent], node.transform);
        if (node.meshes.empty()) continue;
        surface.objects.push_back({object_name(node, scene, fallback_name)});
        const formats::Affine transform = compose(file_to_ours, to_file[n]);
        for (const Index m : node.meshes) {
            const SceneMesh& mesh = scene.meshes[m];
            const std::string material = mesh.material == "DefaultMaterial" ? "" : mesh.material;
            surface.parts.push_back({static_cast<Index>(surface.objects.size() - 1), mesh.name, material,
                                     has_color(mesh, params.color_set)});
            add_instance(mesh, first_source[m], transform, params.color_set, surface);
        }
    }
    if (!surface.colors.empty()) surface.colors.resize(surface.positions.size(), {1, 1, 1, 1});
    return surface;
}

std::vector<Vec3> place_vertex_list(const Scene& scene, const Placement& placement) {
    const formats::Affine transform = affine_of(placement);
    std::vector<Vec3> positions;
    positions.reserve(scene.file_positions.size());
    for (const Vec3f& p : scene.file_positions) positions.push_back(place(transform, p));
    return positions;
}

}
