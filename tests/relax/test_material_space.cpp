// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/material_space.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "mesh/shapes.h"

using namespace crumple;
using namespace crumple::relax;

namespace {

void expect_shortcuts_agree(const Shell& shell, Vec3 low, Vec3 high) {
    const MaterialSpace space(shell);
    const ShellInterior truth(shell);
    Rng rng(51);
    const auto place = [&] {
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis) p[axis] = low[axis] + rng.next_unit() * (high[axis] - low[axis]);
        return p;
    };
    for (int i = 0; i < 2000; ++i) {
        const Spot spot = space.look_at(place());
        EXPECT_EQ(spot.material, truth.material_at(spot.position));
        const Vec3 other = i % 2 == 0 ? place() : spot.position + (place() - spot.position) * 0.1;
        EXPECT_EQ(space.look_at(other, spot).material, truth.material_at(other));
        EXPECT_EQ(space.material_at(other, spot), truth.material_at(other));
    }
}

TEST(MaterialSpace, ShortcutsAgreeWithTheWindingNumberInNestedBoxes) {
    expect_shortcuts_agree(shapes::nested_boxes(Role::cavity), {-1, -1, -1}, {4, 4, 4});
    expect_shortcuts_agree(shapes::nested_boxes(Role::rigid), {-1, -1, -1}, {4, 4, 4});
}

TEST(MaterialSpace, ShortcutsAgreeWithTheWindingNumberInATorus) {
    expect_shortcuts_agree(shapes::torus(), {-2, -1, -2}, {2, 1, 2});
}

TEST(MaterialSpace, NothingIsInferredWhereTheShellIsOpen) {
    // Through the hole, inside becomes outside without a surface between.
    Shell shell = shapes::box();
    shell.triangles.resize(8);
    shell.component.resize(8);
    expect_shortcuts_agree(shell, {-1, -1, -1}, {2, 2, 2});
}

TEST(MaterialSpace, TellsTheDistanceToTheShell) {
    const MaterialSpace space(shapes::box());
    EXPECT_DOUBLE_EQ(space.look_at({0.5, 0.25, 0.5}).clear, 0.25);
    EXPECT_DOUBLE_EQ(space.look_at({3, 0.5, 0.5}).clear, 2);
    EXPECT_EQ(space.look_at({3, 0.5, 0.5}).material, none);
}

}
