// SPDX-License-Identifier: GPL-3.0-or-later
// A tet mesh as the text of other programs' files, or the whole bundle as the bytes of a blob: `crumple export`.
#pragma once
#include <string>

#include "core/fields.h"
#include "pipeline/workspace.h"

namespace crumple::pipeline {

enum class ExportFormat { vtu, msh, obj, blob };
inline constexpr EnumName<ExportFormat> export_format_names[] = {
    {ExportFormat::vtu, "vtu"}, {ExportFormat::msh, "msh"}, {ExportFormat::obj, "obj"}, {ExportFormat::blob, "blob"}};
constexpr std::span<const EnumName<ExportFormat>> enum_names(ExportFormat) { return export_format_names; }

// The bundle; where there is none, the tets and locks of the work so far in the form of one, without masses and matrix:
// good for looking at, not valid. Throws Error(usage) when there is neither.
[[nodiscard]] Bundle visible_bundle(const Workspace& workspace);

// Same mesh, same bytes.
[[nodiscard]] std::string export_mesh(const Bundle& bundle, ExportFormat format);

// What the work has come to: the bundle, else the tets, else (OBJ only) the shell as imported, with its locks. A blob
// wants the bundle, and a valid one. Throws Error(usage) when the work has not come so far.
[[nodiscard]] std::string export_work(const Workspace& workspace, ExportFormat format);

}
