// SPDX-License-Identifier: GPL-3.0-or-later
// The artist's control shell: closed surfaces in one vertex array. V vertices, F triangles, C connected components.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/fields.h"
#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

// What the space inside a component is.
enum class Role {
    solid,   // deformable material
    cavity,  // empty space inside a solid: a cabin
    rigid,   // material that keeps its shape: an engine block, usually fully locked
};
inline constexpr EnumName<Role> role_names[] = {{Role::solid, "solid"}, {Role::cavity, "cavity"}, {Role::rigid, "rigid"}};
constexpr std::span<const EnumName<Role>> enum_names(Role) { return role_names; }

// A connected component of the surface (connected by shared vertices after welding).
struct Component {
    std::string name;         // node, mesh or group name of the source file; unique within the shell
    std::string material;     // material name of the source file, may be empty
    Role role = Role::solid;
    std::string role_reason;  // "recipe", "winding: closed and wound inwards inside 'body'", ...
    double volume = 0;        // cubic metres enclosed, always >= 0 for a closed component
    bool is_closed = false;
    bool is_inward = false;   // wound inwards in the source
    Index parent = none;      // the innermost component that contains it
};

struct Shell {
    std::vector<Vec3> positions;             // V, float-representable
    std::vector<Triangle> triangles;         // F, counter-clockwise from outside the material of a solid
    std::vector<std::array<float, 4>> color; // V or empty: linear RGBA; the first copy's where copies were welded
    std::vector<std::uint8_t> locked;        // V: 1 where any welded copy is painted red 0
    std::vector<Index> source_vertex;        // V: the first vertex of the source file welded into this one
    std::vector<Index> component;            // F: which component a triangle belongs to
    std::vector<Component> components;       // C
};

}
