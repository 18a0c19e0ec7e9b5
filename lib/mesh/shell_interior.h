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
    // than rounding, so that a point on a surface is outside it. none outside every component.
    [[nodiscard]] Index innermost(Vec3 p) const;

    // Like innermost, but none where that component is a cavity: the component whose material fills p.
    [[nodiscard]] Index material_at(Vec3 p) const;

    // |winding number| of one component at p.
    [[nodiscard]] double winding(Index component, Vec3 p) const;

    // Every component, least volume first: the order in which they decide.
    [[nodiscard]] std::span<const Index> by_volume() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}
