// SPDX-License-Identifier: GPL-3.0-or-later
// A tet mesh as the text of other programs' files. Same mesh, same bytes.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/fields.h"
#include "core/index.h"
#include "core/vec3.h"
#include "pipeline/workspace.h"

namespace crumple::pipeline {

enum class ExportFormat { vtu, msh, obj };
inline constexpr EnumName<ExportFormat> export_format_names[] = {
    {ExportFormat::vtu, "vtu"}, {ExportFormat::msh, "msh"}, {ExportFormat::obj, "obj"}};
constexpr std::span<const EnumName<ExportFormat>> enum_names(ExportFormat) { return export_format_names; }

// N nodes, T tets; the optional arrays are empty where the source has none.
struct ExportMesh {
    std::vector<Vec3> positions;
    std::vector<Tet> tets;
    std::vector<std::uint8_t> locked;     // N
    std::vector<float> mass;              // N
    std::vector<Index> region;            // T
    std::vector<std::uint16_t> material;  // T
    std::vector<std::string> regions;     // names
};

// From the bundle, else from the tets of a work file. Throws Error(bad_input) when there are neither.
[[nodiscard]] ExportMesh export_mesh(const Workspace& workspace);

// vtu: VTK unstructured grid with every array; msh: gmsh 2.2, regions as physical groups, locks as node data;
// obj: the boundary, counter-clockwise from outside, locks as vertex colours that import reads back (red 0 is locked).
[[nodiscard]] std::string write_mesh(const ExportMesh& mesh, ExportFormat format);

}
