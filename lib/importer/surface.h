// SPDX-License-Identifier: GPL-3.0-or-later
// All mesh instances of a scene placed in our space: metres, Y up, mirrored instances turned right side out again.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec3.h"
#include "importer/scene.h"

namespace crumple::importer {

// What an artist would call one thing: a node of the file with its meshes.
struct Object {
    std::string name;
};

// The triangles of one mesh of an object.
struct Part {
    Index object = 0;
    std::string mesh;
    std::string material;
    bool has_color = false;  // in the chosen set
};

// V vertices as the file splits them, F triangles.
struct Surface {
    std::vector<Vec3> positions;       // V, float-representable, no -0
    std::vector<Index> source_vertex;  // V: number in the file
    std::vector<Index> vertex_part;    // V
    std::vector<Color> colors;         // V or empty: the chosen set as stored, where the part has_color
    std::vector<Triangle> triangles;   // F
    std::vector<Index> part;           // F
    std::vector<Part> parts;
    std::vector<Object> objects;
    std::uint64_t source_vertex_count = 0;  // vertices the file has, used or not
    bool has_vertex_list = false;           // source_vertex numbers a list of the file (OBJ), not the order above
};

struct Placement {
    double unit = 1;  // metres per unit of the file, as applied
    Up up = Up::y;
    std::array<double, 9> axes{};
};

// What params ask for, else what the file says, else metres and Y up.
[[nodiscard]] Placement placement_of(const Scene& scene, const Params& params);

// Expands instances. fallback_name serves objects the file does not name.
// Throws Error(bad_input) when a coordinate leaves the range of float, or instances multiply beyond params.memory_mb.
[[nodiscard]] Surface flatten(const Scene& scene, const Placement& placement, const Params& params,
                              const std::string& fallback_name);

// The file's vertex list placed likewise; empty where the format has none. REQUIRES: as flatten.
[[nodiscard]] std::vector<Vec3> place_vertex_list(const Scene& scene, const Placement& placement);

}
