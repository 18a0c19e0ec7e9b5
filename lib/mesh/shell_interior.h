// SPDX-License-Identifier: GPL-3.0-or-later
// Which material fills a point: asks the winding number of every component and lets the innermost one decide.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "mesh/shell.h"

namespace crumple {

class ShellInterior {
public:
    explicit ShellInterior(const Shell& shell);
    ~ShellInterior();

    // The component whose role decides at p: the one of least volume whose |winding number| at p exceeds 0.5 by more
    // than rounding, so that a point on a surface is outside it; `except` is not asked. none outside every component.
    [[nodiscard]] Index innermost(Vec3 p, Index except = none) const;

    // Like innermost, but none where that component is a cavity: the component whose material fills p.
    [[nodiscard]] Index material_at(Vec3 p) const;

    // |winding number| of one component at p.
    [[nodiscard]] double winding(Index component, Vec3 p) const;

    // The largest |winding number| at p of any component that has material, within 0.01. Components farther away than
    // half their own size do not count: an open sheet seen from there covers less than 0.15 of the sphere.
    [[nodiscard]] double material_winding(Vec3 p) const;

    // Whether p lies on a triangle of any component, exactly.
    [[nodiscard]] bool is_on_surface(Vec3 p) const;

    // Every component, least volume first: the order in which they decide. And the place of one in that order.
    [[nodiscard]] std::span<const Index> by_volume() const;
    [[nodiscard]] Index rank(Index component) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}
