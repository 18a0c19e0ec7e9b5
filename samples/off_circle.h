// SPDX-License-Identifier: MIT
// Keeps neighbouring triangles of a control shell from sharing a circle.
#pragma once
#include "samples/model.h"

namespace crumple::samples {

// Where two triangles that meet in an edge lie almost in a plane and their four corners almost on a circle, a Delaunay
// tetrahedralization may fill the place with a flat tet that no later stage can mend. This takes the shorter diagonal,
// then moves such corners a little, within the plane of their triangles, until the diagonal is clearly the short way.
// REQUIRES: closed and 2-manifold.
void move_off_circles(Part& part);

}
