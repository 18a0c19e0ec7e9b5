// SPDX-License-Identifier: GPL-3.0-or-later
// The last resort where no exchange of tets frees a segment or a facet: a node on it (a Steiner point), which splits it
// in parts that are easier to free. Once all parts are there the node leaves again, last one first: on each side of the
// facets that meet at it, its tets are filled anew, from a node that is there or from a new one inside [George,
// Borouchaki, Saltel 2003, "Ultimate robustness in meshing an arbitrary polyhedron"]. So it usually ends as an interior
// node, or as none, and the shell stays as it was.
#pragma once
#include <span>
#include <vector>

#include "core/index.h"
#include "mesh/tet_complex.h"
#include "recover/constraints.h"
#include "recover/crossings.h"

namespace crumple::recover {

struct Split {
    Index node = none;
    Index a = none;  // the segment (a, b), or the facet (a, b, c)
    Index b = none;
    Index c = none;
    std::vector<Index> apexes;   // of the facets at the segment
    std::vector<Index> origins;  // of those, the shell triangles
};

// Makes parts of what a node lies on. The node may be one that was there before.
Split split_segment(Constraints& constraints, Index a, Index b, Index node);
Split split_facet(Constraints& constraints, const Triangle& facet, Index node);

// Takes a split's node out again and makes its parts whole. On false nothing has changed.
bool undo_split(TetComplex& complex, Constraints& constraints, const Split& split);

// Takes the node out though parts are missing, and the whole with them. On false nothing has changed.
bool drop_split(TetComplex& complex, Constraints& constraints, const Split& split);

}
