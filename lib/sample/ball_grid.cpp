// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/ball_grid.h"

#include <algorithm>
#include <cmath>

namespace crumple::sample {

namespace {

std::uint64_t mixed(std::uint64_t x) {
    // The finishing steps of splitmix64 [Steele, Lea, Flood 2014].
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::uint64_t as_bits(std::int32_t x) { return static_cast<std::uint32_t>(x); }

}

BallGrid::Cell BallGrid::cell_at(Vec3 p, int level) const {
    const Vec3 from_origin = p - origin_;
    Cell cell;
    cell.level = level;
    for (int axis = 0; axis < 3; ++axis) {
        // The clamp only matters to places outside everything inserted, which then share the outermost cells.
        const double index = std::floor(std::ldexp(from_origin[axis], -level));
        cell.at[static_cast<std::size_t>(axis)] =
            static_cast<std::int32_t>(std::clamp(index, -2147483647.0, 2147483646.0));
    }
    return cell;
}

std::size_t BallGrid::slot_of(const Cell& cell) const {
    const std::uint64_t hash = mixed(mixed((as_bits(cell.at[0]) << 32 | as_bits(cell.at[1])) + 0x9e3779b97f4a7c15u) +
                                     (as_bits(cell.at[2]) << 32 | as_bits(cell.level)));
    std::size_t slot = hash & (table_.size() - 1);
    while (table_[slot].first != none && table_[slot].cell != cell) slot = (slot + 1) & (table_.size() - 1);
    return slot;
}

void BallGrid::grow() {
    std::vector<Slot> old(table_.size() * 2);
    old.swap(table_);
    for (const Slot& slot : old) {
        if (slot.first != none) table_[slot_of(slot.cell)] = slot;
    }
}

void BallGrid::add(const Cell& cell, Index ball) {
    if (2 * (used_slots_ + 1) > table_.size()) grow();
    Slot& slot = table_[slot_of(cell)];
    if (slot.first == none) ++used_slots_;
    entries_.push_back({ball, slot.first});
    slot.cell = cell;
    slot.first = static_cast<Index>(entries_.size() - 1);
}

void BallGrid::insert(Index ball, Vec3 centre, double radius) {
    const int level = std::ilogb(radius) + 1;  // radius < 2^level <= 2 radius: two or three cells an axis
    if (std::find(levels_.begin(), levels_.end(), level) == levels_.end()) levels_.push_back(level);
    const Cell low = cell_at(centre - Vec3{radius, radius, radius}, level);
    const Cell high = cell_at(centre + Vec3{radius, radius, radius}, level);
    Cell cell;
    cell.level = level;
    for (cell.at[0] = low.at[0]; cell.at[0] <= high.at[0]; ++cell.at[0]) {
        for (cell.at[1] = low.at[1]; cell.at[1] <= high.at[1]; ++cell.at[1]) {
            for (cell.at[2] = low.at[2]; cell.at[2] <= high.at[2]; ++cell.at[2]) add(cell, ball);
        }
    }
}

}
