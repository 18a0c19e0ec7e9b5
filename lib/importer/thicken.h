// SPDX-License-Identifier: GPL-3.0-or-later
// Makes solids of single sheets: the sheet moved half a thickness to either side, closed along its rim.
#pragma once
#include "core/finding.h"
#include "importer/components.h"
#include "importer/surface.h"
#include "importer/weld.h"

namespace crumple::importer {

// Every component that is not closed is replaced; closed ones stay as they are, their vertices first and in order. Each
// vertex of a sheet becomes two, both with its lock, colour and source; where sheets meet along an edge of more than
// two triangles, or touch at a vertex, each gets its own, and their solids overlap; copies
// that come to lie on one place are one. The finding SHELL_THICKENED counts
// triangles; count 0: there was no sheet. Throws Error(usage) for a thickness that float cannot show there.
[[nodiscard]] Finding thicken_sheets(const Surface& surface, const Components& components, double thickness,
                                     Welded& shell);

}
