// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/material_space.h"

#include "mesh/watertight.h"

namespace crumple::relax {

MaterialSpace::MaterialSpace(const Shell& shell)
    : interior_(shell), surface_(shell.positions, shell.triangles), is_watertight_(is_watertight(shell.triangles)) {}

Spot MaterialSpace::look_at(Vec3 p) const {
    Spot spot{p, interior_.material_at(p), 0, none};
    const SurfaceDistance::Closest closest = surface_.closest(p);
    spot.clear = closest.distance;
    spot.nearest = closest.triangle;
    return spot;
}

Spot MaterialSpace::look_at(Vec3 p, const Spot& known) const {
    const SurfaceDistance::Closest closest = surface_.closest(p, known.nearest);
    const bool same = is_same(known, p, closest.distance);
    return {p, same ? known.material : interior_.material_at(p), closest.distance, closest.triangle};
}

Index MaterialSpace::material_at(Vec3 p, const Spot& known) const {
    if (is_same(known, p, 0)) return known.material;
    if (is_watertight_ && is_same(known, p, surface_.closest(p, known.nearest).distance)) return known.material;
    return interior_.material_at(p);
}

}
